"""How a body on layers responds, of which one solid relaxes by a law of its own: fast enough for a fit.

The waves of the stack are fitted once for a range of moduli (`winkler.numerics.transforms.modulus_waves`), and moved
onto cells once for each reach; new numbers of the solid only change with what weights they act, and in what times.
"""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.on_medium import UnderProfile
from winkler.materials.elastic import Rigid
from winkler.materials.relaxing_layer import ViscoelasticLayer
from winkler.materials.viscoelastic import Prony, ViscoelasticSolid
from winkler.media.relaxing.layered import ViscoelasticCoatedHalfSpace
from winkler.numerics.springs.coupled_cells import CoupledCells
from winkler.numerics.springs.driven_cells import cosine_basis, march
from winkler.numerics.transforms.modulus_waves import ModulusWaves, creep_of_poles, fit_modulus_waves
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput, NotConverged

DECADE = 0.5
"""Ranges of moduli end at powers of ten by this step, so that one serves many numbers."""


DIGITS = 9
"""Of the lengths of steps; those that agree in them share what is computed for one."""


class TooWide(Exception):
    """The contact has reached the last cell."""


class LayeredHistory(NamedTuple):
    """Force [N], depth [m] and contact radius [m], each ``(n,)``."""

    force: Array
    depth: Array
    radius: Array


class StackWaves(NamedTuple):
    """What a stack, a body and a grid of cells have in common at all moduli.

    Parameters
    ----------
    poles : ndarray, (1 + M,)
        [Pa].
    cells : CoupledCells
        Under the body, with kernels of the constant and of the poles; their times are not used.
    near, mirrored : ndarray of int, (n, n)
        Distances between cells, and between cells and mirror images.
    """

    poles: Array
    cells: CoupledCells
    near: Array
    mirrored: Array


def relaxing_solid(bed: Bed) -> ViscoelasticSolid:
    """Return the one solid of a stack that relaxes; refuse several, and beds without a profile."""
    assert isinstance(bed.medium, ViscoelasticCoatedHalfSpace)
    if not isinstance(bed, UnderProfile):
        raise InvalidInput(
            "fit: layers with separate relaxation functions need Foundation(profile, medium) of a body of revolution."
        )
    solids = bed.medium.relaxing_solids
    if len(solids) > 1:
        raise InvalidInput(
            f"fit: {len(solids)} solids of the layered body relax, and the law of one of them can be fitted; give the "
            "others as Elastic or Rigid."
        )
    return solids[0]


def stack_waves(bed: Bed, reach: float, count: int) -> StackWaves:
    """Return the waves of a stack on cells up to a radius [m]; cached by all but the numbers of the solid that relaxes.

    Raises
    ------
    NotConverged
        If the cells are too wide against the layers, or the moduli vary too much.
    """
    assert isinstance(bed, UnderProfile)
    solid, medium = relaxing_solid(bed), bed.medium
    assert isinstance(medium, ViscoelasticCoatedHalfSpace)
    low = math.floor(math.log10(solid.series.relaxed) / DECADE) * DECADE
    high = math.ceil(math.log10(solid.series.glassy) / DECADE) * DECADE
    unit = Prony(1.0, np.ones(1), np.ones(1), poisson=solid.poisson)
    layers = tuple(
        ViscoelasticLayer(unit, layer.thickness) if isinstance(layer, ViscoelasticLayer) else layer
        for layer in medium.layers
    )
    bodies = (unit if body == solid else body for body in (medium.on, medium.second))
    still = ViscoelasticCoatedHalfSpace(layers, *bodies)
    return _on_cells(still, bed.with_medium(still), (10.0**low, 10.0**high), min(reach, bed.rim), count)


