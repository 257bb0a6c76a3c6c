"""Pictures of rolling."""
