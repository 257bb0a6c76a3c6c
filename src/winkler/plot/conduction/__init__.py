"""Pictures of contacts that conduct."""
