"""Pictures of adhesive contacts."""
