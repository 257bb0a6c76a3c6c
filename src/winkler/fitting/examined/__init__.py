"""Fits examined further: over depth, under the error of a calibration, and against other models."""
