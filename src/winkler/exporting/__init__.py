"""Contact laws as source files for other programs."""
