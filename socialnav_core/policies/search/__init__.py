"""Receding-horizon search in space and time among predicted people."""
