"""Wear by sliding and fretting, and the profile at which it ends."""
