"""Functions on panels: Chebyshev polynomials, splines, and panels for roots and kinks."""
