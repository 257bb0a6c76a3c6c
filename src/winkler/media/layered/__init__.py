"""Layered bodies, and bodies graded in depth by a given law."""
