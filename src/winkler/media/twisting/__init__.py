"""Media under a twist about the axis of the contact."""
