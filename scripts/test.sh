#!/usr/bin/env bash
# Runs every check that continuous integration runs, to the end, and fails if one of them did.
# Arguments go to pytest. A suite without tests is a failure too: one that got lost would look like this.
set -o pipefail
cd "$(dirname "$0")/.."
failed=''

check() { # name, command ...
    printf '\n== %s\n' "$1"
    "${@:2}" || failed="$failed $1"
}

check lint make --no-print-directory lint
check core .venv/bin/python -m pytest tests studies "$@"
check build scripts/build.sh
source scripts/environment.bash
check ros2 .venv/bin/python -m pytest ros_ws/wheels/test "$@"
check nodes .venv/bin/python -m pytest ros_ws/src/socialnav/test "$@"

[ -z "$failed" ] || { echo "failed:$failed" >&2 && exit 1; }
