r"""Effective moduli of a transversely isotropic half-space whose axis is the surface normal [1]_.

Every normal contact on it is that on an isotropic half-space of the modulus

.. math:: E^* = \frac{2\sqrt{C_{44}}\,(C_{11}C_{33}-C_{13}^2)}
          {\sqrt{C_{11}}\sqrt{(m-C_{13})(C_{13}+2C_{44}+m)}},\qquad m=\sqrt{C_{11}C_{33}},

and every tangential one that of 1/G* = (1/2) [sqrt(C33/C11)/E* + 1/(2 sqrt(C44 C66))], C66 = (C11 - C12)/2.

References
----------
.. [1] H. A. Elliott, Axial symmetric stress distributions in aeolotropic hexagonal crystals: the problem of the
   plane and related problems, Math. Proc. Cambridge Philos. Soc. 45 (1949) 621-630.
"""

from __future__ import annotations

import math


def transverse_modulus(*, c11: float, c13: float, c33: float, c44: float) -> float:
    """Return E* [Pa] of a transversely isotropic half-space against a rigid body.

    Parameters
    ----------
    c11, c13, c33, c44 : float
        Elastic stiffnesses [Pa], axis 3 along the surface normal.

    Examples
    --------
    >>> round(transverse_modulus(c11=10.0, c13=3.5, c33=12.0, c44=3.0), 9)
    9.558861079
    """
    mean = math.sqrt(c11 * c33)
    # C11 C33 - C13^2 = (m - C13)(m + C13): one root of m - C13 cancels
    return 2.0 * (mean + c13) * math.sqrt(c44 * (mean - c13) / (c11 * (c13 + 2.0 * c44 + mean)))


def transverse_shear_modulus(*, c11: float, c12: float, c13: float, c33: float, c44: float) -> float:
    """Return G* [Pa] of a transversely isotropic half-space against a rigid body.

    Parameters
    ----------
    c11, c12, c13, c33, c44 : float
        Elastic stiffnesses [Pa], axis 3 along the surface normal.

    Examples
    --------
    >>> round(transverse_shear_modulus(c11=10.0, c12=4.0, c13=3.5, c33=12.0, c44=3.0), 9)
    7.110690701
    """
    in_plane = math.sqrt(c33 / c11) / transverse_modulus(c11=c11, c13=c13, c33=c33, c44=c44)
    anti_plane = 1.0 / math.sqrt(2.0 * c44 * (c11 - c12))
    return 2.0 / (in_plane + anti_plane)
