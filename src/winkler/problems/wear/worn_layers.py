"""Wear on layered media: which body wears, how much of the uppermost layer may go, and what that changes."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import numpy as np

from winkler.laws.wear import PairWear, Unworn, WearLaw
from winkler.loading.loads import Force, LineForce
from winkler.media.offers import LayerStack, PressedWaves, offers
from winkler.numerics.types import Array
from winkler.problems.line.half_width import under_force
from winkler.problems.line.peak_pressure import rim_load
from winkler.problems.normal.indentation import Indentation, IndentationSolution
from winkler.problems.wear.grids import wear_grid
from winkler.problems.wear.line_states import LineWearState
from winkler.problems.wear.states import WearState, WornState
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing, standing_of

MOST_WORN_SHARE = 0.05
"""Part of the thickness of the uppermost layer that may be worn off while the body responds as before."""
SMALL_CHANGE, LARGE_CHANGE = 0.01, 0.1
"""Relative change of the stiffness by a thinner layer up to which it is small, and beyond which it is not."""
SMALL_MISS, LARGE_MISS = 0.002, 0.05
"""Error of mean pressures before wear over the greatest: up to one a grid is fine, beyond the other too coarse."""
NODES, WEIGHTS = np.polynomial.legendre.leggauss(3)
BETWEEN = 10
"""Rings from the middle to the edge of which the pressure is examined, beside those at both."""
SMALL_PULL = 1e-3
"""Part of the load that rings may pull before it is stated."""

MODEL = "the profile is lowered by what is worn off, the compliance stays that of the whole layer"


def _thickness(medium: Any) -> float:
    return float(medium.layers[0].thickness)


def refuse_wear_of_layers(owner: str, medium: object, wear: WearLaw, *, layer_wears: bool) -> None:
    """Refuse a law for a layer on a medium that has no layer to be worn; parameters as of `laws_on`."""
    if layer_wears and not offers(medium, LayerStack):
        raise InvalidInput(
            f"{owner}: layer_wears is True, and a {type(medium).__name__} has no layers; leave it out, or give a "
            "CoatedHalfSpace, SlidingFilm or StackedHalfSpace."
        )
    if layer_wears and isinstance(wear, PairWear):
        raise InvalidInput(
            f"{owner}: layer_wears is True, and the law of wear is a PairWear, whose first law is that of the "
            "layer; leave layer_wears out, or give one law."
        )
    if isinstance(wear, PairWear) and offers(medium, PressedWaves) and not offers(medium, LayerStack):
        raise InvalidInput(
            f"{owner}: under a PairWear the first body wears, and a {type(medium).__name__} has no layers of which it "
            "is known how much may go; give one law, that of the other body, or a CoatedHalfSpace."
        )


def layer_loses(medium: object, wear: WearLaw, *, layer_wears: bool) -> bool:
    """Return whether the uppermost layer wears; parameters as of `laws_on`."""
    return layer_wears or (isinstance(wear, PairWear) and offers(medium, PressedWaves))


def laws_on(medium: object, wear: WearLaw, *, layer_wears: bool) -> WearLaw:
    """Return how the bodies wear.

    Parameters
    ----------
    medium : Medium
    wear : Archard, OwnWear or PairWear
        One law alone is that of the second body on layers that stay as they are, else the first's.
    layer_wears : bool
        Whether the uppermost layer wears by it.
    """
    if isinstance(wear, PairWear) or layer_wears or not offers(medium, PressedWaves):
        return wear
    return PairWear(Unworn(), wear)


def refuse_thin(owner: str, medium: object, worn_depth: float, elapsed: str) -> None:
    """Refuse a layer of which more than a small part has been worn off.

    Parameters
    ----------
    owner : str
        Name of the problem.
    medium : CoatedHalfSpace, SlidingFilm or StackedHalfSpace
    worn_depth : float
        Greatest worn depth [m].
    elapsed : str
        Distance or cycles up to there, with the unit.
    """
    thickness = _thickness(medium)
    if worn_depth > MOST_WORN_SHARE * thickness:
        raise OutsideValidity(
            f"{owner}: within {elapsed} more than {100.0 * MOST_WORN_SHARE:g} per cent of the "
            f"uppermost layer ({thickness:.4g} m) is worn off, and the body no longer responds as before; wear less, "
            "or give a thicker layer."
        )


def layer_notes(
    medium: Any, states: Sequence[WornState], coarse: Iterable[Note], *, layer_wears: bool
) -> Iterator[Note]:
    """Yield what is assumed of a layered medium that wears, or is worn against.

    Parameters
    ----------
    medium : Medium
        Any; nothing is said of one without layers.
    states : sequence of WornState
    coarse : iterable of Note
        By how much the grid misses the contact before wear; not read of a medium without layers.
    layer_wears : bool
        Whether the uppermost layer wears, and not the other body.
    """
    if not offers(medium, PressedWaves):
        return
    last = states[-1]
    yield _thinned(medium, last) if layer_wears else OTHER_WEARS
    yield from coarse
    pulled = max(_pulled(state) for state in states)
    if pulled > SMALL_PULL:
        yield Note(
            Assumption.WEAR,
            Standing.OUTSIDE,
            f"The layers separate from the body inside the assumed contact. Tension of {pulled:.2g} of the load "
            "was set to zero there, so the wear is too large by this fraction.",
            "a contact that parts inside is not solved",
        )


def cells_note(first: WearState) -> Iterator[Note]:
    """Yield by how much rings miss the pressure of the profile before wear, where that is not small."""
    if not first.force > 0.0:
        return
    exact, grid = Indentation(first.bed, Force(first.force)).solve(), wear_grid(first.bed, first.nodes)
    found = grid.press(np.zeros(first.nodes.size), Force(first.force)).pressure
    squares = np.append(grid.transforms.borders, first.nodes[-1] ** 2)
    # the pressure of layers takes a while at each place: the middle, the edge and some cells between are examined
    last = min(int(np.searchsorted(squares, exact.radius**2, side="right")), found.size) - 1
    chosen = np.unique(np.clip([0, 1, 2, *np.linspace(0, last, BETWEEN).astype(int), last - 2, last - 1], 0, last))
    yield from _coarse(found, found[chosen] - _mean_pressures(exact, squares, chosen))


def _mean_pressures(contact: IndentationSolution[float], squares: Array, chosen: Array) -> Array:
    """Return the mean pressures [Pa] in chosen cells between radii of these squares [m^2]."""
    # over sqrt(a^2 - r^2), in which neither an edge that closes nor one that bears is singular
    depth = np.sqrt(np.maximum(contact.radius**2 - squares, 0.0))
    half = 0.5 * (depth[chosen] - depth[chosen + 1])[:, None]
    places = 0.5 * (depth[chosen] + depth[chosen + 1])[:, None] + half * NODES
    radii = np.sqrt(np.maximum(contact.radius**2 - places**2, 0.0))
    pressure = contact.problem.bed.medium.pressure(contact.pressed, radii.ravel()).reshape(radii.shape)
    return np.asarray(2.0 * np.sum(half * WEIGHTS * pressure * places, axis=1) / np.diff(squares)[chosen])


def strip_cells_note(first: LineWearState) -> Iterator[Note]:
    """Yield by how much a grid misses the pressure of the profile before wear, where that is not small."""
    bed, grid, force = first.bed, wear_grid(first.bed, first.nodes), first.force_per_length
    contact = grid.press(np.zeros(first.nodes.size), LineForce(force))
    half_width = float(under_force(bed, np.array([contact.depth]))[0])
    edges = np.append(grid.transforms.borders, first.nodes[-1])
    exact = bed.mean_pressures(edges, half_width, rim_load(bed, force, half_width))
    yield from _coarse(contact.pressure, contact.pressure - exact)


def _coarse(pressure: Array, missed: Array) -> Iterator[Note]:
    """Yield by how much pressures about the nodes of a grid miss those of the layers, where that is not small."""
    error = float(np.max(np.abs(missed)) / np.max(pressure))
    if error > SMALL_MISS:
        yield Note(
            Assumption.RESOLUTION,
            standing_of(error, SMALL_MISS, LARGE_MISS),
            f"Before wear the mean pressures at the nodes differ by up to {100.0 * error:.2g} per cent of the "
            f"maximum from those of the layers (grid of {pressure.size - 1} cells). A layer much stiffer than its "
            "base needs cells small compared with its thickness: give more cells (count).",
            "flat punches superposed, without a grid",
            error,
        )


OTHER_WEARS = Note(
    Assumption.WEAR,
    Standing.APPROXIMATE,
    "Only the body without layers wears. The layers are assumed unworn, and to stay in place under the friction force.",
    "assumption of a counterbody that does not wear",
)


def _thinned(medium: Any, last: WornState) -> Note:
    """Return the note on a layer that has got thinner, with the stiffness of one that has done so all over."""
    share = last.worn_depth / _thickness(medium)
    top = dataclasses.replace(medium.layers[0], thickness=(1.0 - share) * _thickness(medium))
    thinner = dataclasses.replace(medium, layers=(top, *medium.layers[1:]))
    change = last._stiffness(thinner) / last._stiffness(medium) - 1.0
    return Note(
        Assumption.WEAR,
        standing_of(abs(change), SMALL_CHANGE, LARGE_CHANGE),
        f"The maximum wear of the uppermost layer is {100.0 * share:.2g} per cent of its thickness; its initial "
        "thickness is used for the elastic response. If the layer were thinner by this amount everywhere, the "
        f"contact would be {100.0 * abs(change):.2g} per cent {'stiffer' if change > 0.0 else 'softer'}. The "
        "other body is assumed not to wear.",
        MODEL,
    )


def _pulled(state: WornState) -> float:
    """Return which part of the load would be pulled that was taken to be nothing."""
    borne = float(wear_grid(state.bed, state.nodes).transforms.areas @ state.pressure)
    return borne / state._load - 1.0 if state._load > 0.0 else 0.0
