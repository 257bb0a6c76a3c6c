r"""Modulus and hardness from stiffness, force and depth of an indentation, with the area of the tip.

.. math:: h_c = h - \epsilon\,\frac FS, \qquad E_r = \frac{\sqrt\pi}{2\beta}\,\frac S{\sqrt{A(h_c)}}, \qquad
          H = \frac F{A(h_c)}

Nothing but the area at the one depth :math:`h_c` is needed: the polynomial of a calibrated tip may have any shape
elsewhere, as near the apex, where calibrations often dip or become negative.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.materials.elastic import Elastic, Rigid, Solid
from winkler.numerics.equations.roots import between
from winkler.profiles.area import AreaFunction
from winkler.profiles.area_coefficients import AreaCoefficients
from winkler.profiles.calibrated_tip import CalibratedTip, TabulatedTip
from winkler.profiles.profile import Profile
from winkler.profiles.pyramids.pyramid import PyramidShape
from winkler.profiles.pyramids.rounded_pyramid import RoundedPyramid
from winkler.values.checks.number_checks import NonNegative, PositiveOrInfinite
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.value import value, words


def intercept_factor(exponent: float) -> float:
    """Return epsilon [-] of a body that unloads with an exponent m > 1; 1 for m = 1.

    Examples
    --------
    >>> intercept_factor(1.5), round(intercept_factor(2.0), 6)
    (0.75, 0.72676)
    """
    if exponent - 1.0 < 1e-6:
        return 1.0
    half = 0.5 / (exponent - 1.0)
    ratio = math.exp(math.lgamma(exponent * half) - math.lgamma(half))
    return exponent * (1.0 - 2.0 * (exponent - 1.0) * ratio / math.sqrt(math.pi))


@value
class CalibratedArea:
    """Cross-section of a calibrated tip, A(h) = C0 h^2 + C1 h + C2 h^(1/2) + C3 h^(1/4) + ..., where it was calibrated.

    `AreaFunction` is the body of revolution with this area, and requires an area that grows from the apex on. A
    `CalibratedArea` has no such restriction.

    Parameters
    ----------
    coefficients : sequence of float
        C0 [-], C1 [m], C2 [m^(3/2)], C3 [m^(7/4)], ...: the n-th belongs to h^(2^(1-n)).
    shallowest, deepest : float, optional
        Contact depths [m] between which it was calibrated; by default 0 and infinity, which mean "not known".

    Raises
    ------
    InvalidInput
        If a coefficient is not finite, or `deepest` is not greater than `shallowest`.
    """

    __words__ = words(
        shallowest=("h_c", "m", "smallest contact depth of the calibration"),
        deepest=("h_c", "m", "greatest contact depth of the calibration"),
    )

    coefficients: AreaCoefficients
    shallowest: NonNegative = 0.0
    deepest: PositiveOrInfinite = math.inf

    def __post_init__(self) -> None:
        if not 0.0 <= self.shallowest < self.deepest:
            raise InvalidInput(
                f"CalibratedArea: it is calibrated from {self.shallowest!r} to {self.deepest!r} m; give two depths "
                "that grow, from zero on."
            )

    def area(self, height: float) -> float:
        """Return A [m^2] at a distance from the apex [m]."""
        return polynomial(self.coefficients, height)

    def profile(self, shape_factor: float = 1.0) -> CalibratedTip:
        """Return the body of revolution with these areas, for contacts and fits; both depths must be known.

        Parameters
        ----------
        shape_factor : float, optional
            beta [-], the factor by which its radii are multiplied.
        """
        return CalibratedTip(self.coefficients, self.shallowest, self.deepest, shape_factor)


Tip = Profile | CalibratedArea
"""A tip with a cross-section at the contact depth."""


def polynomial(coefficients: tuple[float, ...], height: float) -> float:
    """Return A(h) [m^2] of the coefficients of a calibrated tip."""
    return math.fsum(c * height ** (2.0 ** (1 - n)) for n, c in enumerate(coefficients))


@value
class ContactReading:
    """Result of the evaluation of one contact stiffness.

    Parameters
    ----------
    contact_depth : float
        h_c [m].
    area : float
        Projected area of contact [m^2].
    modulus : float
        Reduced modulus E_r [Pa], that of the pair.
    hardness : float
        [Pa].
    """

    __words__ = words(modulus=("E_r", "Pa", "reduced modulus, that of the pair"))

    contact_depth: float
    area: float
    modulus: float
    hardness: float


def contact_reading(
    stiffness: float, force: float, depth: float, tip: Tip, *, intercept: float = 0.75, shape_factor: float = 1.0
) -> ContactReading:
    """Return contact depth, area, modulus and hardness, from an unloading or a small oscillation during loading.

    Parameters
    ----------
    stiffness : float
        Contact stiffness S [N/m], without the frame.
    force : float
        [N].
    depth : float
        h [m].
    tip : Profile or CalibratedArea
        The tip, whose cross-section is A.
    intercept : float, optional
        epsilon [-]; by default 0.75, that of a paraboloid, as in most programs.
    shape_factor : float, optional
        beta [-].

    Raises
    ------
    InvalidInput
        If a number is not positive.
    OutsideValidity
        If the contact depth is not positive, or the tip has no area there.

    References
    ----------
    W. C. Oliver, G. M. Pharr, J. Mater. Res. 7 (1992) 1564-1583, doi:10.1557/JMR.1992.1564

    Examples
    --------
    >>> from winkler.profiles.conical import Cone
    >>> contact_reading(1e5, 1e-3, 100e-9, Cone(half_angle=1.2)).contact_depth
    9.25e-08
    """
    numbers = {"stiffness": stiffness, "force": force, "depth": depth, "shape_factor": shape_factor}
    for word, number in numbers.items():
        if not 0.0 < number < math.inf:
            raise InvalidInput(f"contact_reading: {word} is {number!r}; it must be positive.")
    contact = depth - intercept * force / stiffness
    area = area_at(tip, contact)
    modulus = 0.5 * math.sqrt(math.pi) * stiffness / (shape_factor * math.sqrt(area))
    return ContactReading(contact, area, modulus, force / area)


def area_at(tip: Tip, height: float) -> float:
    """Return the cross-section of a tip at a height [m^2].

    Raises
    ------
    OutsideValidity
        If the height is not positive, beyond the tip, or where its area function is not positive.
    """
    if not height > 0.0:
        raise OutsideValidity(f"OliverPharr: the contact depth is {height:.3g} m; look at contact_point.")
    if isinstance(tip, CalibratedArea | AreaFunction):
        area = polynomial(tip.coefficients, height)
        if not area > 0.0:
            raise OutsideValidity(
                f"OliverPharr: the area function is {area:.3g} m^2 at the contact depth {height:.3g} m; it was not "
                "calibrated for depths like that."
            )
        return area
    if isinstance(tip, PyramidShape | CalibratedTip | TabulatedTip):
        return tip.cross_section(height)
    if isinstance(tip, RoundedPyramid):
        raise OutsideValidity(
            "OliverPharr: a RoundedPyramid stands for a force, its cross-sections are not known; give the tip's "
            "CalibratedArea, or a sharp Pyramid."
        )
    return math.pi * _radius(tip, height) ** 2


def _radius(profile: Profile, height: float) -> float:
    """Return the radius of a profile's cross-section at a height [m]."""
    end = min(profile.reach, profile.rim)

    def height_above(radius: float) -> float:
        return float(profile.height(np.array([radius]))[0]) - height

    inner = min(height, 0.5 * end)
    while height_above(inner) > 0.0 and inner > 1e-9 * height:
        inner *= 0.5
    outer = inner
    while outer < end and height_above(outer) < 0.0:
        outer = min(2.0 * outer, end)
    if height_above(outer) < 0.0:
        raise OutsideValidity(
            f"OliverPharr: the contact depth {height:.3g} m is beyond the tip, which is defined up to a radius of "
            f"{end:.3g} m."
        )
    return between(height_above, inner, outer, relative=1e-14)


def sample_young(modulus: float, poisson: float, indenter: Solid) -> float:
    """Return the sample's Young's modulus from the reduced modulus of the pair.

    Parameters
    ----------
    modulus : float
        E_r [Pa].
    poisson : float
        Of the sample [-].
    indenter : Elastic or Rigid
        Indenter material; diamond is Elastic(young=1141e9, poisson=0.07).

    Returns
    -------
    float
        E [Pa], 1/E_r = (1 - nu^2)/E + (1 - nu_i^2)/E_i.

    Raises
    ------
    OutsideValidity
        If the pair is as stiff as the indenter alone, or stiffer.
    """
    indenter_compliance = 0.0 if isinstance(indenter, Rigid) else (1.0 - indenter.poisson**2) / indenter.young
    sample_compliance = 1.0 / modulus - indenter_compliance
    if not isinstance(indenter, Elastic | Rigid) or not sample_compliance > 0.0:
        raise OutsideValidity(
            f"sample_young: the pair's modulus {modulus:.4g} Pa leaves nothing for the sample; the indenter is softer."
        )
    return (1.0 - poisson**2) / sample_compliance
