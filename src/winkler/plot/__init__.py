"""Figures: ``draw(anything)`` returns a matplotlib figure."""

# ruff: noqa: E402
from winkler.caches import with_fonts

with_fonts()

# sheets that tell draw() themselves what they draw
from winkler.plot import (  # noqa: F401
    conduction,
    conduction_fields,
    conduction_spots,
    heating,
    restored,
    rolling,
    rough_lines,
    roughness,
    surfaces,
    viscoelastic,
    viscoelastic_fits,
    viscoelastic_solids,
    viscoelastic_surfaces,
    viscoelastic_tests,
    wear,
)
from winkler.plot.draw import draw

__all__ = ["draw"]
