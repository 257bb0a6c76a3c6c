"""Panels as SVG, drawn without matplotlib."""
