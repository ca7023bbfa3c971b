# Source this to run what was built: the ROS of the route, then the workspace's install folder. Discovery stays on
# this machine and no domain is set: a demo must never drive a robot that listens nearby.

source "$(dirname "${BASH_SOURCE[0]}")/route.bash"
source "$ROOT/.venv/setup.bash"
[ ! -e "$ROOT/ros_ws/install/setup.bash" ] || source "$ROOT/ros_ws/install/setup.bash"
unset ROS_DOMAIN_ID ROS_STATIC_PEERS ROS_LOCALHOST_ONLY
export ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST
