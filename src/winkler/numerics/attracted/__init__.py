"""Attracted surfaces on a grid: laws, the elastic surface, and the minimum of the energy."""
