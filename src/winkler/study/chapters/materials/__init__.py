"""Chapters of measurements of materials."""
