"""Electric current through pressed height maps."""