@functools.lru_cache(maxsize=16)
def _waves(medium: ViscoelasticCoatedHalfSpace, moduli: tuple[float, float]) -> ModulusWaves:
    stacks = [medium.elastic_with(lambda _, modulus=one: modulus) for one in moduli]  # type: ignore[misc]
    ends = [stack.response for stack in stacks]
    others = (*(layer.solid for layer in medium.layers), medium.on, medium.second)
    alone = all(isinstance(solid, ViscoelasticSolid | Rigid) for solid in others)
    span, length = max(end.span for end in ends), min(end.length for end in ends)
    return fit_modulus_waves(medium.waves_at_modulus, moduli, span, length, alone=alone)


@functools.lru_cache(maxsize=32)
def _on_cells(
    medium: ViscoelasticCoatedHalfSpace, bed: UnderProfile, moduli: tuple[float, float], reach: float, count: int
) -> StackWaves:
    width = reach / count
    found = _waves(medium, moduli)
    shape = np.asarray(bed.profile.gap(width * (np.arange(count) + 0.5)), dtype=float)
    cells = CoupledCells(found.waves.kernels(count, width), found.poles, width, shape)
    place = np.arange(count)
    return StackWaves(found.poles, cells, np.abs(place[:, None] - place), place[:, None] + place + 1)


def along_path(
    waves: StackWaves, solid: ViscoelasticSolid, time: Array, driven: Array, given: tuple[float, float]
) -> LayeredHistory:
    """Return the response at all points of a path.

    Parameters
    ----------
    waves : StackWaves
    solid : ViscoelasticSolid
    time : ndarray, (n,)
        [s]; what happens at the first is sudden.
    driven : ndarray, (n,)
        a d + b F.
    given : (float, float)
        a, b.

    Raises
    ------
    TooWide
        If the contact reaches the last cell.
    NotConverged
        If the compliance of the cells is lost in rounding.
    """
    from scipy.linalg.lapack import dtrtrs

    cells, count = waves.cells, waves.cells.count
    glassy, compliances, times = creep_of_poles(solid.series, waves.poles)
    lengths, which = _lengths(time)
    turns = lengths[:, None, None] / times
    fades = np.exp(-turns)
    with np.errstate(invalid="ignore"):
        shares = np.where(turns > 0.0, -np.expm1(-turns) / turns, 1.0)
    parts = glassy + np.einsum("smn,mn->sm", 1.0 - shares, compliances)
    kernels = cells.kernels[0] + parts @ cells.kernels[1:]
    try:
        lowers = np.linalg.cholesky(kernels[:, waves.near] + kernels[:, waves.mirrored])
    except np.linalg.LinAlgError as failed:
        raise NotConverged(
            "fit: the compliance of the layers is lost in rounding: the contact is too wide against them, or their "
            "contrast too large; give bounds nearer to the answer."
        ) from failed
    units = np.stack([dtrtrs(lower, np.full(count, cells.width), lower=1)[0] for lower in lowers])
    remembered = (compliances[:, :, None] * cells.waves[1:, None, :]).reshape(-1, 2 * count)
    depth, force, radius = (np.zeros(time.size) for _ in range(3))
    done = march(
        np.ascontiguousarray(driven, dtype=float), float(given[0]), float(given[1]), which, lowers, units,
        fades.reshape(lengths.size, -1), shares.reshape(lengths.size, -1), remembered, cosine_basis(count),
        cells.shape, cells.width, depth, force, radius,
    )  # fmt: skip
    if done < time.size:
        raise TooWide
    return LayeredHistory(force, depth, radius)


def _lengths(time: Array) -> tuple[Array, Array]:
    """Return the different lengths of steps [s], and which of them leads to each point; the first is sudden."""
    spans = np.concatenate([[0.0], np.diff(time)])
    with np.errstate(divide="ignore"):
        digit = 10.0 ** (np.floor(np.log10(np.where(spans > 0.0, spans, 1.0))) - DIGITS)
    lengths, which = np.unique(np.rint(spans / digit) * digit, return_inverse=True)
    return lengths, which.astype(np.int64)
