r"""Rough lines on layers and gradings: springs as stiff as the flat punch that is as wide as what touches.

On a homogeneous half-space n springs of the spacing :math:`\Delta x` are as stiff as a flat punch of the radius
:math:`n\Delta x/2`, wherever they are.  On layers they are taken to be so, too: few springs feel the uppermost layer,
many what lies below, and a smooth body comes out as it is.  Areas and gaps are Persson's, each wave under the modulus
:math:`E^*/(1+M(q))` that it meets.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.media.halfspace import HomogeneousMedium
from winkler.media.mapped import MappedMedium, layers_of
from winkler.media.offers import PressedWaves, offers
from winkler.numerics.types import Array
from winkler.profiles.rough.spectrum import Spectrum, wave_numbers_for
from winkler.values.errors import OutsideValidity

RADII = 129
"""Flat punches between which the logarithm of the stiffness is interpolated."""
WIDEST_PUNCH = 1000.0
"""Times the thickness of all layers, beyond which the stiffness goes on as a power of the radius: to 0.5 per cent."""
WAVE_NUMBERS = 2001


def line_stiffnesses(medium: MappedMedium, count: int, spacing: float) -> Array:
    """Return the stiffness [N/m] of the first 1, 2, ... springs that touch; empty on homogeneous bodies.

    Parameters
    ----------
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace, DepthGradedHalfSpace or GradedHalfSpace
    count : int
        Springs.
    spacing : float
        Of them [m].
    """
    if isinstance(medium, HomogeneousMedium):
        return np.zeros(0)
    from scipy.interpolate import PchipInterpolator

    radii = 0.5 * spacing * np.arange(1.0, count + 1.0)
    most = WIDEST_PUNCH * medium.thickness if offers(medium, PressedWaves) else math.inf
    widest = max(min(float(radii[-1]), most), 2.0 * float(radii[0]))
    some = np.log(np.geomspace(radii[0], widest, RADII))
    stiffness = np.log(medium.punch_stiffness(np.exp(some)))
    place, slope = np.log(radii), (stiffness[-1] - stiffness[-2]) / (some[-1] - some[-2])
    inside = PchipInterpolator(some, stiffness)(np.minimum(place, some[-1]))
    return np.asarray(np.exp(inside + slope * np.maximum(place - some[-1], 0.0)))


def moduli_of_waves(medium: MappedMedium, q: Array) -> Array:
    """Return the modulus [Pa] that waves of the wave numbers q [1/m] meet."""
    layers = layers_of(medium)
    return np.full(q.shape, medium.modulus) if layers is None else medium.modulus / layers.whole(q)


def slope_modulus(medium: MappedMedium, spectrum: Spectrum) -> float:
    """Return the root mean square of the slopes times the modulus of their waves [Pa]; E* h' of homogeneous bodies."""
    if isinstance(medium, HomogeneousMedium):
        return medium.modulus * spectrum.rms_slope
    q = wave_numbers_for(spectrum, WAVE_NUMBERS, crowded=2.0)
    power = 2.0 * math.pi * q**4 * spectrum.at(q) * moduli_of_waves(medium, q) ** 2
    return math.sqrt(float(np.trapezoid(power, np.log(q))))


def conducting_medium(owner: str, medium: MappedMedium) -> HomogeneousMedium:
    """Return the medium whose stiffness tells what it conducts.

    Raises
    ------
    OutsideValidity
        If it has layers.
    """
    if not isinstance(medium, HomogeneousMedium):
        raise OutsideValidity(
            f"{owner}: on a {type(medium).__name__} stiffness does not tell the conductance; give a HalfSpace."
        )
    return medium
