r"""Hertz's contact: the paraboloid f = r^2/(2 R) on a half-space of modulus E*, on and below the surface.

.. math:: d = \frac{a^2}{R},\qquad F = \frac{4E^*a^3}{3R},\qquad p = p_0\sqrt{1-r^2/a^2},\qquad
          p_0 = \frac{2E^*a}{\pi R}.

The field below the surface is Huber's [2]_, given by Hamilton [3]_ in real numbers.  Here the line load
q = (pi a p0/2)(1 - t^2/a^2) was integrated in the complex plane: with Z = z + i a, P = sqrt(r^2 + Z^2),
L = ln(Z + P) and q0 = pi a p0/2

.. math:: V_{,z} = -\frac{4q_0}{a^2}\,\mathrm{Im}[P-zL],\qquad
          V_{,zz} = \frac{4q_0}{a^2}\,\mathrm{Im}\Bigl[L-\frac{ia}{P}\Bigr],\qquad
          V_{,rz} = -\frac{4q_0r}{a^2}\,\mathrm{Im}\Bigl[\frac1P-\frac{z}{P(P+Z)}\Bigr]

and so on.  Deep below the contact the brackets cancel: about (z/a)^3 in the last digit.

The arguments are the contact radius ``radius`` a [m], ``curvature_radius`` R [m], ``modulus`` E* [Pa], ``force`` F
[N], the distance ``r`` from the axis [m], the depth ``z`` >= 0 below the surface [m], ``peak_pressure`` p0 [Pa], and
of the body ``poisson`` nu [-] and ``shear`` G [Pa].

References
----------
.. [1] H. Hertz, Ueber die Beruehrung fester elastischer Koerper, J. reine angew. Math. 92 (1882) 156-171,
   doi:10.1515/crll.1882.92.156.
.. [2] M. T. Huber, Zur Theorie der Beruehrung fester elastischer Koerper, Ann. Phys. 319 (1904) 153-163,
   doi:10.1002/andp.19043190611.
.. [3] G. M. Hamilton, Explicit equations for the stresses beneath a sliding spherical contact, Proc. Inst. Mech.
   Eng. C 197 (1983) 53-59, doi:10.1243/PIME_PROC_1983_197_076_02.
"""

from __future__ import annotations

import numpy as np
from scipy.special import hyp2f1

from winkler.numerics.types import Array, ArrayLike
from winkler.reference.interior import Interior, interior


def hertz_depth(radius: ArrayLike, *, curvature_radius: float) -> Array:
    """Return the depth d(a) = g(a) = a^2/R [m]."""
    return np.asarray(np.asarray(radius, dtype=float) ** 2 / curvature_radius)


def hertz_force(radius: ArrayLike, *, curvature_radius: float, modulus: float) -> Array:
    """Return the force F(a) = 4 E* a^3/(3 R) [N]."""
    return np.asarray(4.0 * modulus / (3.0 * curvature_radius) * np.asarray(radius, dtype=float) ** 3)


def hertz_radius(force: ArrayLike, *, curvature_radius: float, modulus: float) -> Array:
    """Return the contact radius a(F) = (3 F R/(4 E*))^(1/3) [m]."""
    return np.asarray(np.cbrt(0.75 * np.asarray(force, dtype=float) * curvature_radius / modulus))


def hertz_peak_pressure(radius: ArrayLike, *, curvature_radius: float, modulus: float) -> Array:
    """Return the pressure at the centre p0 = 2 E* a/(pi R) [Pa]."""
    return np.asarray(2.0 * modulus / (np.pi * curvature_radius) * np.asarray(radius, dtype=float))


def hertz_pressure(r: ArrayLike, radius: ArrayLike, *, curvature_radius: float, modulus: float) -> Array:
    """Return the pressure p(r) [Pa]; zero outside the contact."""
    r, a = np.asarray(r, dtype=float), np.asarray(radius, dtype=float)
    root = np.sqrt(np.maximum((a - r) * (a + r), 0.0))
    return np.asarray(2.0 * modulus / (np.pi * curvature_radius) * root)


