"""Fields of discs and moving sources on a half-space."""
