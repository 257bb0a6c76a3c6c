"""Metals that yield under a round body: pressed, let go, and pressed again."""
