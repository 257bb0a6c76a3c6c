"""Fits of viscoelastic contacts."""
