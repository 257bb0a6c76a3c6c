"""Pressed height maps looked at more closely: true area and its error by two grids, patches, and leak of seals."""
