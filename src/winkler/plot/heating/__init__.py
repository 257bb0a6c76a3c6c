"""Pictures of frictional heating."""
