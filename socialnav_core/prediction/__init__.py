"""Where people will be: one protocol, and its members."""
