r"""What sticks of a fretting line contact: before wear, and in the end.

The load profile :math:`w(c)` of a half-width c depends on the profile within c alone.  On half-planes what sticks under
a swing Q of the shear force is the contact of the load :math:`\gamma = P - Q/\mu`, :math:`E^*w(c) = \gamma`: wear
outside of it does not change it, and inside nothing slips.  In the end it bears all of P; beside it the worn surfaces
just touch.

On layers what slips bears is another part of Q, which wear takes away.  In the end the core bears alone, and its edge
sticks if

.. math:: Q\,\varphi_L(c;c) \le \mu\,(P-E^*w(c))\,\varphi_N(c;c) ,

the singular traction beside the singular pressure of flat punches (`winkler.numerics.transforms.strips.strip_punches`).
A core that does not hold this shrinks to where it does; one that holds it grows somewhat while its surroundings wear,
by how much depends on the order in which they do.
"""

from __future__ import annotations

import functools
from typing import NamedTuple

import numpy as np

from winkler.foundation.line_bed import LineBed
from winkler.laws.friction import Coulomb
from winkler.loading.loads import LineForce, LineShearForce
from winkler.numerics.equations.bracketing import between
from winkler.numerics.types import Array
from winkler.problems.line.half_width import grows, refuse_unless_strips, under_force
from winkler.problems.wear.grids import wear_grid
from winkler.problems.wear.nodes import graded_nodes
from winkler.values.errors import OutsideValidity

CELLS, REACH = 256, 1.02
"""Cells of the even grid on which what sticks on layers before wear is found, and their reach over the half-width."""
SAMPLES = 65


class StuckCore(NamedTuple):
    """What sticks of a line contact under a shear force that swings.

    Parameters
    ----------
    bed : LineBed
    half_width, excess : float
        c [m], and the load per length over E* that its edge bears in the end [m].
    first, alone : float
        What sticks before wear, and at most where it bears alone [m]; on half-planes both are c.
    """

    bed: LineBed
    half_width: float
    excess: float
    first: float
    alone: float

    def worn(self, x: Array) -> Array:
        """Return the worn depth in the end [m] at places from c to the end of the worn part."""
        return -self.bed.separation(x, self.half_width, self.excess)

    def outer_half_width(self) -> float:
        """Return where the worn part ends [m]: at the rim, if nothing ends it before.

        Raises
        ------
        OutsideValidity
            If that is beyond what is known of the profile.
        """
        end = min(self.bed.reach, self.bed.rim)
        low = high = self.half_width * (1.0 + 1e-9)
        while float(self.worn(np.array([high]))[0]) > 0.0:
            if high == end == self.bed.rim:
                return high
            if high == end:
                raise OutsideValidity(
                    f"The worn contact ends beyond {end:.6g} m, as far as the profile is known; give one that is known "
                    "farther out."
                )
            low, high = high, min(2.0 * high, end)
        return float(between(lambda x, _: self.worn(x), np.array([low]), np.array([high]))[0])


def stuck_core(owner: str, bed: LineBed, law: Coulomb, normal: LineForce, amplitude: LineShearForce) -> StuckCore:
    """Return what sticks of a contact; refuse one of which everything slides.

    Parameters
    ----------
    owner : str
        Name of the problem.
    bed, law, normal, amplitude
        As of `LineLimitingProfile`.

    Raises
    ------
    OutsideValidity
        If friction does not bear the shear force, or the bodies touch in several strips.
    """
    force, swing = float(normal.force_per_length), float(amplitude.shear_force_per_length)
    most = law.coefficient * force
    if swing >= most:
        raise OutsideValidity(
            f"{owner}: friction carries {most:.6g} N/m, and the bodies slide away under a shear force of {swing:.6g} "
            "N/m; give less, or follow sliding with LineSlidingWear."
        )
    modulus = float(bed.medium.modulus)
    load, excess = (force - swing / law.coefficient) / modulus, swing / law.coefficient / modulus
    outer = float(under_force(bed, np.array([force / modulus]))[0])
    refuse_unless_strips(bed, np.array([outer]))
    refuse_unless_rising(owner, bed, outer)
    if bed.sheared_as_pressed:
        inner = float(under_force(bed, np.array([load]))[0])
        return StuckCore(bed, inner, excess, inner, inner)
    first, alone = _stuck_before(bed, law.coefficient, force, swing, outer), _stuck_alone(bed, force, load, outer)
    core = min(first, alone)
    refuse_unless_strips(bed, np.array([core]))
    excess = force / modulus - float(bed.load_profile(np.array([core]))[0])
    return StuckCore(bed, core, excess, first, alone)


@functools.lru_cache(maxsize=16)
def _stuck_before(bed: LineBed, coefficient: float, force: float, swing: float, half_width: float) -> float:
    """Return what sticks on layers before wear [m]."""
    grid = wear_grid(bed, graded_nodes(0.0, min(REACH * half_width, bed.rim), bed.rim, CELLS))
    contact = grid.press(np.zeros(grid.nodes.size), LineForce(force))
    return min(grid.rub(contact, coefficient, swing).stick_half_width, half_width)


def _stuck_alone(bed: LineBed, force: float, load: float, half_width: float) -> float:
    """Return the widest core on layers whose edge sticks if it bears alone [m]; load is that of half-planes [m]."""
    whole = force / float(bed.medium.modulus)

    def margin(x: Array) -> Array:
        pressed, pushed = bed.punch_edges(x)
        return np.asarray(pressed * (whole - bed.load_profile(x)) - pushed * (whole - load))

    place = half_width * np.linspace(0.0, 1.0, SAMPLES)
    sticks = margin(place) >= 0.0
    if np.all(sticks):
        return half_width
    last = int(np.argmin(sticks)) - 1
    return float(between(lambda x, _: margin(x), place[last : last + 1], place[last + 1 : last + 2])[0])


def refuse_unless_rising(owner: str, bed: LineBed, half_width: float) -> None:
    """Refuse a profile that lets the load fall while the contact grows, up to a half-width [m]."""
    if not (bed.profile.rising or grows(bed, half_width)):
        raise OutsideValidity(
            f"{owner}: up to {half_width:.6g} m the profile lets the load fall again, so that the bodies may touch in "
            "several strips; give a smoother profile or a smaller load."
        )
