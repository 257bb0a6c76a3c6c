"""Media: the half-spaces under the contact, which turn bodies into springs and springs into bodies."""
