#!/usr/bin/env bash
# Builds the workspace into ros_ws/install; does nothing when no source has changed since.
set -e
source "$(dirname "$0")/route.bash"
[ "$ROUTE" = ros ] || source "$ROOT/.venv/setup.bash"
cd "$ROOT"

sources=$(find ros_ws/src setup.py package.xml ros_ws/*.yaml ros_ws/wheels models socialnav_core \
    -type f -not -path '*/__pycache__/*' -not -name '*.py[co]' 2>/dev/null | LC_ALL=C sort)
stamp=ros_ws/install/.built-$(echo "$sources" | cat - <(echo "$sources" | xargs sha256sum) \
    .venv/.setup-* <(ls .venv/.setup-*) | sha256sum | cut -c1-16)
[ ! -e "$stamp" ] || exit 0

rm -f ros_ws/install/.built-*
cd ros_ws
"$ROOT/.venv/bin/python" -m colcon build --symlink-install --event-handlers console_direct- "$@"
touch "$ROOT/$stamp"
