"""Boundary elements for bodies of any outline on a half-space and on a bonded layer, written without the package.

Pressures are constant in square pixels; Love's displacements at their centres are convolved by fast Fourier
transforms, and pressures are found by Polonsky and Keer's conjugate gradients.  E / (1 - nu^2) of the half-space, or of
the layer, is one.  A layer adds a smooth kernel, the integral of its surface compliance (Burmister 1945, in the form of
O'Sullivan and King 1988, doi:10.1115/1.3261591) over J0.
"""

import numpy as np
import scipy.fft as sf
from scipy.interpolate import CubicSpline
from scipy.special import j0


def layer_excess(x, poisson, base_poisson, shear_ratio):
    """M of a layer bonded to a half-space, compliance 2 (1 + M) / (E* xi), at x = xi h; G of layer over base."""
    fade = np.exp(-2.0 * x)
    near = 1.0 - 4.0 * (1.0 - poisson) / (1.0 + shear_ratio * (3.0 - 4.0 * base_poisson))
    far = (shear_ratio - 1.0) / (shear_ratio + 3.0 - 4.0 * poisson)
    above = 1.0 + 4.0 * x * far * fade - near * far * fade**2
    return above / (1.0 - (near + far + 4.0 * far * x**2) * fade + near * far * fade**2) - 1.0


def layer_kernel(excess, thickness, widest):
    """(1/pi) times the integral of M J0(xi r) over xi, as a spline over r."""
    step = min(6.0 / widest, 1.0 / thickness)
    ends = np.unique(np.r_[0.0, np.geomspace(1e-6 * step, step, 25), np.arange(step, 25.0 / thickness + step, step)])
    node, weight = np.polynomial.legendre.leggauss(12)
    half = 0.5 * np.diff(ends)[:, None]
    xi = (0.5 * (ends[1:] + ends[:-1])[:, None] + half * node).ravel()
    share = excess(xi * thickness) * (half * weight).ravel() / np.pi
    near = min(6.0 * thickness, 0.9 * widest)
    r = np.unique(np.r_[np.linspace(0.0, near, 300), np.geomspace(near, widest, 200)])
    return CubicSpline(r, [share @ j0(xi * place) for place in r], bc_type=((1, 0.0), "not-a-knot"))


class Elements:
    """A square of n x n pixels, on a half-space, or on a layer of a thickness with an excess compliance M."""

    def __init__(self, n, pixel, excess=None, thickness=1.0):
        edge = (np.arange(n + 1) - 0.5) * pixel
        x, y = edge[:, None], edge[None, :]
        corner = x * np.arcsinh(y / np.abs(x)) + y * np.arcsinh(x / np.abs(y))
        quarter = (corner[1:, 1:] - corner[:-1, 1:] - corner[1:, :-1] + corner[:-1, :-1]) / np.pi
        if excess is not None:
            place = np.arange(n) * pixel
            r = np.hypot(place[:, None], place[None, :])
            quarter = quarter + pixel**2 * layer_kernel(excess, thickness, 1.01 * r.max())(r)
        self.n, self.pixel, self.size = n, pixel, sf.next_fast_len(2 * n - 1, real=True)
        kernel = np.zeros((self.size, self.size))
        kernel[:n, :n] = quarter
        kernel[self.size - n + 1 :, :n] = quarter[:0:-1]
        kernel[:, self.size - n + 1 :] = kernel[:, n - 1 : 0 : -1]
        self.waves = sf.rfft2(kernel).real

    def displaced(self, p):
        both = sf.rfft2(p, (self.size, self.size)) * self.waves
        return sf.irfft2(both, (self.size, self.size))[: self.n, : self.n]

    def pressed(self, heights, depth):
        """Pressures under a body at a depth."""
        p = np.maximum(depth - heights, 0.0)
        way, before, going = np.zeros_like(p), 1.0, 0.0
        for count in range(2000):
            gap = self.displaced(p) + heights - depth
            on = p > 0.0
            now = np.sum(gap[on] ** 2)
            way = np.where(on, gap + going * now / before * way, 0.0)
            before = now
            push = self.displaced(way)
            step = np.sum((gap * way)[on]) / np.sum((push * way)[on])
            new = np.maximum(p - step * way, 0.0)
            overlap = (new == 0.0) & (gap < 0.0)
            going = 0.0 if overlap.any() else 1.0
            new[overlap] -= step * gap[overlap]
            change, p = abs(new.sum() / p.sum() - 1.0), new
            if count > 10 and np.sqrt(now / on.sum()) < 1e-5 * depth and not overlap.any() and change < 1e-7:
                return p
        raise AssertionError("the elements did not converge")

    def force(self, heights, depth):
        p = self.pressed(heights, depth)
        border = np.r_[p[0], p[-1], p[:, 0], p[:, -1]]
        assert not border.any(), "the contact reaches the border"
        return p.sum() * self.pixel**2


def turned(n, pixel, angle=0.2, apex=(0.37, 0.61)):
    """Coordinates of the pixels of a square about an apex that lies anywhere in its middle pixel, turned."""
    x, y = ((np.arange(n) - 0.5 * n + place) * pixel for place in apex)
    c, s = np.cos(angle), np.sin(angle)
    return c * x[:, None] + s * y, -s * x[:, None] + c * y


def sharp(sides, x, y):
    """Heights of a pyramid whose faces rise by one per length; a cone of no sides."""
    if sides == 0:
        return np.hypot(x, y)
    angles = 2.0 * np.pi * np.arange(sides) / sides
    return np.max([x * np.cos(t) + y * np.sin(t) for t in angles], axis=0)


def rounded(sides, x, y):
    """The same with paraboloids r^2 / 2 rolled inside: r p - p^2 / 2, p the point next to r in a polygon."""
    r, turn = np.hypot(x, y), np.mod(np.arctan2(y, x), 2.0 * np.pi / sides)
    u, v = r * np.cos(turn), r * np.sin(turn)
    middle = np.pi / sides
    along = np.array([-np.sin(middle), np.cos(middle)])
    outside = u * np.cos(middle) + v * np.sin(middle) > np.cos(middle)
    share = np.clip((u * along[0] + v * along[1]) / np.sin(middle), -1.0, 1.0) * np.sin(middle)
    at_u = np.where(outside, np.cos(middle) ** 2 + share * along[0], u)
    at_v = np.where(outside, np.cos(middle) * np.sin(middle) + share * along[1], v)
    return u * at_u + v * at_v - 0.5 * (at_u**2 + at_v**2)


HALF_WIDTH = {0: 0.75, 3: 1.75, 4: 1.2, 5: 1.0, 6: 0.95, 7: 0.92, 8: 0.9}
"""Half of the square over the depth."""


def extrapolated(force, count):
    """Richardson's extrapolation of forces on squares of `count` and twice as many pixels."""
    coarse, fine = force(count), force(2 * count)
    return fine + (fine - coarse) / 3.0
