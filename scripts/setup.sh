#!/usr/bin/env bash
# Puts everything that the project needs into .venv; does nothing when it is there already.
set -eu
source "$(dirname "$0")/route.bash"
cd "$ROOT"

fail() {
    echo "socialnav: $*" >&2
    exit 1
}

usable_python() { # prints the first Python of a tested version
    local candidates='python3 python3.12 python3.11 /usr/bin/python3'
    [ "$ROUTE" = wheels ] || candidates=/usr/bin/python3 # the one that ROS is built for
    local python
    for python in $candidates; do
        if "$python" -c 'import sys; sys.exit(sys.version_info[:2] not in ((3, 11), (3, 12)))' \
            2>/dev/null; then
            command -v "$python"
            return
        fi
    done
    return 1
}

install_system_packages() { # installs where that needs no question, else says what to type
    local command="apt-get install -y $*" become=''
    [ "$(id -u)" = 0 ] || become='sudo -n'
    if [ -x "$(command -v apt-get)" ] && { [ -z "$become" ] || sudo -n true 2>/dev/null; }; then
        echo "socialnav: $command"
        $become apt-get update -qq && $become env DEBIAN_FRONTEND=noninteractive $command -qq
    else
        fail "system packages are missing; type: sudo $command"
    fi
}

[ "$(uname -s)" = Linux ] || fail 'needs Linux; use ROS 2 Jazzy on Ubuntu 24.04'
[ "$ROUTE" = ros ] || [ "$(uname -m)" = x86_64 ] ||
    fail "the ROS wheels are for x86-64, this is $(uname -m); source ROS 2 Jazzy on Ubuntu 24.04"
PYTHON=$(usable_python) || { install_system_packages python3 && PYTHON=$(usable_python); } ||
    fail 'needs Python 3.11 or 3.12'

missing=''
[ -x "$(command -v g++)" ] || missing="$missing g++"
[ -x "$(command -v cmake)" ] || missing="$missing cmake"
[ -x "$(command -v make)" ] || missing="$missing make"
"$PYTHON" -c 'import ensurepip' 2>/dev/null || missing="$missing python3-venv"
"$PYTHON" -c 'import os, sys, sysconfig
sys.exit(not os.path.exists(os.path.join(sysconfig.get_path("include"), "Python.h")))' ||
    missing="$missing python3-dev"
[ -z "$missing" ] || install_system_packages $missing

# The stamp is written last: an interrupted set-up begins again.
stamp=.venv/.setup-$(cat requirements/*.txt setup.py ros_ws/wheels/*.* scripts/setup.sh 2>/dev/null |
    cat - <(echo "$ROUTE $ROOT" && "$PYTHON" -V) | sha256sum | cut -c1-16)
[ ! -e "$stamp" ] || exit 0
echo "socialnav: setting up .venv with $("$PYTHON" -V), ROS 2 from ${ROUTE}"

options=''
[ "$ROUTE" = wheels ] || options=--system-site-packages
[ -x .venv/bin/python ] && [ "$(.venv/bin/python -V)" = "$("$PYTHON" -V)" ] ||
    "$PYTHON" -m venv --clear $options .venv
rm -f .venv/.setup-*
pip() { .venv/bin/python -m pip --disable-pip-version-check install -q "$@"; }
pip -r <(grep '^torch==' requirements/base.txt) # first: nothing else may choose a torch
if [ "$ROUTE" = wheels ]; then
    pip -r requirements/base.txt -r requirements/dev.txt -r requirements/ros-jazzy.txt
    .venv/bin/python ros_ws/wheels/install_setup_files.py .venv
else
    pip -r requirements/base.txt -r requirements/dev.txt -r <(grep -E '^(colcon|setuptools)' \
        requirements/ros-jazzy.txt)
fi
pip --no-deps --no-build-isolation -e .
touch "$stamp"
