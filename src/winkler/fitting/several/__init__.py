"""Numbers of several curves together: their population, groups of them, and fits with shared numbers."""
