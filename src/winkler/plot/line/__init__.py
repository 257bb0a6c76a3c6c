"""Pictures of line contacts."""
