"""Stresses below maps of pressure and traction: components, the greatest of them, and yield."""
