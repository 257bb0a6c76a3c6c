"""Synthetic force curves from closed forms, written without the package: Hertz, JKR, DMT, Sneddon's cone, and noise."""

from __future__ import annotations

import numpy as np


def hertz(depth, modulus, radius):
    """F = 4/3 E* sqrt(R) d^(3/2)."""
    return 4.0 / 3.0 * modulus * np.sqrt(radius) * np.maximum(depth, 0.0) ** 1.5


def hertz_on_spring(position, modulus, radius, stiffness):
    """F at positions D of a machine, D = d + F/k_m: the depth by bisection."""
    low, high = np.zeros_like(position), np.maximum(position, 0.0)
    for _ in range(200):
        middle = 0.5 * (low + high)
        over = middle + hertz(middle, modulus, radius) / stiffness > position
        low, high = np.where(over, low, middle), np.where(over, middle, high)
    return hertz(0.5 * (low + high), modulus, radius)


def jkr_states(modulus, radius, work, stiffness, widest):
    """D and F of the branch that a machine of a stiffness holds, over rising contact radii."""
    scale = (np.pi * work * radius**2 / modulus) ** (1.0 / 3.0)
    a = np.concatenate(
        [np.geomspace(1e-3 * scale, 3.0 * scale, 200_001), np.linspace(3.0 * scale, widest, 200_001)[1:]]
    )
    d = a**2 / radius - np.sqrt(2.0 * np.pi * a * work / modulus)
    f = 4.0 * modulus * a**3 / (3.0 * radius) - np.sqrt(8.0 * np.pi * a**3 * work * modulus)
    place = d + f / stiffness
    start = int(np.argmin(place))
    return place[start:], f[start:]


def jkr(position, inward, modulus, radius, work, stiffness):
    """F at positions, in with a snap at D = 0, out to the limit of stability."""
    widest = 4.0 * np.sqrt(radius * (position.max() + 1e-9)) + 10.0 * (work * radius**2 / modulus) ** (1.0 / 3.0)
    place, force = jkr_states(modulus, radius, work, stiffness, widest)
    held = np.where(inward, position >= 0.0, position >= place[0])
    return np.where(held, np.interp(position, place, force), 0.0)


def there_and_back(bottom, top, count):
    """Positions in and out, and whether they go in."""
    levels = np.linspace(bottom, top, count)
    return np.concatenate([levels, levels[::-1]]), np.repeat([True, False], count)


def noise(random, count, memory=0.0):
    """Noise of unit variance, with the correlation memory^k between points k apart."""
    white = random.standard_normal(count)
    if memory == 0.0:
        return white
    result = np.empty(count)
    result[0] = white[0]
    for i in range(1, count):
        result[i] = memory * result[i - 1] + np.sqrt(1.0 - memory**2) * white[i]
    return result
