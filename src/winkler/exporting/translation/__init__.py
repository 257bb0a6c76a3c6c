"""Kernels of the package, translated from their own Python source into C99."""
