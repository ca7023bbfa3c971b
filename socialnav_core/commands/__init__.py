"""The commands of `socialnav`, a module each."""
