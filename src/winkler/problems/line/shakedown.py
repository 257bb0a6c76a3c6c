r"""Shakedown of a strip that rolls over a body again and again: Melan's limit of the force per length.

Residual stresses that no passage changes are :math:`\rho_x(z)` and :math:`\rho_y(z)`: no others are in equilibrium.
They take up differences of normal stresses but not the shear :math:`\tau_{xz}` in planes along the surface, so that

.. math:: \max_{x,z}\left|\tau_{xz}\right| \le k = \frac{\sigma_Y}{\sqrt3}

bounds the limit: for a cylinder :math:`p_0 = 4k` without friction.  Each depth is examined by itself: with
:math:`u=\sigma_x-\sigma_z,\;v=\sigma_y-\sigma_z` the square of von Mises' stress is
:math:`u^2-uv+v^2+3\tau_{xz}^2`, and residual stresses shift (u, v) of all places of a depth alike.  The least of the
greatest is the radius of the smallest ball about the points
:math:`(u-\tfrac v2,\tfrac{\sqrt3}2v,\pm\sqrt3\tau_{xz})`, the body at rest among them.

A half-plane reaches the bound of the shear where that is greatest below its surface.  At the surface
:math:`p_0=k/\mu` is reached by incompressible bodies only; in others the changes of :math:`\sigma_x` and
:math:`\sigma_y` from edge to edge meet the strength first.
"""

from __future__ import annotations

import functools
import math
from typing import ClassVar, NamedTuple

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.foundation.line_bed import LineBed
from winkler.laws.friction import Overcome
from winkler.numerics.equations.roots import between
from winkler.numerics.equations.smallest_ball import smallest_balls
from winkler.numerics.types import Array
from winkler.problems.assumptions.coupling import sliding_note
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.line.at_strength import Share, at_strength, full_strength, refuse_sharp, refuse_without_strength
from winkler.problems.line.greatest_stress import Placed
from winkler.problems.line.half_width import refuse_unless_strips
from winkler.problems.line.layered_stress import fields_below
from winkler.problems.line.pressing_load import OfWidth
from winkler.problems.line.stress import LineFields, Strip
from winkler.problems.line.validity import line_notes
from winkler.problems.line.yielding import FRICTIONLESS
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

MELAN = "E. Melan, Ing.-Arch. 9 (1938) 116-126, doi:10.1007/BF02084409; K. L. Johnson (1985) sec. 9.2"
BESIDE, AWAY, DEPTHS = 40, 20, 18
"""Places from the middle to the edge and beyond it, and depths, of the first grid."""
SPREADS, SPANS, DEEPEST, FINEST = 2.0, 3.0, 3.0, 1e-3
"""How far a grid reaches: over the width of the load at the top of a part, and beyond the edge over the length on which
layers bend; how deep, and its first depth, over the width."""
FINE, FINE_PLACES, CLOSER, ACTIVE, RIVAL = 7, 6, 3.0, 0.5, 0.95
"""Depths and places to each side of a finer grid, by how much it is narrower; which squares over the greatest have the
places that stay in it, and which stresses over the greatest the depths that are looked at closer."""
COARSE, COARSE_TOLERANCE, REFINED = 0, 1e-3, 5
"""How often grids close in on the greatest while the half-width is sought, to which part it is, and how often then."""
REACHED = 1e-9
"""By which part of the strength the bound of the shear may be exceeded."""
LOWERED = 1e-10
"""To which part the half-width of other profiles is found below that bound."""


