# Sourced by the other scripts. Decides where ROS 2 comes from: ROUTE is `ros` when ROS 2 Jazzy is
# sourced, else `wheels`, for which whatever would leak into the environment is taken out of it.

ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

if [ "${ROS_DISTRO:-}" = jazzy ] && [ -d "${AMENT_PREFIX_PATH%%:*}" ] && [ -x "$(command -v ros2)" ] &&
    [ "$(command -v ros2)" != "$ROOT/.venv/bin/ros2" ]; then
    ROUTE=ros
else
    ROUTE=wheels
    foreign=''
    for name in PYTHONPATH PYTHONHOME AMENT_PREFIX_PATH CMAKE_PREFIX_PATH COLCON_PREFIX_PATH \
        RMW_IMPLEMENTATION ROS_DISTRO ROS_VERSION ROS_PYTHON_VERSION CONDA_PREFIX; do
        value=${!name:-}
        case $value in '' | "$ROOT"/*) ;; *) foreign="$foreign $name" ;; esac
        unset "$name"
    done
    [ -z "$foreign" ] || echo "socialnav: ignoring$foreign: ROS 2 Jazzy comes from .venv" >&2
    case ${LD_LIBRARY_PATH:-} in */ros/*) unset LD_LIBRARY_PATH ;; esac
fi
