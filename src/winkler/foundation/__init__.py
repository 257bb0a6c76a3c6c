"""The beds: springs under an equivalent plane profile."""
