r"""Powers of the radius, f = c r^n, on a homogeneous half-space of modulus E* [1]_ [2]_.

.. math:: g(x) = \kappa_n\,c\,x^n,\qquad \kappa_n = \frac{\sqrt\pi\,n\,\Gamma(n/2)}{2\,\Gamma((n+1)/2)},\qquad
          F = \frac{2n}{n+1}E^*\kappa_n\,c\,a^{n+1}.

The arguments are the contact radius ``radius`` a [m], the distance ``r`` from the axis [m], ``coefficient`` c
[m^(1-n)], ``exponent`` n [-], positive, and ``modulus`` E* [Pa].

References
----------
.. [1] I. N. Sneddon, The relation between load and penetration in the axisymmetric Boussinesq problem for a punch
   of arbitrary profile, Int. J. Eng. Sci. 3 (1965) 47-57, doi:10.1016/0020-7225(65)90019-4.
.. [2] L. A. Galin, Contact Problems in the Theory of Elasticity, North Carolina State College (1961).
"""

from __future__ import annotations

import numpy as np
from scipy.special import betaln, hyp2f1

from winkler.numerics.types import Array, ArrayLike, Quantity


def stretch(exponent: Quantity) -> Array:
    """Return kappa_n = g / f of a power law [-]: pi/2 for a cone, 2 for a paraboloid.

    Examples
    --------
    >>> round(float(stretch(3.0)), 10)
    2.3561944902
    """
    n = np.asarray(exponent, dtype=float)
    return np.asarray(0.5 * n * np.exp(betaln(0.5, 0.5 * n)))


def power_law_depth(radius: ArrayLike, *, coefficient: float, exponent: float) -> Array:
    """Return the depth d(a) = g(a) [m] of f = c r^n."""
    a = np.asarray(radius, dtype=float)
    return np.asarray(stretch(exponent) * coefficient * a**exponent)


def power_law_force(radius: ArrayLike, *, coefficient: float, exponent: float, modulus: float) -> Array:
    """Return the force F(a) [N] on f = c r^n."""
    a = np.asarray(radius, dtype=float)
    depth = power_law_depth(a, coefficient=coefficient, exponent=exponent)
    return np.asarray(2.0 * modulus * exponent / (exponent + 1.0) * a * depth)


def power_law_pressure(
    r: ArrayLike, radius: ArrayLike, *, coefficient: float, exponent: float, modulus: float
) -> Array:
    """Return the pressure p(r) [Pa] under f = c r^n; zero outside the contact; for n <= 1 infinite at r = 0.

    T4 with t = (x^2 - r^2)/(a^2 - r^2) is Euler's integral of a hypergeometric function,
    p = (n E* kappa_n c a^(n-1)/pi) s F(1 - n/2, 1; 3/2; s^2) with s^2 = 1 - r^2/a^2.
    """
    r, a = np.broadcast_arrays(np.asarray(r, dtype=float), np.asarray(radius, dtype=float))
    inside = r < a
    s2 = np.where(inside, (a - r) * (a + r) / a**2, 0.0)
    scale = exponent * modulus * stretch(exponent) * coefficient * a ** (exponent - 1.0) / np.pi
    return np.asarray(scale * np.sqrt(s2) * hyp2f1(1.0 - 0.5 * exponent, 1.0, 1.5, s2))


def power_law_displacement(r: ArrayLike, radius: ArrayLike, *, coefficient: float, exponent: float) -> Array:
    """Return the surface displacement u(r) [m] of f = c r^n: d - f inside, the closed form of T3 outside.

    Outside, u = (2 d/pi) [asin(a/r) - (a/r) F(1/2, (n+1)/2; (n+3)/2; a^2/r^2)/(n+1)].
    """
    r, a = np.broadcast_arrays(np.asarray(r, dtype=float), np.asarray(radius, dtype=float))
    depth = power_law_depth(a, coefficient=coefficient, exponent=exponent)
    ratio = a / np.maximum(r, a)
    tail = hyp2f1(0.5, 0.5 * (exponent + 1.0), 0.5 * (exponent + 3.0), ratio**2) / (exponent + 1.0)
    outside = 2.0 / np.pi * depth * (np.arcsin(ratio) - ratio * tail)
    return np.where(r < a, depth - coefficient * r**exponent, outside)


def quartic_pressure(r: ArrayLike, radius: ArrayLike, *, coefficient: float, modulus: float) -> Array:
    """Return the pressure p(r) [Pa] under f = c r^4: (32 E* c/(9 pi)) (a^2 + 2 r^2) sqrt(a^2 - r^2); c [1/m^3]."""
    r, a = np.asarray(r, dtype=float), np.asarray(radius, dtype=float)
    root = np.sqrt(np.maximum((a - r) * (a + r), 0.0))
    return np.asarray(32.0 * modulus * coefficient / (9.0 * np.pi) * (a**2 + 2.0 * r**2) * root)
