"""Height maps that are read without a library: simple fields of Gwyddion, and triangles."""
