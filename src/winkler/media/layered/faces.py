r"""What lies below a face, by the minors of its states: layers are crossed without a difference of large numbers.

Two states of displacements and tractions, (U, W, T, S), are all that a face allows; each other one is made of them.
The six determinants of two of their four rows do not depend on which two states are taken, and each of them is a sum of
terms that do not cancel where stiff thin layers lie on soft ones, or on what slides: in
:math:`W/S = -m_{WT}/m_{TS}` neither a compliance nor a stiffness has to be inverted (Dunkin's minors, of waves in the
earth).  A thin layer is crossed by the minors of its propagator, a thick one by a reflection, whose elements are ratios
of determinants of four such columns.

References
----------
.. [1] J. W. Dunkin, Computation of modal solutions in layered, elastic media at high frequencies, Bull. Seismol. Soc.
   Am. 55 (1965) 335-358, doi:10.1785/BSSA0550020335
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

import numpy as np

from winkler.media.layered.blocks import Four, scaled, times
from winkler.media.layered.wave_constants import WaveConstants
from winkler.numerics.types import Array, ComplexArray

Face: TypeAlias = tuple[ComplexArray, ComplexArray, ComplexArray, ComplexArray, ComplexArray, ComplexArray]
"""The minors UW, UT, US, WT, WS, TS, but for a factor."""

PAIRS = ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3))
SIGNS = (1.0, -1.0, 1.0, 1.0, -1.0, 1.0)
"""Of a pair of rows times the other two, in a determinant of four."""
THIN_LAYER_LIMIT = 1.0
"""Up to this, the steepest exponent times xi h, a layer is crossed by its propagator."""
LEAST_WAVE = 1e-60
"""Stands for xi h = 0, where a free layer moves sideways without bound."""


def face_of(compliance: Four) -> Face:
    """Return the minors of a face with a compliance: of the states (Y, 1)."""
    a, b, c, d = compliance
    return a * d - b * c, -b, a, -d, c, np.ones_like(a)


def compliance_of(face: Face) -> Four:
    """Return the compliance of a face, displacements per tractions."""
    _, ut, us, wt, ws, ts = face
    return us / ts, -ut / ts, ws / ts, -wt / ts


def slid(face: Face) -> Face:
    """Return what a face is to a layer that slides on it: W = Y_WW S, U as it likes, no shear."""
    nothing = np.zeros_like(face[0])
    return -face[3], nothing, face[5], nothing, nothing, nothing


def rescaled(face: Face, modulus: ComplexArray | float) -> Face:
    """Return the minors with tractions over a modulus [Pa], times that modulus."""
    return face[0] * modulus, *face[1:5], face[5] / modulus


def above(constants: WaveConstants, face: Face, x: ComplexArray) -> Face:
    """Return the upper face of a layer.

    Parameters
    ----------
    constants : WaveConstants
        Its solid.
    face : Face
        What is below it.
    x : ndarray, (m,)
        xi times its thickness.
    """
    thin = np.abs(x) * constants.steepest <= THIN_LAYER_LIMIT
    x = np.where(np.abs(x) < LEAST_WAVE, LEAST_WAVE, x)
    below = rescaled(face, constants.shear)
    result = [np.empty_like(x) for _ in PAIRS]
    for chosen, crossed in ((thin, _propagated), (~thin, _reflected)):
        if chosen.any():
            part: Face = tuple(np.broadcast_to(minor, x.shape)[chosen] for minor in below)  # type: ignore[assignment]
            for minor, found in zip(result, crossed(constants, part, x[chosen]), strict=True):
                minor[chosen] = found
    return rescaled(tuple(result), 1.0 / constants.shear)  # type: ignore[arg-type]


def _propagated(constants: WaveConstants, face: Face, x: ComplexArray) -> Face:
    uu, ut, tu, tt = constants.propagator(x)
    rows = [(*uu[:2], *ut[:2]), (*uu[2:], *ut[2:]), (*tu[:2], *tt[:2]), (*tu[2:], *tt[2:])]
    result = []
    for i, j in PAIRS:
        terms = [
            (rows[i][k] * rows[j][n] - rows[i][n] * rows[j][k]) * minor
            for (k, n), minor in zip(PAIRS, face, strict=True)
        ]
        result.append(sum(terms[1:], terms[0]))
    return tuple(result)


def _reflected(constants: WaveConstants, face: Face, x: ComplexArray) -> Face:
    """Return the minors of the states D + G K: fields that decay from above, and what comes back of them."""
    down = constants.decay(x)
    back = times(times(mirrored(down), reflection(constants, face)), down)
    a, b, c, d = times(constants.rising_half_space, back)
    own = constants.half_space
    columns = ((own[0] + a, own[2] + c, 1.0 + back[0], back[2]), (own[1] + b, own[3] + d, back[1], 1.0 + back[3]))
    return tuple(columns[0][i] * columns[1][j] - columns[0][j] * columns[1][i] for i, j in PAIRS)  # type: ignore[return-value]


def reflection(constants: WaveConstants, face: Face) -> Four:
    """Return the tractions of the field that comes back from a face, per those of the one that arrives there."""
    falling, rising = (
        ((four[0], four[2], 1.0, 0.0), (four[1], four[3], 0.0, 1.0))
        for four in (constants.half_space, constants.rising_half_space)
    )

    def volume(first: Sequence[Array | float], second: Sequence[Array | float]) -> ComplexArray:
        minors = [float(first[i] * second[j] - first[j] * second[i]) for i, j in PAIRS]
        terms = [sign * minor * other for sign, minor, other in zip(SIGNS, face, minors[::-1], strict=True) if other]
        return np.asarray(sum(terms[1:], terms[0]))

    whole = volume(*rising)
    parts = [volume(falling[j], rising[1]) for j in (0, 1)] + [volume(rising[0], falling[j]) for j in (0, 1)]
    return scaled(-1.0 / whole, (parts[0], parts[1], parts[2], parts[3]))


def mirrored(four: Four) -> Four:
    """Return the same for the fields that decay upward."""
    return four[0], -four[1], -four[2], four[3]
