"""Figures: ``draw(anything)`` returns a matplotlib figure."""

# ruff: noqa: E402
from winkler.caches import with_fonts

with_fonts()

# sheets that tell draw() themselves what they draw
from winkler.plot import restored
from winkler.plot.conduction import constriction, fields, spots
from winkler.plot.draw import draw
from winkler.plot.heating import heating
from winkler.plot.rolling import rolling
from winkler.plot.rough import lines, roughness, surfaces
from winkler.plot.viscoelastic import contacts, fits, material_tests, solids
from winkler.plot.viscoelastic import surfaces as viscoelastic_surfaces
from winkler.plot.wear import wear

__all__ = ["draw"]
