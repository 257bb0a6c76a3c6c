"""Layers that may slide on each other, or be transversely isotropic."""
