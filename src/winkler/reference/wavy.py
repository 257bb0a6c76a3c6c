r"""Concentric waves, f = h (1 - cos(k r)) with k = 2 pi / wavelength [1]_.

.. math:: g = \frac\pi2 h\,kx\,H_0(kx),\qquad F = \pi E^* h a\,[\,ka\,H_0(ka) - H_1(ka)\,],

H0 and H1 Struve's functions.  The contact is one disc only while g grows; added to a paraboloid it is the
profile of Guduru.

The arguments are the contact radius ``radius`` a [m], ``amplitude`` h and ``wavelength`` 2 pi/k [m], and ``modulus``
E* [Pa].

References
----------
.. [1] P. R. Guduru, Detachment of a rigid solid from an elastic wavy surface: theory, J. Mech. Phys. Solids 55
   (2007) 445-472.
"""

from __future__ import annotations

import numpy as np
from scipy.special import struve

from winkler.numerics.types import Array, ArrayLike


def wavy_depth(radius: ArrayLike, *, amplitude: float, wavelength: float) -> Array:
    """Return the depth d(a) = g(a) [m] of concentric waves."""
    phase = 2.0 * np.pi / wavelength * np.asarray(radius, dtype=float)
    return np.asarray(0.5 * np.pi * amplitude * phase * struve(0.0, phase))


def wavy_force(radius: ArrayLike, *, amplitude: float, wavelength: float, modulus: float) -> Array:
    """Return the force F(a) [N] on concentric waves."""
    a = np.asarray(radius, dtype=float)
    phase = 2.0 * np.pi / wavelength * a
    return np.asarray(np.pi * modulus * amplitude * a * (phase * struve(0.0, phase) - struve(1.0, phase)))
