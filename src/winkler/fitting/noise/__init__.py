"""The noise of a measured curve: white and slow parts, what they do to fitted numbers, and drifts, tilts and drags."""
