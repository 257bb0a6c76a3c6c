"""Measured numbers in text tables."""
