"""Correlations and numbers of others' finite elements of yielding bodies.

Of a sphere and a rigid flat loads are over the critical load, depths over the critical depth and areas over the
critical area, at which Jackson and Green let yielding begin: p0 = C Y with C = 1.295 exp(0.736 nu).  Residual depths
are over the depth under load.
"""

import numpy as np

CONES = np.array(
    [
        (0.0, 10.0, 0.1, 21.271), (0.1, 10.0, 0.1, 22.527), (0.3, 10.0, 0.1, 25.207), (0.0, 50.0, 0.6, 116.0),
        (0.1, 50.0, 0.6, 122.0), (0.3, 50.0, 0.6, 135.0), (0.0, 50.0, 1.0, 145.0), (0.0, 130.0, 2.0, 339.0),
        (0.1, 130.0, 2.0, 353.0), (0.3, 130.0, 2.0, 381.0), (0.0, 210.0, 3.0, 531.0),
    ]
)  # fmt: skip
"""Exponent, Young's modulus, strength and force over the squared depth, all in GPa, of a rigid cone of 80 degrees whose
slope is within the tables: finite elements of L. Lu, M. Dao, P. Kumar, U. Ramamurty, G. E. Karniadakis, S. Suresh,
Proc. Natl. Acad. Sci. 117 (2020) 7052-7062, doi:10.1073/pnas.1922210117, from the data that they publish with it."""
STEEPER = np.array(
    [
        (0.0, 90.0, 0.5, 138.0), (0.1, 90.0, 0.5, 149.0), (0.3, 90.0, 0.5, 178.0), (0.5, 90.0, 0.5, 209.0),
        (0.0, 10.0, 0.03, 10.179), (0.1, 10.0, 0.03, 11.403), (0.3, 10.0, 0.03, 14.702), (0.5, 10.0, 0.03, 18.72),
        (0.0, 210.0, 0.3, 119.0), (0.1, 210.0, 0.3, 142.0), (0.3, 210.0, 0.3, 206.0), (0.5, 210.0, 0.3, 296.0),
    ]
)  # fmt: skip
"""The same, beyond the tables: slopes of 35, 65 and 136 strengths over E*."""


def critical(stiffness, poisson, curvature_radius, strength):
    """Depth [m] and load [N] at the onset of yield; stiffness is E / (1 - nu^2)."""
    c = 1.295 * np.exp(0.736 * poisson)
    depth = (0.5 * np.pi * c * strength / stiffness) ** 2 * curvature_radius
    return depth, 4.0 / 3.0 * stiffness * np.sqrt(curvature_radius) * depth**1.5


def kogut_etsion(w):
    """Load and area, L. Kogut, I. Etsion, J. Appl. Mech. 69 (2002) 657-662, doi:10.1115/1.1490373; up to w = 110."""
    load = np.where(w < 6.0, 1.03 * w**1.425, 1.40 * w**1.263)
    return load, np.where(w < 6.0, 0.93 * w**1.136, 0.94 * w**1.146)


def jackson_green(w, stiffness, poisson, strength):
    """Load and area, R. L. Jackson, I. Green, J. Tribol. 127 (2005) 343-354, doi:10.1115/1.1866166."""
    c = 1.295 * np.exp(0.736 * poisson)
    ratio = strength / stiffness
    area = w * (w / 1.9) ** (0.14 * np.exp(23.0 * ratio))
    radius = np.sqrt(area) * 0.5 * np.pi * c * ratio  # over R
    hardness = 2.84 * (1.0 - np.exp(-0.82 * radius**-0.7))  # over Y
    load = (
        np.exp(-0.25 * w ** (5.0 / 12.0)) * w**1.5 + 4.0 * hardness / c * (1.0 - np.exp(-(w ** (5.0 / 9.0)) / 25.0)) * w
    )
    return load, area


HARDENING_BALLS = np.array(
    [
        (200e9, 0.33, 500e6, 0.04, 200e9, 0.33), (200e9, 0.3, 750e6, 0.02, 200e9, 0.3),
        (71e9, 0.33, 200e6, 0.005, 200e9, 0.33), (71e9, 0.33, 500e6, 0.1, 200e9, 0.3),
        (200e9, 0.33, 300e6, 0.02, 200e9, 0.3),
    ]
)  # fmt: skip
"""Young's modulus [Pa], Poisson's ratio, strength [Pa] and tangent modulus over the first of a ball, modulus and
Poisson's ratio of the elastic flat: those of figures 8 to 12 of H. Ghaednia, M. R. W. Brake, M. Berryhill,
R. L. Jackson, "Strain hardening from elastic-perfectly plastic to perfectly elastic flattening single asperity
contact", J. Tribol. (2019)."""


def ghaednia(depth, curvature_radius, young, poisson, strength, share, flat, of_flat):
    """Load [N] and contact radius [m] of one of these balls.

    As the laboratory of one of the authors computes it in public, with the exponent that it states to be misprinted in
    the paper.  Without hardening it is Jackson and Green's with the composite modulus.
    """
    stiffness = 1.0 / ((1.0 - poisson**2) / young + (1.0 - of_flat**2) / flat)
    first, load_then = critical(stiffness, poisson, curvature_radius, strength)
    w = depth / first
    load, area = jackson_green(w, stiffness, poisson, strength)
    root = np.sqrt(young / strength)
    power = share ** (1.0 - (depth - first) / curvature_radius)
    power *= -2.0 * root / (4.0 - 3.0 * np.exp(-2.0 * root * share)) / (1.0 - share)
    radius = np.sqrt(w) + (np.sqrt(area) - np.sqrt(w)) * np.exp(power)
    load += (w**1.5 - load) * (1.0 - np.exp(-3.3 * share))
    return load * load_then, radius * np.sqrt(curvature_radius * first)


def etsion_dent(w):
    """Residual depth of a ball that hardens by 0.02 of its modulus; I. Etsion, Y. Kligerman, Y. Kadin (2005).

    "Unloading of an elastic-plastic loaded spherical contact".  The powers here and in the release are quoted without
    the paper at hand, of which the abstract alone is open.
    """
    return (1.0 - w**-0.28) * (1.0 - w**-0.69)


def jackson_chusoipin_green(w):
    """Residual depth of a perfectly plastic ball.

    R. L. Jackson, I. Chusoipin, I. Green, J. Tribol. 127 (2005) 484-493, doi:10.1115/1.1843166, as a public code of the
    laboratory of M. R. W. Brake quotes it.
    """
    return 1.02 * (1.0 - ((w + 5.9) / 6.9) ** -0.54)


def etsion_release(w, part):
    """Load over the greatest at a part of the way back to the residual depth; the same source."""
    return part ** (1.5 * w**-0.0331)
