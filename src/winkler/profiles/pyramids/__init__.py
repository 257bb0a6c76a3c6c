"""Pyramids with three and more faces, sharp and rounded, as the bodies of revolution with their forces."""
