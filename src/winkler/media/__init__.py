"""Media: they translate body -> springs and springs -> body."""
