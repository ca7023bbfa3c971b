"""Every parameter of every node, in one dataclass each, and how nodes come by their values."""

DEFAULT_MODEL = 'socialnav'
