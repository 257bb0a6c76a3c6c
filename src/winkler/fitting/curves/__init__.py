"""Measured force curves: segments, noise, corrections and checks."""