def hertz_displacement(r: ArrayLike, radius: ArrayLike, *, curvature_radius: float) -> Array:
    """Return the surface displacement u(r) [m]: d - f inside, the closed form of T3 outside.

    Outside, u = (a^2/(pi R)) [(2 - s^2) asin(1/s) + sqrt(s^2 - 1)] with s = r/a; beyond s = 2, where the bracket
    cancels, the same as a hypergeometric function.
    """
    r, a = np.broadcast_arrays(np.asarray(r, dtype=float), np.asarray(radius, dtype=float))
    s = np.maximum(r, a) / a
    near, far = np.minimum(s, 2.0), 1.0 / np.maximum(s, 2.0)
    closed = (2.0 - near**2) * np.arcsin(1.0 / near) + np.sqrt((near - 1.0) * (near + 1.0))
    series = 2.0 * (np.arcsin(far) - far / 3.0 * hyp2f1(0.5, 1.5, 2.5, far**2))
    outside = a**2 / (np.pi * curvature_radius) * np.where(s > 2.0, series, closed)
    return np.asarray(np.where(r < a, (2.0 * a**2 - r**2) / (2.0 * curvature_radius), outside))


def hertz_surface_stress(
    r: ArrayLike, radius: ArrayLike, *, peak_pressure: float, poisson: float
) -> tuple[Array, Array]:
    """Return the radial and hoop stress [Pa] at the surface, tension positive."""
    r, a = np.broadcast_arrays(np.asarray(r, dtype=float), np.asarray(radius, dtype=float))
    s = np.minimum(r / a, 1.0)
    c = np.sqrt((1.0 - s) * (1.0 + s))
    # (1 - c^3)/s^2 = (1 + c + c^2)/(1 + c)
    bulge = (1.0 + c + c**2) / (1.0 + c) * (a / np.maximum(r, a)) ** 2
    spread = (1.0 - 2.0 * poisson) / 3.0 * bulge
    radial, hoop = peak_pressure * (spread - c), -peak_pressure * (spread + 2.0 * poisson * c)
    return np.asarray(radial), np.asarray(hoop)


def hertz_axis_stress(z: ArrayLike, radius: ArrayLike, *, peak_pressure: float, poisson: float) -> tuple[Array, Array]:
    """Return the radial (= hoop) and the axial stress [Pa] on the axis, tension positive."""
    s = np.asarray(z, dtype=float) / np.asarray(radius, dtype=float)
    axial = -1.0 / (1.0 + s**2)
    radial = -(1.0 + poisson) * (1.0 - s * np.arctan2(1.0, s)) - 0.5 * axial
    return np.asarray(peak_pressure * radial), np.asarray(peak_pressure * axial)


def hertz_subsurface(
    r: ArrayLike, z: ArrayLike, radius: float, *, peak_pressure: float, poisson: float, shear: float
) -> Interior:
    """Return stresses and displacements below Hertz's contact, in closed form."""
    s, h = np.broadcast_arrays(np.asarray(r, dtype=float) / radius, np.asarray(z, dtype=float) / radius)
    big_z = h + 1j
    big_p = np.sqrt(s**2 + big_z**2)
    away = np.where(big_p == 0.0, 1.0, big_p)  # the edge itself, where no result that is divided by P is needed
    both = big_z + big_p
    log = np.log(both)
    load = 0.5 * np.pi * radius * peak_pressure
    potential = log + 0.5 * (big_z * big_p - s**2 * log) - 2.0 * h * big_p + h**2 * log
    radial = 0.5 * log + (h - 0.5 * big_z) / both
    # the integral of (zeta - z)/(zeta + rho)
    spread = (big_p**2 + big_p * big_z + big_z**2) / (3.0 * both) - h * (0.5 * log + 0.5 * big_z / both)
    fields = interior(
        s,
        h,
        v=2.0 * potential.imag,
        v_z=-4.0 * (big_p - h * log).imag,
        v_zz=4.0 * (log - 1j / away).imag,
        v_rz=-4.0 * s * (1.0 / away - h / (away * both)).imag,
        v_r_over_r=-4.0 * radial.imag,
        psi_r_over_r=4.0 * spread.imag,
        poisson=poisson,
        shear=shear,
    )
    # lengths were in units of a: stresses are q0/a times, displacements q0 times
    stresses = (load / radius * part for part in fields[:4])
    displacements = (load * part for part in fields[4:])
    return Interior(*stresses, *displacements)
