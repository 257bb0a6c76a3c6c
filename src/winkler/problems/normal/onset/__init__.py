"""The onset of yield, and the greatest stresses that it is sought by."""
