"""The search for the onset of yield."""
