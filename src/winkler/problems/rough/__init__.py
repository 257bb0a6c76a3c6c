"""Rough surfaces: boundary elements, ensembles of spring lines, and reduction of height maps to springs."""
