"""Surfaces on a grid: boundary elements of a half-space, and repair of height maps."""
