"""Interactive pictures of a fit: the curve with the fitted law, residuals, and force over depth."""

from __future__ import annotations

import numpy as np

from winkler.fitting.compare import AnyFit
from winkler.numerics.types import Array
from winkler.plot.fitting.fits import fit_panels
from winkler.plot.viscoelastic.fits import relaxing_loop
from winkler.web.pictures.chart import Chart, chart

__all__ = ["draw_fit", "draw_loop", "drawn_points"]

MOST_POINTS = 3000
"""Most drawn points of a curve, evenly spaced."""


def drawn_points(count: int) -> Array:
    """Return the indices of the drawn points of a curve."""
    return np.unique(np.linspace(0, count - 1, min(count, MOST_POINTS)).astype(int))


def draw_fit(fit: AnyFit) -> Chart:
    """Return the curve, the fitted law, and the residuals below."""
    return chart(*fit_panels(fit, drawn_points(fit.curve.count)))


def draw_loop(fit: AnyFit) -> Chart:
    """Return force over depth of a body that relaxes: as measured, and as fitted."""
    return chart(relaxing_loop(fit, drawn_points(fit.curve.count)))
