"""Correlations that others have fitted to their finite elements of a yielding sphere and a rigid flat.

Loads are over the critical load, depths over the critical depth and areas over the critical area, at which Jackson and
Green let yielding begin: p0 = C Y with C = 1.295 exp(0.736 nu).
"""

import numpy as np


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
