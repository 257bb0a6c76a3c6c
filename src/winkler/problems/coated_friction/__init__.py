"""Friction on coated bodies, with the kernels of the layers."""
