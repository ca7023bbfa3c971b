# Source this to run what was built: the ROS of the route, then the workspace's install folder.
# Discovery stays on this machine, so that a demo never drives a robot in the same building.

source "$(dirname "${BASH_SOURCE[0]}")/route.bash"
if [ "$ROUTE" = wheels ]; then
    source "$ROOT/.venv/setup.bash"
else
    export PATH="$ROOT/.venv/bin:$PATH"
fi
[ ! -e "$ROOT/ros_ws/install/setup.bash" ] || source "$ROOT/ros_ws/install/setup.bash"
export ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST
