"""Roots, differential equations, and functions given by formulas."""
