r"""What springs under a twist bear in each medium: their weights, and their bounds under flat punches of all radii.

In every medium that is layered or graded in depth, twist and pressure do not act on each other, and a traction around
the axis is a sum of those of rigidly twisted discs of all radii x, by :math:`h(x)/8G_t`.  A spring counts
:math:`e(x)^2`, so that :math:`16\,G_t\,e^2 = k_\varphi'(x)`, the torque is :math:`2\int_0^a e^2h\,\mathrm dx`, and the
stored energy :math:`\frac1{8G_t}\int_0^ae^2h^2\,\mathrm dx`.  In homogeneous bodies e = x; where the modulus grows
as :math:`z^k`, :math:`e = x\,(x/c_0)^{k/2}` and, under a flat punch of radius t at unit depth,

.. math:: b(x;t) = \frac{2\mu E^*}{(1+k)\,t}\;{}_2F_1\Big(\frac12,\frac{1+k}2;1;1-\frac{x^2}{t^2}\Big) .

On layers both are tables (`winkler.numerics.transforms.slip_tables`).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from winkler.media.halfspace import HomogeneousMedium
from winkler.media.medium import Medium
from winkler.media.offers import PowerOfDepth, TwistedWaves, TwistModuli, offers
from winkler.numerics.panels.kink_panels import Stretches
from winkler.numerics.types import Array
from winkler.values.errors import OutsideValidity

if TYPE_CHECKING:  # numerics of layers are loaded with layers
    from winkler.numerics.transforms.cosine_transform import SurfaceResponse

PANEL_WIDTH_RATIO = 2.0
"""Width of a panel, over the length on which the kernel of a stack is smooth."""
SMALL_RATIO = 0.25
"""Squared ratio of radii up to which the hypergeometric function is summed from its end."""
LEAST_EXPONENT = 1e-4
"""Of a power law, below which its function is interpolated between exponents."""
LOGARITHMIC_WIDTH = 1.0 / 12.0
"""Width of a panel, over the widest contact, where kernels have a logarithm: what is left of it errs
by 1e-5 where the modulus grows threefold, 2e-4 where it grows thirtyfold."""
MOST_NODES = 2000
"""Wider contacts, against the uppermost layer, are refused."""


class TwistKernel(NamedTuple):
    """Springs at the nodes of panels: `bound` is b at node i under a punch of radius node j, over mu [Pa/m]."""

    bound: Array
    weight: Array


def twisted_medium(medium: Medium) -> TwistModuli:
    """Return a medium on which it is known what twisted springs bear.

    Raises
    ------
    OutsideValidity
        If the medium relaxes, is measured, or of another kind.
    """
    if not offers(medium, TwistModuli):
        raise no_kernel(medium)
    return medium


def no_kernel(medium: object) -> OutsideValidity:
    """Return the refusal of torsion on a medium."""
    return OutsideValidity(
        f"Torsion: the medium of the bed is a {type(medium).__name__}; slip annuli of a twisted contact are "
        "implemented for homogeneous, layered and graded elastic half-spaces only: give one of these."
    )


def panel_width(owner: str, responses: Sequence[SurfaceResponse], widest: float) -> float:
    """Return the width [m] that panels may have; without end where no response changes with the wave number.

    Parameters
    ----------
    owner : str
        Kind of problem, for messages.
    responses : sequence of SurfaceResponse
        Whose kernels are read on the panels.
    widest : float
        [m].

    Raises
    ------
    OutsideValidity
        If a contact of radius `widest` would need too many.
    """
    if not responses:
        return np.inf
    width = PANEL_WIDTH_RATIO * min(each.smooth for each in responses)
    if widest > 0.05 * MOST_NODES * width:
        raise OutsideValidity(
            f"{owner}: the contact of radius {widest:.3g} m is too wide against the length of {width:.3g} m over which "
            f"the medium changes; at most {0.05 * MOST_NODES:g} times that can be followed: request less load."
        )
    if any(each.smooth > each.length for each in responses):
        width = min(width, LOGARITHMIC_WIDTH * widest)
    return float(width)


def twist_kernel(medium: Medium, panels: Stretches) -> TwistKernel:
    """Return what springs bear.

    Raises
    ------
    OutsideValidity
        As `twisted_medium`.
    """
    x = panels.nodes.ravel()
    if isinstance(medium, HomogeneousMedium):
        from scipy.special import ellipkm1

        return TwistKernel(4.0 * medium.modulus / np.pi * ellipkm1((x[:, None] / x) ** 2) / x, x**2)
    if offers(medium, PowerOfDepth):
        k = medium.exponent
        weight = x ** (2.0 + k) / medium.depth_scale**k
        bound = np.zeros((x.size, x.size))
        count = panels.nodes.shape[1]
        read = np.arange(x.size)[:, None] // count <= np.arange(x.size) // count
        bound[read] = bound_shape(k, ((x[:, None] / x) ** 2)[read])
        return TwistKernel(2.0 * medium.modulus / (1.0 + k) * bound / x, weight)
    from winkler.numerics.transforms.odd_response import OddResponse
    from winkler.numerics.transforms.slip_tables import slip_table

    if not offers(medium, TwistedWaves):
        raise no_kernel(medium)
    table = slip_table(panels, medium.response, OddResponse(medium.across_response))
    return TwistKernel(medium.modulus * table.bound, table.lever**2)


def bound_shape(k: float, z: Array) -> Array:
    """Return 2F1(1/2, (1 + k)/2; 1; 1 - z) for z > 0, also where it grows like a power of z or like a logarithm."""
    from scipy.special import ellipkm1, gamma, hyp2f1

    if abs(k) < LEAST_EXPONENT:
        share = k / LEAST_EXPONENT
        ends = [bound_shape(sign * LEAST_EXPONENT, z) for sign in (-1.0, 1.0)]
        middle = 2.0 / np.pi * ellipkm1(z)
        bend = 0.5 * (ends[0] + ends[1]) - middle
        return np.asarray(middle + 0.5 * share * (ends[1] - ends[0]) + share**2 * bend)
    result = np.empty(z.shape)
    small = z < SMALL_RATIO
    result[~small] = hyp2f1(0.5, 0.5 * (1.0 + k), 1.0, 1.0 - z[~small])
    z, root = z[small], np.sqrt(np.pi)
    regular = gamma(-0.5 * k) / (root * gamma(0.5 * (1.0 - k))) * hyp2f1(0.5, 0.5 * (1.0 + k), 1.0 + 0.5 * k, z)
    singular = gamma(0.5 * k) / (root * gamma(0.5 * (1.0 + k))) * hyp2f1(0.5, 0.5 * (1.0 - k), 1.0 - 0.5 * k, z)
    result[small] = regular + z ** (-0.5 * k) * singular
    return result
