r"""What sticks of a fretting line contact, and stays as it is whatever wears outside.

The load profile :math:`w(c)` of a half-width c depends on the profile within c alone.  What sticks under a swing Q of
the shear force is the contact of the load :math:`\gamma = P - Q/\mu`, :math:`E^*w(c) = \gamma`: wear outside of it does
not change it, and inside nothing slips.  In the end it bears all of P; beside it the worn surfaces just touch.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.errors import OutsideValidity
from winkler.foundation.line import LineFoundation
from winkler.laws.friction import Coulomb
from winkler.loading import LineForce, LineShearForce
from winkler.numerics.equations.bracketing import between
from winkler.numerics.types import Array
from winkler.problems.line.half_width import grows, refuse_unless_strips, under_force
from winkler.problems.line_friction.strips import EarlierStrip, opened

__all__ = ["StuckCore", "refuse_unless_rising", "stuck_core"]


class StuckCore(NamedTuple):
    """What sticks of a line contact under a shear force that swings, whatever has been worn off outside.

    Parameters
    ----------
    bed : LineFoundation
    half_width : float
        c [m].
    load, excess : float
        gamma/E* and Q/(mu E*) [m].
    """

    bed: LineFoundation
    half_width: float
    load: float
    excess: float

    def worn(self, x: Array) -> Array:
        """Return the worn depth in the end [m] at places from c to the end of the worn part."""
        c = self.half_width
        strip = EarlierStrip(1.0, self.load, c, 0.0, 0.0)
        root = np.sqrt(np.maximum((x - c) * (x + c), 0.0))
        # arcosh(x/c) without what x/c = 1 would lose
        return np.asarray(2.0 / math.pi * self.excess * np.arcsinh(root / c) - opened(self.bed, strip, x))

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


def stuck_core(
    owner: str, bed: LineFoundation, law: Coulomb, normal: LineForce, amplitude: LineShearForce
) -> StuckCore:
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
            f"{owner}: friction bears {most:.6g} N/m, and the bodies slide away under a shear force of {swing:.6g} "
            "N/m; give less, or follow sliding with LineSlidingWear."
        )
    modulus = float(bed.medium.modulus)
    load, excess = (force - swing / law.coefficient) / modulus, swing / law.coefficient / modulus
    inner, outer = under_force(bed, np.array([load, force / modulus])).tolist()
    refuse_unless_strips(bed, np.array([outer]))
    refuse_unless_rising(owner, bed, outer)
    return StuckCore(bed, inner, load, excess)


def refuse_unless_rising(owner: str, bed: LineFoundation, half_width: float) -> None:
    """Refuse a profile that lets the load fall while the contact grows, up to a half-width [m]."""
    if not (bed.profile.rising or grows(bed, half_width)):
        raise OutsideValidity(
            f"{owner}: up to {half_width:.6g} m the profile lets the load fall again, so that the bodies may touch in "
            "several strips; give a smoother profile or a smaller load."
        )
