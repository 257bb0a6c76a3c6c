r"""Whether a law of adhesion agrees with the range of molecular forces, by Tabor's parameter.

:math:`\mu_T` is the stretch of the surfaces at the edge over the range of attraction.  Attraction without range (JKR)
is the limit of large, attraction that deforms nothing (DMT) that of small :math:`\mu_T`; at 0.5 the pull-off force of
a ball is some 15 per cent from either.
"""

from __future__ import annotations

import math

from winkler.laws.adhesion import AdhesionLaw, ShortRange
from winkler.values.validity import Assumption, Note, Standing

PULL_OFF_STRETCH = math.sqrt(2.0 * math.pi) * (9.0 * math.pi / 8.0) ** (1.0 / 6.0)
"""Stretch of a paraboloid's edge at its pull-off without range, in units of (R w^2 / E*^2)^(1/3)."""
MOLECULAR_RANGE = 0.3e-9
"""Range of attraction between molecules [m], about the distance of atoms."""
SHORT_RANGE_TABOR, MIDDLE_TABOR, LONG_RANGE_TABOR = 5.0, 0.5, 0.1
"""Tabor's parameter above which attraction is without range (JKR), below which it deforms nothing (DMT), and between
them that at which each is wrong by some 15 per cent."""
GREENWOOD = "K. L. Johnson, J. A. Greenwood, J. Colloid Interface Sci. 192 (1997) 326-333, doi:10.1006/jcis.1997.4984"


def range_note(law: AdhesionLaw, stretch: float, where: str) -> Note:
    """Return whether attraction may be without range (JKR), or so far that it deforms nothing (DMT).

    Parameters
    ----------
    law : ShortRange or DerjaguinMullerToporov
        What was assumed.
    stretch : float
        By how much attraction without range would stretch the springs at the edge [m].
    where : str
        What the sentence begins with, up to "the edge".
    """
    tabor = stretch / (PULL_OFF_STRETCH * MOLECULAR_RANGE)
    fact = (
        f"{where} the edge is stretched by {stretch:.3g} m, {stretch / MOLECULAR_RANGE:.3g} times a molecular "
        f"range of {MOLECULAR_RANGE:.1g} m. The Tabor parameter is {tabor:.3g}"
    )
    if isinstance(law, ShortRange):
        good, bad = tabor >= SHORT_RANGE_TABOR, tabor < MIDDLE_TABOR
        right, wrong = (
            "the limit of short range (JKR) is valid",
            "the range of attraction is longer than JKR assumes",
        )
    else:
        good, bad = tabor <= LONG_RANGE_TABOR, tabor > MIDDLE_TABOR
        right, wrong = (
            "the limit of long range (DMT) is valid",
            "the attraction deforms the edge, which DMT neglects",
        )
    standing = Standing.ASYMPTOTIC if good else Standing.OUTSIDE if bad else Standing.APPROXIMATE
    closest = f"use Dugdale(work, strength) with strength = {law.work / MOLECULAR_RANGE:.3g} Pa"
    verdict = right if good else f"{wrong if bad else 'between JKR and DMT'}; {closest}"
    return Note(Assumption.ADHESION, standing, f"{fact}: {verdict}.", GREENWOOD)
