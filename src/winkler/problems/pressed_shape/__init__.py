"""Shapes pressed by pixels on media on which no closed form is known."""
