r"""Rings of constant traction that slide each by itself: boundary elements of a body of revolution, in steps.

Displacements are means over rings, by Hankel transforms of the compliances of `layer_waves`; pressures follow from
rings as well, tractions are a linear complementarity problem in every step.
"""

from __future__ import annotations

import layer_waves
import numpy as np
from scipy.interpolate import CubicSpline
from scipy.linalg import expm
from scipy.special import j1

REACH = 40.0
"""Largest wave number, over the inverse width of a ring."""


def normal_compliance(layer, on, xi):
    """C_N times xi of one layer (shear, poisson, thickness) on (shear, poisson)."""
    shear, poisson, thickness = layer
    scale = np.array([1.0, 1.0, shear, shear])[:, None]
    fields = np.broadcast_to(layer_waves.base(on), (xi.size, 4, 2))
    fields = scale * (expm(-layer_waves._plane(poisson) * (xi * thickness)[:, None, None]) @ (fields / scale))
    fields = fields / np.max(np.abs(fields), axis=(1, 2), keepdims=True)
    return np.abs((fields[:, :2] @ np.linalg.inv(fields[:, 2:]))[:, 1, 1])


def matrix(values, thickness, edges):
    """Mean displacement of each ring under tractions of the others; values(xi) is the compliance times xi."""
    known = np.concatenate([[1e-6], np.geomspace(1e-4, 21.0, 800)]) / thickness
    spline = CubicSpline(np.log(known), values(known))
    end, width = edges[-1], edges[1]
    top = REACH / width
    cuts = np.concatenate([[0.0], 2.0 ** -np.arange(12.0, 0.0, -1.0) * 2.0 / end, np.arange(2.0 / end, top, 2.0 / end)])
    nodes, weights = np.polynomial.legendre.leggauss(8)
    xi = (cuts[:-1, None] + np.diff(cuts)[:, None] * 0.5 * (nodes + 1.0)).ravel()
    rule = (np.diff(cuts)[:, None] * 0.5 * weights).ravel()
    rings = np.diff(edges[:, None] * j1(np.outer(edges, xi)), axis=0) / xi
    sums = (rings * (spline(np.log(np.clip(xi, known[0], known[-1]))) * rule)) @ rings.T
    tail = edges / np.pi / (2.0 * top**2) * float(spline(np.log(known[-1])))  # mean of the products beyond
    sums += np.diag(tail[1:] + tail[:-1]) - np.diag(tail[1:-1], 1) - np.diag(tail[1:-1], -1)
    area = 0.5 * np.diff(edges**2)
    return sums / area[:, None], 2.0 * np.pi * area


def pressures(normal, edges, radius, depths):
    """Of a paraboloid at depths one after the other."""
    heights, found, count = 0.25 * (edges[1:] ** 2 + edges[:-1] ** 2) / radius, [], 1
    for depth in depths:
        gap, pressure = depth - heights, np.zeros(heights.size)
        while count > 1 and np.linalg.solve(normal[:count, :count], gap[:count])[-1] < 0.0:
            count -= 1
        while normal[count, :count] @ np.linalg.solve(normal[:count, :count], gap[:count]) < gap[count]:
            count += 1
        if depth > 0.0:
            pressure[:count] = np.maximum(np.linalg.solve(normal[:count, :count], gap[:count]), 0.0)
        found.append(pressure)
    return np.array(found)


def pushed(shear, traction, limit, shift):
    """Tractions after a shift, and how far each ring has slid: one ring after another changes sides at last."""
    stick, side, inside = limit > 0.0, np.zeros(limit.size), limit > 0.0
    before = shear @ traction
    small = 1e-13 * np.max(limit, initial=0.0) * np.max(np.abs(shear))
    for trial in range(400):
        new = np.where(stick, 0.0, side * limit)
        own = np.flatnonzero(stick)
        if own.size:
            right = shift + before[own] - shear[own] @ new
            new[own] = np.linalg.solve(shear[np.ix_(own, own)], right)
        slid = np.where(inside & ~stick, shift - (shear @ new - before), 0.0)
        over = stick & (np.abs(new) > limit * (1.0 + 1e-12))
        back = ~stick & inside & (side * slid < -small)
        if not over.any() and not back.any():
            return new, slid
        wrong = np.flatnonzero(over | back)
        for ring in wrong if trial < 60 else wrong[trial % wrong.size : trial % wrong.size + 1]:
            side[ring] = np.sign(new[ring]) if over[ring] else 0.0
            stick[ring] = back[ring]
    raise AssertionError("rings change sides without end")
