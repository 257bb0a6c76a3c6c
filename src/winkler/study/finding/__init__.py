"""Search among all that a study may name, by what people call it."""
