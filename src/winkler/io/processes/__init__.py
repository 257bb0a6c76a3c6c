"""What processes do to each other: signals that stop them, and locks of files."""
