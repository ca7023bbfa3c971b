"""What a robot needs to drive, and what it may drive without, in words."""

from socialnav.parameters.policy import PolicyParameters

BLIND = (
    'nothing that stands is required (require_obstacles and use_map are false): '
    'the robot drives into what nobody tells it of'
)


def requirements(settings: PolicyParameters) -> str:
    """Return what is required and what is not."""
    limit, obstacles_limit = settings.input_timeout, settings.obstacles_timeout
    age = f', not older than {obstacles_limit:g} s' if obstacles_limit else ' of any age'
    required = [f'odom and pedestrians, not older than {limit:g} s']
    required.append('goal_pose' if settings.goal_topics else 'a path by follow_path')
    optional = ['plan'] * settings.goal_topics
    (required if settings.require_obstacles else optional).append(f'obstacles{age}')
    (required if settings.use_map else optional).append('map')
    return f'required: {"; ".join(required)}. Not required: {"; ".join(optional) or "nothing"}'


def risks(settings: PolicyParameters) -> str | None:
    """Return what an operator must know of that is not required; None if nothing."""
    return None if settings.require_obstacles or settings.use_map else BLIND
