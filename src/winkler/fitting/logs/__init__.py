"""Logs of tests: loops of friction, contact resistance over force, pins on discs, and bounces by their times."""
