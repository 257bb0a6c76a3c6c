"""Stresses of a ball that slides, from closed forms of the surface and from point loads added up on the disc."""

from __future__ import annotations

import math

import numpy as np


def mises(xx, yy, zz, xy, xz, yz):
    squares = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
    return np.sqrt(0.5 * squares + 3.0 * (xy**2 + xz**2 + yz**2))


def on_the_surface(mu, nu):
    """Greatest von Mises stress on the axis of sliding of the surface of a ball, over p0, behind the middle.

    Hertz's stresses (Johnson 3.43), and those of the traction from its surface displacements (Johnson 3.91).
    """
    x = np.linspace(1e-3, 1.0, 4001)
    root = np.sqrt(1.0 - x * x)
    swell = (1.0 - 2.0 * nu) / 3.0 * (1.0 - root**3) / x**2
    xx = swell - root + math.pi * (4.0 + nu) / 8.0 * mu * x
    yy = -swell - 2.0 * nu * root + 3.0 * math.pi * nu / 8.0 * mu * x
    return float(np.max(mises(xx, yy, -root, 0.0, mu * root, 0.0)))


def point_loads(mu, nu, x, z):
    """Von Mises stress under a sliding ball, p0 = a = 1: Boussinesq's and Cerruti's point loads added up."""
    angle = 2.0 * np.pi * (np.arange(64) + 0.5) / 64
    node, weight = np.polynomial.legendre.leggauss(40)
    s = np.sin(0.25 * np.pi * (node + 1.0))  # r = sin, so that the root of the pressure is smooth
    root = np.sqrt(1.0 - s * s)
    loads = (weight * 0.25 * np.pi * root * root * s)[:, None] * np.full(64, 2.0 * np.pi / 64)
    u, v = x - np.outer(s, np.cos(angle)), -np.outer(s, np.sin(angle))
    rho = np.sqrt(u * u + v * v + z * z)
    r2, free, w = u * u + v * v, 1.0 - 2.0 * nu, rho + z
    normal = (
        free / r2 * ((1.0 - z / rho) * (u * u - v * v) / r2 + z * v * v / rho**3) - 3.0 * z * u * u / rho**5,
        free / r2 * ((1.0 - z / rho) * (v * v - u * u) / r2 + z * u * u / rho**3) - 3.0 * z * v * v / rho**5,
        -3.0 * z**3 / rho**5,
        free / r2 * ((1.0 - z / rho) * 2.0 * u * v / r2 - u * v * z / rho**3) - 3.0 * z * u * v / rho**5,
        -3.0 * u * z * z / rho**5,
        -3.0 * v * z * z / rho**5,
    )
    far = 1.0 / (rho**3 * w * w) + 2.0 / (rho**2 * w**3)
    along = (
        -3.0 * u**3 / rho**5 + free * (u / rho**3 - 3.0 * u / (rho * w * w) + u**3 * far),
        -3.0 * u * v * v / rho**5 + free * (u / rho**3 - u / (rho * w * w) + u * v * v * far),
        -3.0 * u * z * z / rho**5,
        -3.0 * u * u * v / rho**5 + free * (-v / (rho * w * w) + u * u * v * far),
        -3.0 * u * u * z / rho**5,
        -3.0 * u * v * z / rho**5,
    )
    stress = [np.sum(loads * (a + mu * b)) / (2.0 * np.pi) for a, b in zip(normal, along, strict=True)]
    return float(mises(*stress))
