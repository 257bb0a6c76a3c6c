"""Restoring the bodies from the springs: fields on the surface and below it, and the greatest stress."""
