"""Metals that yield under a round body: pressed, let go, pressed again, and struck."""
