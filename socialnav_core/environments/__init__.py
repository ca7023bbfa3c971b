"""Environments for Gymnasium; importing this package registers them."""

from socialnav_core.extras import extra

with extra('gym'):
    import gymnasium

from socialnav_core.environments.single import SocialNavEnv
from socialnav_core.environments.vector import SocialNavVectorEnv

NAME = 'socialnav/SocialNav-v0'
"""What `gymnasium.make` and `gymnasium.make_vec` know the environment by."""

if NAME not in gymnasium.registry:
    gymnasium.register(
        NAME,
        entry_point='socialnav_core.environments:SocialNavEnv',
        vector_entry_point='socialnav_core.environments:SocialNavVectorEnv',
    )

__all__ = ['NAME', 'SocialNavEnv', 'SocialNavVectorEnv']
