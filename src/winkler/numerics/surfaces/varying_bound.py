r"""A surface whose friction depends on its own slip: bound and slip by turns.

The tractions are found under a bound, and the slip that comes with them gives the next one, until

.. math:: \sum|g-\mu(s)\,p| \le \varepsilon\sum\mu(s)\,p .

Where a change of the bound changes the slip so that the bound changes by less, that settles, each time by about the
same part; the sum of such a row is taken at once now and then (Aitken).  Where it changes by more, again and again,
slip runs away: friction falls faster than the bodies unload, and they jump.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple, Protocol, TypeVar

import numpy as np

from winkler.numerics.types import Array
from winkler.values.errors import NotConverged, OutsideValidity

MOST_TURNS = 300
"""Turns after which bound and slip have not settled; ten are usual."""
GROWING_TURNS = 2
"""How often in sequence the change of the bound must grow for the slip to run away."""
SETTLED_CHANGE = 1e-3
"""Changes of the bound, over the bound, below which growth may be the remainder of an unfinished solution."""
EVERY = 3
"""After how many turns the remaining ones are summed up."""
STEADY_RATIO = 0.95
"""Largest ratio of changes of which the sum is taken."""


class Slipping(Protocol):
    """A surface that was solved under some bound."""

    @property
    def traction(self) -> Array:
        """Tractions, (2, nx, ny)."""

    @property
    def slip(self) -> Array:
        """Slip, (2, nx, ny)."""

    @property
    def slipping(self) -> Array:
        """Which pixels slip, (nx, ny)."""


Surface = TypeVar("Surface", bound=Slipping)


class Varied(NamedTuple):
    """The surface, under the bound that its slip gives.

    Parameters
    ----------
    mismatch
        Sum of |g - mu(s) p| over that of mu(s) p.
    turns
        How often the surface was solved.
    """

    mismatch: float
    turns: int


def vary(
    solve: Callable[[Array, Array], Surface], bound_of: Callable[[Array], Array], start: Array, tolerance: float
) -> tuple[Surface, Varied]:
    """Solve a surface whose bound depends on the slip.

    Parameters
    ----------
    solve
        Takes the bound g, (nx, ny), and tractions to begin with, (2, nx, ny).
    bound_of
        mu(s) p, of the size of the slip, (nx, ny).
    start
        Tractions to begin with.
    tolerance
        Bound on `Varied.mismatch`.

    Raises
    ------
    OutsideValidity
        If the slip runs away.
    NotConverged
        If bound and slip do not settle.
    """
    bound = bound_of(np.zeros(start.shape[1:]))
    before, growing, since = np.zeros_like(bound), 0, 0
    last = mismatch = np.inf
    for turn in range(1, MOST_TURNS + 1):
        surface = solve(bound, start)
        start = surface.traction
        wanted = bound_of(np.where(surface.slipping, np.hypot(surface.slip[0], surface.slip[1]), 0.0))
        change, total = wanted - bound, float(np.sum(wanted))
        weight = np.divide(1.0, bound, out=np.zeros_like(bound), where=bound > 0.0)
        size = float(np.sum(weight * change * change))
        mismatch = float(np.sum(np.abs(change))) / total if total > 0.0 else 0.0
        if mismatch <= tolerance:
            return surface, Varied(mismatch, turn)
        growing = growing + 1 if size > last and mismatch > SETTLED_CHANGE else 0
        if growing == GROWING_TURNS:
            raise OutsideValidity(
                "the slip runs away: friction falls faster than the bodies unload, and they jump; give friction that "
                "falls over more slip"
            )
        since, last = since + 1, size
        product, square = float(np.sum(weight * before * change)), float(np.sum(weight * before * before))
        ratio = product / square if square > 0.0 else 0.0
        if since >= EVERY and 0.0 < ratio < STEADY_RATIO:
            bound, before, since, last = (
                np.maximum(bound + change / (1.0 - ratio), 0.0),
                np.zeros_like(change),
                0,
                np.inf,
            )
        else:
            bound, before = wanted, change
    raise NotConverged(
        f"friction that depends on slip still misses it by {mismatch:.3g} after {MOST_TURNS} turns; allowed are "
        f"{tolerance:.3g}. Give friction that falls over more slip"
    )
