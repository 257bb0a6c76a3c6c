"""Pictures of measured curves and fits."""
