"""Fits of contacts with or without adhesion: response, start and outcome."""
