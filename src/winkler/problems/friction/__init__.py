"""Tangential contact, torsion and damping by friction, under any loading history."""
