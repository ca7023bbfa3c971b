"""The small ros2 as a command."""

import sys

from small_ros2.command import main

if __name__ == '__main__':
    sys.exit(main())
