"""Contacts whose rings slide while others stick: what a twist, and a push on coatings, have in common."""
