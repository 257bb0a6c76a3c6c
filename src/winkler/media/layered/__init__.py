"""Layered bodies, and bodies graded in depth by any law."""
