"""Timers, watchdogs and clocks: that something happens in time."""
