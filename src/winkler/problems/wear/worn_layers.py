"""Sliding wear on layered media: which body wears, how much of the uppermost layer may go, and what that changes."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from winkler.errors import InvalidInput, OutsideValidity
from winkler.media.families import DepthVaryingMedium, LayeredBody
from winkler.problems.wear.grids import wear_grid
from winkler.problems.wear.states import WearState
from winkler.validity import Assumption, Note, Standing, standing_of

__all__ = ["MOST_WORN_SHARE", "layer_notes", "refuse_thin", "refuse_without_layer"]

MOST_WORN_SHARE = 0.05
"""Part of the thickness of the uppermost layer that may be worn off while the body responds as before."""
SMALL_CHANGE, LARGE_CHANGE = 0.01, 0.1
"""Relative change of the stiffness by a thinner layer up to which it is small, and beyond which it is not."""
SMALL_PULL = 1e-3
"""Part of the load that rings may pull before it is stated."""

MODEL = "the profile is lowered by what is worn off, the compliance stays that of the whole layer"


def refuse_without_layer(owner: str, medium: object) -> None:
    """Refuse a medium that has no layer to be worn."""
    if not isinstance(medium, LayeredBody):
        raise InvalidInput(
            f"{owner}: layer_wears is True, and a {type(medium).__name__} has no layers; leave it out, or give a "
            "CoatedHalfSpace, SlidingFilm or StackedHalfSpace."
        )


def _thickness(medium: Any) -> float:
    return float(medium.layers[0].thickness)


def refuse_thin(owner: str, medium: object, worn_depth: float, distance: float) -> None:
    """Refuse a layer of which more than a small part has been worn off.

    Parameters
    ----------
    owner : str
        Name of the problem.
    medium : CoatedHalfSpace, SlidingFilm or StackedHalfSpace
    worn_depth, distance : float
        Greatest worn depth [m], and how far the bodies have slid [m].
    """
    thickness = _thickness(medium)
    if worn_depth > MOST_WORN_SHARE * thickness:
        raise OutsideValidity(
            f"{owner}: within {distance:.4g} m of sliding more than {100.0 * MOST_WORN_SHARE:g} per cent of the "
            f"uppermost layer ({thickness:.4g} m) is worn off, and the body no longer responds as before; slide less "
            "far, or give a thicker layer."
        )


def layer_notes(medium: Any, states: Sequence[WearState], *, layer_wears: bool) -> Iterator[Note]:
    """Yield what is assumed of a layered medium that is slid on.

    Parameters
    ----------
    medium : Medium
        Any; nothing is said of one without layers.
    states : sequence of WearState
    layer_wears : bool
        Whether the uppermost layer wears, and not the other body.
    """
    if not isinstance(medium, DepthVaryingMedium):
        return
    last = states[-1]
    yield _thinned(medium, last) if layer_wears else OTHER_WEARS
    pulled = max(_pulled(state) for state in states)
    if pulled > SMALL_PULL:
        yield Note(
            Assumption.WEAR,
            Standing.OUTSIDE,
            f"The layers bend away from the body: rings would have to pull with {pulled:.2g} of the load, and were "
            "taken to bear nothing. Too much is worn off by that part.",
            "a contact that is not one disc is not solved",
        )


OTHER_WEARS = Note(
    Assumption.WEAR,
    Standing.APPROXIMATE,
    "The body without layers wears; the layers are taken to stay as they are, and to be held against friction.",
    "assumption of a counterbody that does not wear",
)


def _thinned(medium: Any, last: WearState) -> Note:
    """Return the note on a layer that has got thinner, with the stiffness of one that has done so all over."""
    share = last.worn_depth / _thickness(medium)
    top = dataclasses.replace(medium.layers[0], thickness=(1.0 - share) * _thickness(medium))
    thinner = dataclasses.replace(medium, layers=(top, *medium.layers[1:]))
    radius = np.array([last.radius])
    change = float(thinner.punch_stiffness(radius)[0] / medium.punch_stiffness(radius)[0] - 1.0)
    return Note(
        Assumption.WEAR,
        standing_of(abs(change), SMALL_CHANGE, LARGE_CHANGE),
        f"The uppermost layer loses up to {100.0 * share:.2g} per cent of its thickness and is taken to respond as "
        f"before; were it thinner by that all over, the contact would be {100.0 * abs(change):.2g} per cent "
        f"{'stiffer' if change > 0.0 else 'softer'}. The other body is taken not to wear.",
        MODEL,
    )


def _pulled(state: WearState) -> float:
    """Return which part of the load rings pull that were taken to bear nothing."""
    borne = float(wear_grid(state.bed, state.nodes).transforms.areas @ state.pressure)
    return borne / state.force - 1.0 if state.force > 0.0 else 0.0
