"""Layered bodies, and bodies graded in depth in any way."""
