r"""How much energy an impact sends away as waves.

Hunter found that a ball which strikes a half-space of its own material with the velocity v loses about
:math:`1.04\,(v/c_0)^{3/5}` of its energy to waves, with :math:`c_0=\sqrt{E^*/\rho}`.  The density is taken as that of a
ball of the given mass and size.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.types import Quantity
from winkler.values.validity import Assumption, Note, Standing, standing_of

SMALL_WAVE_LOSS, LARGE_WAVE_LOSS = 0.02, 0.3
"""Share of the energy that waves carry away [-], up to which slow motion is the limit, and from which on it is none."""
VERDICTS = {
    Standing.ASYMPTOTIC: "slow compared with the speed of sound, as the theory assumes",
    Standing.APPROXIMATE: "this loss is neglected",
    Standing.OUTSIDE: "too fast for a quasi-static contact force",
}
HUNTER = (
    "S. C. Hunter, J. Mech. Phys. Solids 5 (1957) 162-171, doi:10.1016/0022-5096(57)90002-9; K. L. Johnson, Contact "
    "Mechanics, Cambridge 1985, sec. 11.4, doi:10.1017/CBO9781139171731"
)


def wave_loss(*, modulus: Quantity, mass: Quantity, size: Quantity, velocity: Quantity) -> float:
    """Return the share of the energy of an impact that waves carry away, about [-]; of several impacts the greatest.

    Parameters
    ----------
    modulus : float or ndarray
        E* [Pa], or its greatest value if it relaxes.
    mass : float or ndarray
        [kg].
    size : float or ndarray
        Radius of the body [m]; the result is zero if it is infinite, which stands for one that is not known.
    velocity : float or ndarray
        Of approach [m/s].

    Examples
    --------
    A steel ball of 10 mm radius on steel at 1 m/s (Hunter: c_0 from E, a sixth less).

    >>> round(wave_loss(modulus=115.4e9, mass=7850 * 4.18879e-6, size=10e-3, velocity=1.0), 4)
    0.0074
    """
    density = np.asarray(mass) / (4.0 / 3.0 * math.pi * np.asarray(size, dtype=float) ** 3)
    fastest = float(np.max(np.abs(velocity) * np.sqrt(density / modulus)))
    return float(1.04 * fastest**0.6)


def wave_note(share: float) -> Note:
    """Return whether the contact force may be that of slow motion; `share` as `wave_loss` returns it."""
    if not share < math.inf or share == 0.0:
        return Note(
            Assumption.INERTIA,
            Standing.ASYMPTOTIC,
            "The contact force is the quasi-static force. The size of the body is not known, so two conditions "
            "were not checked. The impact must be slow compared with the speed of sound, and long compared with "
            "a vibration period of the body.",
            HUNTER,
        )
    standing = standing_of(share, SMALL_WAVE_LOSS, LARGE_WAVE_LOSS)
    return Note(
        Assumption.INERTIA,
        standing,
        f"Elastic waves carry away about {100.0 * share:.2g} % of the energy, if both bodies have the density of "
        f"a ball of this mass and size: {VERDICTS[standing]}.",
        HUNTER,
    )
