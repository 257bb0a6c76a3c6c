"""Conducting bodies."""
