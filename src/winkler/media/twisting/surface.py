r"""The traction around the axis of a twisted contact, in each medium.

A rigidly twisted disc of radius x drags with :math:`\tau_1(r;x)`, and springs that bear h drag with the sum of these,
:math:`\tau(r) = \frac1{8G_t}\big[h(a)\,\tau_1(r;a) - \int_r^a h'(x)\,\tau_1(r;x)\,\mathrm dx\big]`, where

.. math:: \tau_1 = \frac{4G_t}\pi\,\frac{r\,\sigma(r;x)}{\sqrt{x^2-r^2}} \quad\text{on layers} , \qquad
          \tau_1 = \frac{4(1+k)G_t}{\pi c_0^k}\,r\,(x^2-r^2)^{(k-1)/2} \quad\text{on a power law} .
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from winkler.media.halfspace import HomogeneousMedium
from winkler.media.interior.twist_field import Twisted, clean_slope, twist_displacement, twist_traction
from winkler.media.medium import Medium
from winkler.media.offers import PowerOfDepth, TwistedWaves, offers
from winkler.media.twisting.kernels import no_kernel
from winkler.numerics.transforms import abel, fredholm
from winkler.numerics.types import Array
from winkler.values.errors import OutsideValidity

if TYPE_CHECKING:  # numerics of layers are loaded with layers
    from winkler.numerics.transforms.cosine_transform import WaveResponse

TABLE_ROUNDING = 1e-9
"""A slope that changes h by no more than this part of it is rounding of the tables of a stack."""

LOGARITHMIC_ROUNDING = 2e-6
"""The same where the kernel has a logarithm, as of bodies graded in depth."""


def traction_on(medium: Medium, twisted: Twisted, r: Array) -> Array:
    """Return the traction tau_theta(r) [Pa] of twisted springs on a medium; zero outside the contact.

    Parameters
    ----------
    medium : Medium
        One of those on which torsion is solved.
    twisted : Twisted
        The springs.
    r : ndarray
        Distance from the axis [m], not negative.
    """
    r = np.asarray(r, dtype=float)
    if isinstance(medium, HomogeneousMedium) or twisted.radius == 0.0:
        return twist_traction(twisted, r)
    place = np.where(r > 0.0, r, 0.5 * twisted.radius)
    if offers(medium, PowerOfDepth):
        from winkler.numerics.transforms.graded_pressure import pressure

        k = medium.exponent
        summed = pressure(clean_slope(twisted), twisted.kinks, twisted.edge, twisted.radius, k, place)
        factor = 0.5 * (1.0 + k) / medium.depth_scale**k
        return np.where(r > 0.0, factor * r * summed, 0.0)
    if not offers(medium, TwistedWaves):
        raise no_kernel(medium)
    from winkler.numerics.transforms.odd_response import OddResponse

    return np.where(r > 0.0, 0.5 * r * summed_discs(OddResponse(medium.across_response), twisted, place), 0.0)


def table_rounding(logarithmic: bool) -> float:
    """Return up to which part of h a slope changes it that is rounding of the tables, by whether these err more."""
    return LOGARITHMIC_ROUNDING if logarithmic else TABLE_ROUNDING


def summed_discs(response: WaveResponse, springs: Twisted, r: Array) -> Array:
    """Return the sum of the tractions of rigid discs of all radii that are twisted or pushed, on layers.

    Parameters
    ----------
    response : WaveResponse
        To a push, or an `OddResponse` for a twist.
    springs : Twisted
        What they bear, h(x) [Pa].
    r : ndarray
        Distance from the axis [m].

    Returns
    -------
    ndarray
        Of a push the traction [Pa], of a twist twice that over r [Pa/m].
    """
    known = table_rounding(response.smooth > response.length)
    return np.asarray(
        abel.pressure(
            clean_slope(springs, known),
            springs.kinks,
            springs.edge,
            springs.radius,
            r,
            lambda r, x: fredholm.push(response, r, x),
            max(response.precision, known),
        )
    )


def turning_on(medium: Medium, twisted: Twisted, r: Array) -> Array:
    """Return the displacement u_theta(r) of the surface [m], the sum over both bodies.

    Raises
    ------
    OutsideValidity
        If the medium is not homogeneous.
    """
    if not isinstance(medium, HomogeneousMedium):
        raise OutsideValidity(
            f"The displacement of the surface around the axis is not implemented for a {type(medium).__name__}; "
            "request the traction of the state, state.traction(r), or give a homogeneous half-space."
        )
    return twist_displacement(twisted, r, medium.torsional_modulus)
