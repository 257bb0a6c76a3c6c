"""Pictures of impacts."""
