"""Make a virtual environment that holds the ROS wheels an underlay, like /opt/ros/jazzy."""

from pathlib import Path
from shlex import quote
import sys
import sysconfig

WHEELS = Path(__file__).resolve().parent
PROFILES = WHEELS.parent / 'src' / 'socialnav' / 'config' / 'fast_discovery.xml'
DEFAULTS_FILE = 'colcon_defaults.yaml'

SETUP = """\
# Written by ros_ws/wheels/install_setup_files.py: ROS 2 Jazzy from wheels, for sh, bash and zsh.
# Paths are absolute: run that file again after moving the environment.

# first argument: the variable, second: the folder to put in front unless it is in there
_socialnav_prepend() {{
  eval "_socialnav_value=\\${{$1:-}}"
  case ":$_socialnav_value:" in
    *":$2:"*) ;;
    *) export "$1=$2${{_socialnav_value:+:$_socialnav_value}}" ;;
  esac
  unset _socialnav_value
}}

{prepend}

unset -f _socialnav_prepend
# With the variables above, Python need not start itself a second time to find the libraries.
export _ROS_WHEELS_BOOTSTRAP_COMPLETE=1
export COLCON_DEFAULTS_FILE={defaults}
# Nodes find each other at once, not after seconds, if both announce themselves often.
[ -n "${{FASTRTPS_DEFAULT_PROFILES_FILE:-}}" ] ||
  export FASTRTPS_DEFAULT_PROFILES_FILE={profiles}
"""

DEFAULTS = """\
# Written by ros_ws/wheels/install_setup_files.py: what every build against the ROS wheels needs.
# colcon adds what the colcon_defaults.yaml of the folder says that it is started in.
build:
  cmake-args:
    - '-DCMAKE_PROJECT_INCLUDE={wheels}/drop_missing_includes.cmake'
    - '-DPython3_EXECUTABLE={environment}/bin/python'
"""

ROS2 = """\
#!/bin/sh
# Written by ros_ws/wheels/install_setup_files.py: the small ros2, where ros2cli cannot be had.
exec {python} {wheels}/ros2.py "$@"
"""


def search_paths(environment: Path, site_packages: Path) -> list[tuple[str, Path]]:
    """Return (variable, folder) pairs; the last folder of a variable is searched first."""
    libraries = [*sorted(site_packages.glob('ros_*.libs')), environment / 'lib']
    return [
        ('AMENT_PREFIX_PATH', environment),
        ('CMAKE_PREFIX_PATH', environment),
        ('PATH', environment / 'bin'),
        *(('LD_LIBRARY_PATH', folder) for folder in libraries),
    ]


def setup_script(environment: Path, site_packages: Path) -> str:
    """Return the text of the script that is sourced."""
    pairs = search_paths(environment, site_packages)
    prepend = '\n'.join(f'_socialnav_prepend {name} {quote(str(path))}' for name, path in pairs)
    defaults = quote(f'{environment}/{DEFAULTS_FILE}')
    return SETUP.format(prepend=prepend, defaults=defaults, profiles=quote(str(PROFILES)))


def install(environment: Path) -> None:
    """
    Write the set-up files, colcon's defaults and the small ros2.

    :param environment: folder of the virtual environment; its Python runs this.
    """
    script = setup_script(environment, Path(sysconfig.get_path('purelib')))
    for shell in ('sh', 'bash', 'zsh'):
        (environment / f'setup.{shell}').write_text(script)
        (environment / f'local_setup.{shell}').write_text(script)
    defaults = DEFAULTS.format(environment=environment, wheels=WHEELS)
    (environment / DEFAULTS_FILE).write_text(defaults)
    python, wheels = quote(f'{environment}/bin/python'), quote(str(WHEELS))
    command = environment / 'bin' / 'ros2'
    command.write_text(ROS2.format(python=python, wheels=wheels))
    command.chmod(0o755)


def main() -> str | None:
    """Install into the environment that is named on the command line; return what is wrong."""
    if len(sys.argv) != 2:
        return f'usage: VENV/bin/python {sys.argv[0]} VENV'
    environment = Path(sys.argv[1]).resolve()
    if environment != Path(sys.prefix).resolve() or sys.prefix == sys.base_prefix:
        return f'{environment} must be the virtual environment of the Python that runs this'
    real = Path(sysconfig.get_path('purelib')) / 'ros2cli'
    if real.exists():
        return f'{real} is the real ros2: this environment needs no small one'
    install(environment)
    return None


if __name__ == '__main__':
    sys.exit(main())
