#!/usr/bin/env bash
# Runs a command where ROS 2, the workspace and the nodes' executables are found. The command takes this shell's
# place, so that a node gets SIGTERM itself and can stop the robot; `ros2 run` would not pass it on.
set -eo pipefail
source /opt/socialnav/install/setup.bash
export PATH="/opt/socialnav/install/socialnav/lib/socialnav:/opt/socialnav/.venv/bin:$PATH"
exec "$@"
