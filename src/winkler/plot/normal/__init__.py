"""Pictures of normal contact."""
