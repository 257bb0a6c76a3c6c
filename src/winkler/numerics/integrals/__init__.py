"""Quadrature, and integrals of exponentials over a step."""
