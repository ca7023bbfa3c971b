# The image of the nodes with the parts of nav2 that nav2_launch.py starts. Build socialnav:jazzy first:
#   docker build -f docker/Dockerfile -t socialnav:jazzy .
#   docker build -f docker/nav2.Dockerfile -t socialnav:jazzy-nav2 .
FROM socialnav:jazzy
USER 0
# No versions: a distribution keeps only its latest ones, so a pin would break with the next update.
# hadolint ignore=DL3008
RUN apt-get update \
    && apt-get install -y --no-install-recommends \
        ros-jazzy-nav2-behaviors ros-jazzy-nav2-bt-navigator ros-jazzy-nav2-collision-monitor \
        ros-jazzy-nav2-lifecycle-manager ros-jazzy-nav2-map-server ros-jazzy-nav2-msgs \
        ros-jazzy-nav2-navfn-planner ros-jazzy-nav2-planner ros-jazzy-nav2-velocity-smoother \
        ros-jazzy-tf2-ros-py \
    && rm -rf /var/lib/apt/lists/*
USER 1001
CMD ["ros2", "launch", "socialnav", "nav2_launch.py"]
