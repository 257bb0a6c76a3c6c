"""Pictures of wear."""
