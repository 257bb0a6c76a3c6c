"""Fits: measured force curves, what they say about a contact, and how surely."""
