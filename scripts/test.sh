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
check core .venv/bin/python -m pytest tests "$@"
check build scripts/build.sh
source scripts/environment.bash
check ros2 .venv/bin/python -m pytest ros_ws/wheels/test "$@"
# After a kill -9 the middleware once in a few hundred times never tells a process of the next one: begin such a test anew,
# which the summary counts, and no other.
check nodes .venv/bin/python -m pytest ros_ws/src/socialnav/test \
    --reruns 1 --only-rerun 'AssertionError: no (publisher|subscriber|service|client|nodes?)\b' "$@"

[ -z "$failed" ] || { echo "failed:$failed" >&2 && exit 1; }
