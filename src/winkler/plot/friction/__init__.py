"""Pictures of contacts with friction."""
