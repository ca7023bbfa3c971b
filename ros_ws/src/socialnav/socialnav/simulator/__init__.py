"""The simulated world behind the topics."""
