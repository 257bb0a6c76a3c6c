"""Interactive pictures as plain dictionaries for the browser."""