@value
class LineShakedown:
    """The force per length up to which a body under repeated rolling shakes down to elastic behaviour.

    Parameters
    ----------
    bed : LineFoundation or LayeredLineFoundation
        Profile and bodies, on a `HalfSpace` or on layers; at least one part has a strength.
    friction : Coulomb, optional
        Coulomb's law of a rolling contact that slides everywhere, with the traction mu p on each body; no friction by
        default.

    Raises
    ------
    InvalidInput
        If no body has a strength, or the medium is not isotropic.
    OutsideValidity
        If there is friction on a layer that slides on the material below.

    References
    ----------
    K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 9.2, doi:10.1017/CBO9781139171731
    """

    __words__ = words(bed=("", None, "profile and bodies of the line contact"))

    bed: LineFoundation | LayeredLineFoundation
    friction: Overcome = FRICTIONLESS

    references: ClassVar[tuple[str, ...]] = ("johnson_1985",)
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED | {Assumption.UNCOUPLED}

    def __post_init__(self) -> None:
        refuse_without_strength(self.bed, "LineShakedown")
        self.bed.refuse_dragged(self.friction.coefficient)

    def solve(self) -> LineShakedownSolution:
        """Return the maximum load, and where the stress is at its limit then.

        Raises
        ------
        OutsideValidity
            If the profile has a sharp tip, kink or rim, or the limit is not met within its reach.
        """
        bed, mu = self.bed, self.friction.coefficient
        refuse_sharp(bed, "LineShakedown")

        def share(half_width: float, refinements: int) -> Placed:
            return _greatest_share(bed, half_width, mu, refinements)

        if isinstance(bed, LayeredLineFoundation):
            a, place = full_strength(bed, share, (COARSE, REFINED), COARSE_TOLERANCE, "LineShakedown")
        else:
            parts = strong_parts(bed.medium)
            a, place = min(
                (at_strength(bed, part, mu, "LineShakedown", _shear_along) for part in parts), key=lambda one: one[0]
            )
            left = share(a, REFINED)
            if left.value > 1.0 + REACHED:
                a = a / left.value if bed.hertzian else _lowered(bed, share, a)
                place = share(a, REFINED)
        refuse_unless_strips(bed, np.array([a]))
        force = bed.medium.modulus * float(bed.load_profile(np.array([a]))[0])
        return LineShakedownSolution(self, force, a, place.x, place.z)


@value
class LineShakedownSolution(OfWidth[float]):
    """The solution of `LineShakedown`.

    Parameters
    ----------
    problem : LineShakedown
        The problem that was solved.
    force_per_length, half_width : float
        [N/m], [m] of the limit.
    x, z : float
        Place of the limiting stress [m] in the axes of the body, with the traction along x. It is that of the shear
        stress, or of von Mises' stress with the best residual stresses if these limit the load. Negative z (also -0.0)
        is in the second body.
    """

    __words__ = words(x=("x", "m", "place along the surface"))

    problem: LineShakedown
    force_per_length: float
    half_width: float
    x: float
    z: float

    @property
    def validity(self) -> tuple[Note, ...]:
        """What is assumed."""
        bed = self.problem.bed
        slid = sliding_note(bed.medium, self.problem.friction.coefficient)  # type: ignore[arg-type]
        note = Note(
            Assumption.ELASTIC,
            Standing.EXACT,
            "Elastic, perfectly plastic solids (von Mises), each with its own strength. The limit is Melan's: at "
            "each depth residual stresses along and across the rolling direction exist with which the body stays "
            "elastic.",
            MELAN,
        )
        return (*line_notes(bed, self.half_width), slid, note)


def _shear_along(fields: LineFields) -> Array:
    """Return what reaches the tensile strength where the shear in planes along the surface reaches k [Pa]."""
    return np.asarray(math.sqrt(3.0) * np.abs(fields.xz_stress))


def _lowered(bed: LineFoundation, share: Share, bound: float) -> float:
    """Return the half-width [m] below a bound at which the share of the strength is one."""

    @functools.cache
    def excess(logarithm: float) -> float:
        return math.log(share(bed.flat + math.exp(logarithm), REFINED).value)

    high = math.log(bound - bed.flat)
    low = high - math.log(2.0)
    while excess(low) >= 0.0:  # stresses vanish with the load
        low -= math.log(2.0)
    return bed.flat + math.exp(between(excess, low, high, absolute=LOWERED))


def _greatest_share(bed: LineBed, half_width: float, friction: float, refinements: int) -> Placed:
    """Return the greatest over all parts of the stress that residual stresses leave, over the strength."""
    best = Placed(0.0, 0.0, 0.0)
    for part in strong_parts(bed.medium):
        place = _left(bed, half_width, part, friction, refinements, best.value * part.solid.strength)
        best = max(best, place._replace(value=place.value / part.solid.strength), key=lambda one: one.value)
    return best


