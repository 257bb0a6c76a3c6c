"""Viscoelastic media."""
