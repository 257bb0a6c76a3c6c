"""Height maps that wear while they slide."""
