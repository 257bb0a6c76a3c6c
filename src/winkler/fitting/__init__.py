"""Fits of contact models to measured force curves, with errors and validity."""