def _left(
    bed: LineBed,
    half_width: float,
    part: StrongPart,
    friction: float,
    refinements: int,
    rival: float = 0.0,
) -> Placed:
    """Return the greatest over all depths of a part of the least stress that residual stresses leave, and its place.

    Grids do not close in on one that is far below another (`rival`) [Pa].
    """
    x, z = _grid(bed, half_width, part, friction)
    near, farthest = half_width / BESIDE, float(x[-1])
    for refinement in range(refinements + 1):
        fields = _fields(bed, half_width, part, friction, (x, z), farthest)
        least = least_stress(fields)
        top = int(np.argmax(least.level))
        if refinement == refinements or least.level[top] < RIVAL * rival:
            break
        padded = np.concatenate([[-1.0], least.level, [-1.0]])
        peaks = (least.level >= np.maximum(padded[:-2], padded[2:])) & (least.level >= RIVAL * least.level[top])
        (rivals,) = np.nonzero(peaks)
        finer = [np.linspace(z[max(i - 1, 0)], z[min(i + 1, z.size - 1)], FINE) for i in rivals.tolist()]
        kept = np.any(least.square[:, rivals] >= ACTIVE, axis=1)
        touched = np.unique(least.touched[:, rivals])
        beside = near * np.linspace(-1.0, 1.0, 2 * FINE_PLACES + 1)
        z = np.unique(np.concatenate([*finer, z[rivals]]))
        x = np.unique(np.concatenate([x[kept], *(x[i] + beside for i in touched if i >= 0)]))
        near /= CLOSER
    at = [int(i) for i in least.touched[:, top] if i >= 0]
    place = at[int(np.argmax(np.abs(fields.xz_stress[at, top])))] if at else 0
    return Placed(float(least.level[top]), float(x[place]), float(z[top] if part.first else -z[top]))


def _grid(bed: LineBed, half_width: float, part: StrongPart, friction: float) -> tuple[Array, Array]:
    """Return the places and depths [m] of the first grid in a part."""
    a, wide = half_width, math.hypot(half_width, part.top)
    first = part.top if part.top == 0.0 else float(np.nextafter(part.top, math.inf))
    last, end = min(part.bottom, first + DEEPEST * wide), SPREADS * wide
    if isinstance(bed, LayeredLineFoundation):
        end = max(end, a + SPANS * math.cbrt(bed.layered.thickness**2 * bed.medium.response.span))
    z = first + (last - first) * np.append(0.0, np.geomspace(FINEST, 1.0, DEPTHS))
    if math.isfinite(part.bottom):
        z = np.unique(np.concatenate([np.minimum(z, last), np.linspace(first, last, DEPTHS // 2), [part.bottom]]))
    within = a * np.sin(0.5 * np.pi * np.linspace(0.0, 1.0, BESIDE + 1))
    x = np.concatenate([within, a + (end - a) * np.linspace(0.0, 1.0, AWAY + 1)[1:] ** 2])
    return x if friction == 0.0 else np.concatenate([-x[:0:-1], x]), z


def _fields(
    bed: LineBed,
    half_width: float,
    part: StrongPart,
    friction: float,
    at: tuple[Array, Array],
    farthest: float,
) -> LineFields:
    """Return the stresses of a part at places and depths [m] ``(n, d)``, with waves for the farthest place."""
    strip, x, z = Strip(half_width, 0.0), at[0][:, None], at[1][None, :]
    waves = bed.waves_below(*strip, farthest) if part.first and isinstance(bed, LayeredLineFoundation) else None
    return fields_below(bed, strip, x, z if part.first else -z, part.first, friction, waves)


class Least(NamedTuple):
    """What residual stresses leave at each depth.

    Parameters
    ----------
    level
        The least of the greatest von Mises stress ``(d,)`` [Pa].
    square
        That of each place ``(n, d)``, squared, over the level squared [-].
    touched
        Numbers of up to three places that have that stress ``(3, d)``; -1 for none.
    """

    level: Array
    square: Array
    touched: Array


def least_stress(fields: LineFields) -> Least:
    """Return the least of the greatest von Mises stress of places at depths ``(n, d)`` that residual stresses leave.

    They act along x and y and are the same at all places of a depth; the body at rest counts as a place.
    """
    u, v = fields.xx_stress - fields.zz_stress, fields.yy_stress - fields.zz_stress
    points = u - 0.5 * v, 0.5 * math.sqrt(3.0) * v, 3.0 * fields.xz_stress**2
    depths = u.shape[1]
    across, down, raised = (np.vstack([one, np.zeros((1, depths))]) for one in points)
    squares, centre, touched = np.empty(depths), np.empty((2, depths)), np.empty((3, depths), dtype=np.int64)
    smallest_balls(across, down, raised, squares, centre, touched)
    reached = ((across - centre[0]) ** 2 + (down - centre[1]) ** 2 + raised)[:-1]
    safe = np.where(squares > 0.0, squares, 1.0)
    return Least(np.sqrt(squares), reached / safe, np.where(touched < u.shape[0], touched, -1))
