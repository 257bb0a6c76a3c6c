"""Measurements of bodies that relax: sweeps shifted into a master curve, and relaxation spectra."""
