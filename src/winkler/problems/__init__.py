"""Contact problems, their solution and their results: one package per kind of physics."""
