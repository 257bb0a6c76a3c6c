r"""A ball that is pressed with F and then pushed along the surface, with friction: Cattaneo and Mindlin.

With :math:`y=F_x/(\mu F)` the contact sticks up to the radius c and slides beyond it,

.. math:: c = a\,(1-y)^{1/3},\qquad U = \frac{3\mu F}{4G^*a}\bigl(1-(1-y)^{2/3}\bigr),\qquad
          \tau = \mu p_0\Bigl[\sqrt{1-r^2/a^2}-\tfrac ca\sqrt{1-r^2/c^2}\Bigr].

Pushed back from an extreme, the path is the same curve twice as large (Masing).

References
----------
.. [1] R. D. Mindlin, Compliance of elastic bodies in contact, J. Appl. Mech. 16 (1949) 259-268,
   doi:10.1115/1.4009973.
.. [2] R. D. Mindlin, H. Deresiewicz, Elastic spheres in contact under varying oblique forces, J. Appl. Mech. 20 (1953)
   327-344, doi:10.1115/1.4010702.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array, ArrayLike


def mindlin_stick_radius(radius: float, ratio: ArrayLike) -> Array:
    """Return c [m] of a contact of `radius` a [m] at a `ratio` y = F_x / (mu F) from 0 to 1."""
    return np.asarray(radius * (1.0 - np.asarray(ratio, dtype=float)) ** (1.0 / 3.0))


def mindlin_shift(friction: float, shear_modulus: float, radius: float, ratio: ArrayLike) -> Array:
    """Return U [m] at a ratio y; `friction` is mu F [N], `shear_modulus` G* [Pa], `radius` a [m]."""
    y = np.asarray(ratio, dtype=float)
    return np.asarray(0.75 * friction / (shear_modulus * radius) * (1.0 - (1.0 - y) ** (2.0 / 3.0)))


def mindlin_shear_force(friction: float, shear_modulus: float, radius: float, shift: ArrayLike) -> Array:
    """Return F_x [N] at a shift [m]: mu F from the shift on at which all slides."""
    used = np.minimum(np.asarray(shift, dtype=float) * shear_modulus * radius / (0.75 * friction), 1.0)
    return np.asarray(friction * (1.0 - (1.0 - used) ** 1.5))


def mindlin_returning_force(
    friction: float, shear_modulus: float, radius: float, start: float, shift: ArrayLike
) -> Array:
    """Return F_x [N] at shifts [m] on the return from the shift `start` [m], as far as to its negative."""
    back = 0.5 * (start - np.asarray(shift, dtype=float))
    top = mindlin_shear_force(friction, shear_modulus, radius, start)
    return np.asarray(top - 2.0 * mindlin_shear_force(friction, shear_modulus, radius, back))


def mindlin_traction(peak: float, radius: float, stick_radius: float, r: ArrayLike) -> Array:
    """Return tau [Pa] at radii r [m]; `peak` is mu p_0 [Pa], the coefficient times the peak pressure."""
    r = np.asarray(r, dtype=float)
    outer = np.sqrt(np.maximum(1.0 - (r / radius) ** 2, 0.0))
    if stick_radius <= 0.0:
        return np.asarray(peak * outer)
    inner = np.sqrt(np.maximum(1.0 - (r / stick_radius) ** 2, 0.0))
    return np.asarray(peak * (outer - stick_radius / radius * inner))
