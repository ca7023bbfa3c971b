"""The search for a robot that drives where it looks: over speeds and turn rates in reach."""
