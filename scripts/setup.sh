#!/usr/bin/env bash
# Puts everything that the project needs into .venv; does nothing when it is there already.
set -euo pipefail
source "$(dirname "$0")/route.bash"
cd "$ROOT"

say() { echo "socialnav: $*" >&2; }
fail() { say "$*" && exit 1; }

python_fits() { # a tested version, with all that a virtual environment and a compiler of extensions need
    "$1" -c 'import ensurepip, os, sys, sysconfig, venv
header = os.path.join(sysconfig.get_path("include"), "Python.h")
sys.exit(sys.version_info[:2] not in ((3, 11), (3, 12)) or not os.path.exists(header))' 2>/dev/null
}

find_python() { # prints the first that fits, else the first of a tested version
    local candidates=(python3 /usr/bin/python3 python3.12 python3.11) python
    [ "$ROUTE" = wheels ] || candidates=(/usr/bin/python3) # the one that ROS is built for
    for python in "${candidates[@]}"; do
        if python_fits "$python"; then command -v "$python" && return; fi
    done
    for python in "${candidates[@]}"; do
        case $("$python" -V 2>/dev/null) in *' 3.11.'* | *' 3.12.'*) command -v "$python" && return ;; esac
    done
}

missing_packages() { # prints what apt-get calls the tools that are not here
    local tool version
    for tool in g++ cmake make; do [ -x "$(command -v $tool)" ] || echo "$tool"; done
    if [ -z "$PYTHON" ]; then
        [ -x /usr/bin/python3 ] || echo python3 python3-venv python3-dev
    elif ! python_fits "$PYTHON"; then
        version=$("$PYTHON" -c 'import sys; print("python%d.%d" % sys.version_info[:2])')
        echo "$version-venv" "$version-dev"
    fi
}

install_packages() { # where that needs no question; else says what to type
    local install="apt-get install -y $*" become=()
    [ "$(id -u)" = 0 ] || become=(sudo -n)
    [ -x "$(command -v apt-get)" ] || fail "these are missing, install them with your system's tool: $*"
    [ "$(id -u)" = 0 ] || sudo -n true 2>/dev/null || fail "these are missing, type: sudo $install"
    say "$install"
    "${become[@]}" apt-get update -qq
    "${become[@]}" env DEBIAN_FRONTEND=noninteractive $install -qq --no-install-recommends >/dev/null
}

declare -A source=([ros]='the sourced installation' [wheels]='wheels')
elsewhere='use Ubuntu 24.04 with ROS 2 Jazzy sourced, or the image in docker/'
[ "$(uname -s)" = Linux ] || fail "this is $(uname -s), the project runs on Linux: $elsewhere"
[ "$ROUTE" = ros ] || [ "$(uname -m)" = x86_64 ] || fail "no ROS wheels for $(uname -m): $elsewhere"
case $ROOT in *' '*) fail "ROS 2 does not build in a folder with a space in its path: $ROOT" ;; esac
[ -z "$IGNORED" ] || say "ignoring$IGNORED, since ROS 2 Jazzy comes from .venv here"
exec 9<. && flock 9 # one set-up at a time

# The stamp comes last and goes first: without one, what is in .venv may be half of something.
inputs=(requirements/*.txt setup.py studies/*/setup.py scripts/setup.sh ros_ws/wheels/install_setup_files.py)
stamp=.venv/.setup-$({ cat "${inputs[@]}" && echo "$ROUTE $ROOT"; } | sha256sum | cut -c1-16)
if [ -e "$stamp" ] && .venv/bin/python -c '' 2>/dev/null; then exit; fi

PYTHON=$(find_python)
[ -n "$PYTHON" ] || [ ! -x "$(command -v python3)" ] || fail "needs Python 3.11 or 3.12: install one, or $elsewhere"
packages=$(missing_packages)
if [ -n "$packages" ]; then
    install_packages $packages
    PYTHON=$(find_python)
fi
python_fits "$PYTHON" || fail "needs Python 3.11 or 3.12 with venv and headers: install one, or $elsewhere"

shared=$([ "$ROUTE" = ros ] && echo true || echo false)
if ! compgen -G '.venv/.setup-*' >/dev/null || ! .venv/bin/python -c '' 2>/dev/null ||
    ! grep -qx "include-system-site-packages = $shared" .venv/pyvenv.cfg ||
    ! grep -qF -- " $ROOT/.venv" .venv/pyvenv.cfg; then
    say "making .venv with $("$PYTHON" -V), ROS 2 Jazzy from ${source[$ROUTE]}"
    flags=(--clear)
    [ "$ROUTE" = wheels ] || flags+=(--system-site-packages)
    "$PYTHON" -m venv "${flags[@]}" "$ROOT/.venv"
fi
rm -f .venv/.setup-*

export PYTHONNOUSERSITE=1 # what lies in the home folder is not there for other users
pip() { .venv/bin/python -m pip --disable-pip-version-check install -q "$@"; }
say 'installing PyTorch'
pip -r <(grep '^torch==' requirements/base.txt) # first, so that nothing else chooses one
say 'installing the other packages'
files=(base dev colcon)
[ "$ROUTE" = ros ] || files+=(ros-jazzy)
pip $(printf -- '-r requirements/%s.txt ' "${files[@]}")
if [ "$ROUTE" = ros ]; then # the same file to source; CMake takes the same Python as colcon
    printf "build: {cmake-args: ['-DPython3_EXECUTABLE=%s']}\n" "$ROOT/.venv/bin/python" >.venv/colcon_defaults.yaml
    printf 'export PATH="%s/bin:$PATH" COLCON_DEFAULTS_FILE="%s/colcon_defaults.yaml"\n' "$ROOT/.venv" "$ROOT/.venv" |
        tee .venv/setup.{sh,bash,zsh} >/dev/null
else
    .venv/bin/python ros_ws/wheels/install_setup_files.py .venv
fi
pip --no-deps --no-build-isolation -e . -e studies/founding_report
touch "$stamp"
