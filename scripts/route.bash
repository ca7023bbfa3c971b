# Sourced by the other scripts. Decides where ROS 2 comes from: ROUTE is `ros` where ROS 2 Jazzy is sourced and the
# system's Python can import it, else `wheels`; then whatever would break the wheels is taken out of the environment
# (IGNORED names it).

ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
IGNORED=''

clean_environment() {
    local name folder path=''
    for name in PYTHONPATH PYTHONHOME AMENT_PREFIX_PATH CMAKE_PREFIX_PATH COLCON_PREFIX_PATH \
        RMW_IMPLEMENTATION ROS_DISTRO ROS_VERSION ROS_PYTHON_VERSION CONDA_PREFIX; do
        if [ -n "${!name:-}" ] && tr : '\n' <<<"${!name}" | grep -qvF "$ROOT/"; then # some entry is not ours
            IGNORED="$IGNORED $name"
        fi
    done
    if [ -n "${CONDA_PREFIX:-}" ]; then # its Python and its compiler do not fit the wheels
        while read -r -d : folder; do
            [[ $folder/ == "$CONDA_PREFIX"/* ]] || path="$path:$folder"
        done <<<"$PATH:"
        PATH=${path#:}
    fi
    case ${LD_LIBRARY_PATH:-} in */ros/* | *conda*) unset LD_LIBRARY_PATH ;; esac
    unset $IGNORED VIRTUAL_ENV
}

if [ "${ROS_DISTRO:-}" = jazzy ] && /usr/bin/python3 -c 'import importlib.util, sys
sys.exit(importlib.util.find_spec("rclpy") is None)' 2>/dev/null; then
    ROUTE=ros
    unset CONDA_PREFIX VIRTUAL_ENV # CMake would take their Python
else
    ROUTE=wheels
    clean_environment
fi
