"""Pictures of rough surfaces and their contacts."""
