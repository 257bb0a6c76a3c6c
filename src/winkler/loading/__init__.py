"""Loads, paths of loads, and paths stated in steps."""
