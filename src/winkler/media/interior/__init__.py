"""Stresses and displacements inside homogeneous bodies."""
