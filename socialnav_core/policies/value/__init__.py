"""Value networks, and the one-step look-ahead that drives by them."""
