"""Adhesion: pull-off, jumps, hysteresis and shear of sticky contacts."""
