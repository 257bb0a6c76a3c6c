"""Friction on height maps: stick and slip of contacts that need not be round, by boundary elements."""
