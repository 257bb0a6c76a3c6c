r"""The field inside one homogeneous body, isotropic or transversely isotropic about the surface normal.

Waves of each exponent of the solid, :math:`e^{-\xi s_iz}` (`winkler.media.layered.wave_constants`), have the potential
of an isotropic one at the depth :math:`s_iz` [1]_.  The exponents are real or a complex pair.  With the functions of
`winkler.media.punch_field`, V = Im F for real depths, a complex depth z = b + ic has

.. math:: V(r, z; t) = \tfrac1{2i}\big[F(r, b + i(t+c)) - \overline{F(r, b + i(t-c))}\big] ,

each half of which is almost singular at one radius, :math:`t = r\mp c + ib`.

References
----------
.. [1] H. A. Elliott, Three-dimensional stress distributions in hexagonal aeolotropic crystals, Proc. Camb. Phil. Soc.
   44 (1948) 522-533, doi:10.1017/S0305004100024531
"""

from __future__ import annotations

import cmath

import numpy as np

from winkler.materials.elastic import Elastic, TransverselyIsotropic
from winkler.media.interior import subsurface
from winkler.media.interior.surface_limit import superposed_on
from winkler.media.layered.wave_constants import constants_of
from winkler.media.medium import Displacement
from winkler.media.punch_field import BodyField, times
from winkler.numerics.types import Array, ComplexArray

LEAST_SPLIT = 1e-4
"""Least difference of the exponents over their sum: the field is even in it, and changes by its square."""


def solid_field(
    displacement: Displacement, r: Array, z: Array, *, modulus: float, solid: Elastic | TransverselyIsotropic
) -> BodyField:
    """Return stresses [Pa] and displacements [m] in one of two bodies, as `winkler.media.interior.subsurface.field`.

    Parameters
    ----------
    displacement : Displacement
        u(x) of the springs, whose line load is ``modulus * u(x)``; hashable.
    r, z : ndarray
        Distance from the axis and depth [m], not negative, of one shape.
    modulus : float
        Effective modulus E* of the pair [Pa].
    solid : Elastic or TransverselyIsotropic
        The body.
    """
    if isinstance(solid, Elastic):
        return subsurface.field(displacement, r, z, modulus=modulus, poisson=solid.poisson, shear=solid.shear)
    one = constants_of(solid)
    p, q, n, c = one.total, one.product, one.lateral, one.plane
    shape, r, z = np.shape(r), np.ravel(r), np.ravel(z)
    # V, V_z, V_r / r and psi_r / r: of the waves of axial stress, and of those of shear
    pressed, sheared = np.zeros((4, r.size)), np.zeros((4, r.size))
    if displacement.radius > 0.0:
        below = z > 0.0
        v, v_z, psi = superposed_on(displacement, r[~below])
        pressed[:, ~below] = v, v_z, np.zeros(v.size), psi
        root = cmath.sqrt(one.split)
        if abs(root) < 0.5 * LEAST_SPLIT * p:
            root = complex(0.5 * LEAST_SPLIT * p)
        fast, slow = 0.5 * p + root, 0.5 * p - root
        steep = _potentials(displacement, r[below], z[below], fast)
        flat = steep.conj() if root.imag else _potentials(displacement, r[below], z[below], slow)
        pressed[:, below] = np.real((fast * flat - slow * steep) / (2.0 * root))
        sheared[:, below] = np.real(q * (flat - steep) / (2.0 * root))
        for part in (pressed, sheared):
            part[3] = np.where(r > 0.0, part[3], -0.5 * part[1])
    stress = modulus / (2.0 * np.pi)
    twice = 2.0 * one.twist / c
    bend = twice * ((q - n) * pressed[3] - p * sheared[3])
    return BodyField(
        *(
            part.reshape(shape)
            for part in (
                stress * (q * pressed[1] - p * sheared[1] + bend),
                stress * (times(q - twice * (q - n), pressed[1]) - (1.0 - twice) * p * sheared[1] - bend),
                stress * pressed[1],
                stress * r * sheared[2],
                -stress / (2.0 * one.twist * one.shear) * r * bend,
                stress / (one.shear * c) * (p * q * pressed[0] - (q - n) * sheared[0]),
            )
        )
    )


def _potentials(displacement: Displacement, r: Array, z: Array, exponent: complex) -> ComplexArray:
    """Return V, V_z, V_r / r and psi_r / r at the depths `exponent` times z > 0 ``(4, n)``."""
    depth, lean = exponent.real * z, exponent.imag * z
    ahead = _halves(displacement, r, depth, lean)
    behind = _halves(displacement, r, depth, -lean) if exponent.imag else ahead
    return (ahead - behind.conj()) / 2j


def _halves(displacement: Displacement, r: Array, depth: Array, lean: Array) -> ComplexArray:
    """Return F(r, depth + i (t + lean)) of all punches, and what belongs to it, ``(4, n)``."""
    result = np.zeros((4, r.size), dtype=complex)
    ratio = lean / depth
    beside = r - lean
    for mirrored in (False, True):
        chosen = (beside < 0.0) == mirrored
        if not chosen.any():
            continue
        slant = ratio[chosen][0]

        def punch(
            place: Array, b: Array, t: Array, excess: Array | None, slant: float = slant, mirrored: bool = mirrored
        ) -> tuple[Array, ...]:
            shifted = t + slant * b
            beyond = t + place if mirrored else (t - place if excess is None else excess)  # t + lean - r
            radius = slant * b - place if mirrored else slant * b + place
            big = b + 1j * shifted
            root = np.sqrt(b * b - beyond * (radius + shifted) + 2j * b * shifted)
            whole = 1.0 / (root + big)
            parts = (2.0 * np.log(root + big), 2.0 / root, 2.0 * whole / root, -2.0 * whole)
            return (*(part.real for part in parts), *(part.imag for part in parts))

        found = subsurface.superposed_below(displacement, np.abs(beside[chosen]), depth[chosen], punch)
        result[:, chosen] = found[:4] + 1j * found[4:]
    return result
