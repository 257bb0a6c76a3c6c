"""Layers that relax under a fit: their response along a path, and what can be said of it."""
