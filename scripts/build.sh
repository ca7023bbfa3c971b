#!/usr/bin/env bash
# Builds the workspace into ros_ws/install; does nothing when nothing that is built has changed since.
# Modules, launch files and models are linked, not copied: a change inside one needs no build, a new one does.
set -eo pipefail
source "$(dirname "$0")/route.bash"
source "$ROOT/.venv/setup.bash"
cd "$ROOT"
exec 8<ros_ws && flock 8 # one build at a time

place="$ROUTE $ROOT $(.venv/bin/python -V)"
if [ "$(cat ros_ws/build/.place 2>/dev/null)" != "$place" ]; then # absolute paths are built in
    rm -rf ros_ws/build ros_ws/install
    mkdir -p ros_ws/build && echo "$place" >ros_ws/build/.place
fi

names() { find ros_ws/src $(ls -d models 2>/dev/null) -type f -not -name '*.pyc' | LC_ALL=C sort; }
contents() {
    sha256sum setup.py package.xml requirements/*.txt ros_ws/*.yaml ros_ws/wheels/*.cmake
    find ros_ws/src -name setup.py -o -type f -not -name '*.py*' | LC_ALL=C sort | xargs sha256sum
}
wanted=$({ names && contents; } | sha256sum)
# The stamp names the build as well: one that was made by hand is followed by one from here.
stamp=ros_ws/install/.built
if [ "$(cat "$stamp" 2>/dev/null)" = "$wanted $(readlink ros_ws/log/latest_build)" ]; then exit; fi

rm -f "$stamp"
(cd ros_ws && ../.venv/bin/python -m colcon build --symlink-install --event-handlers console_direct- "$@")
echo "$wanted $(readlink ros_ws/log/latest_build)" >"$stamp"
