"""Figures: ``draw(anything)`` returns a matplotlib figure."""

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
