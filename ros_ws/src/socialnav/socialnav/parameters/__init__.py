"""Every parameter of every node, in one dataclass each, and how nodes come by their values."""

AUTO = 'auto'
"""Name of the model that suits the kinematics of the base."""
DEFAULT_MODEL = 'socialnav'
"""That of a holonomic base."""
