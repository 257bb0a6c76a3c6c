"""Shapes of bodies of revolution, f(r): the gap profile of the undeformed bodies."""
