"""Thin films on grids: flow between two sides, what is joined, the narrowest place, the effective medium."""
