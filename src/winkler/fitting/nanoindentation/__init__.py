"""Nanoindentation: calibration of the tip, modulus and hardness with all shares of their uncertainty."""
