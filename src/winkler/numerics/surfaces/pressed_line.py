r"""A two-dimensional profile pressed on a half-plane by a force per length, on evenly spaced places.

.. math:: w_i = f_i - \theta x_i - C + \sum_j K_{ij} p_j , \qquad
          K_{ij} = -\frac1\pi\int_{x_j-h/2}^{x_j+h/2}\ln\frac{|x_i-s|}L\,\mathrm ds ,

to which layers add what `winkler.numerics.fields.strips_below` says, and which bodies graded by a power k have with
:math:`(1-|x|^{-k})/k` in place of the logarithm,
with p >= 0, w >= 0 and p w = 0; pressures are even on each element.  Elements that pull are dropped, those that overlap
added, until none does either; for each such set the pressures are linear in C, theta and f, found by conjugate
gradients preconditioned with \|q\| (products by the fast Fourier transform, padded with zeros), and the force, with
the moment if theta is free, gives C and theta.  Grids of half as many elements provide the first set.

A body that is free to tilt may roll by more than its strips are wide between one set and the next, so that the sets
repeat.  Then theta is found from solutions of a prescribed tilt, whose moment grows with it.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.fields.strips_below import Below
from winkler.numerics.pixels.power_law import PowerLawSurface
from winkler.numerics.surfaces.strip_elements import power_elements
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

COARSEST = 96
"""Places of the grid on which the search begins with all elements."""
MOST_ROUNDS = 80
"""Changes of the set of elements in contact before it has not converged; five are usual."""
MOST_ITERATIONS = 600
TILTS = 60
"""Doublings of the interval of tilts in which the moment is sought."""
ACCURACY = 1e-11
"""Residual of the linear equations, over their right-hand side."""
ROUNDING = 1e-15
"""Rounding of a product with the kernel of layers, which may be a million times as soft as their surface."""
TOLERANCE = 1e-9
"""Overlap over the greatest gap, and tension over the greatest pressure, that count as none."""


class PressedLine(NamedTuple):
    r"""The pressed profile.

    Parameters
    ----------
    pressure
        2 p / E*, (n,).
    gap
        w [m], (n,).
    tilt
        theta.
    overlap
        Greatest overlap that is left, over the greatest gap.
    work
        Sum of p \|w\| over the sum of p, over the greatest gap.
    rounds
        Changes of the set on the finest grid.
    """

    pressure: Array
    gap: Array
    tilt: float
    overlap: float
    work: float
    rounds: int


class _LogKernel:
    """Products with K on n places, and with the approximate inverse."""

    def __init__(self, count: int, spacing: float, below: Below | PowerLawSurface | None) -> None:
        from scipy import fft

        self.count = count
        self.fft = fft
        self.size = int(fft.next_fast_len(2 * count, real=True))
        self.rounding = 0.0
        ends = (np.arange(count + 1) - 0.5) * spacing
        length = 2.0 * count * spacing
        whole = ends * np.log(np.abs(ends) / length)
        row = (spacing - np.diff(whole)) / math.pi
        if isinstance(below, PowerLawSurface):
            row = power_elements(below, count, spacing, length)
        elif below is not None:
            row = row + below.of_elements(count, spacing, length)
            self.rounding = ROUNDING * float(np.sum(np.abs(row)))
        kernel = np.zeros(self.size)
        kernel[:count] = row
        kernel[self.size - count + 1 :] = row[:0:-1]
        self.kernel = fft.rfft(kernel)
        q = 2.0 * math.pi * np.arange(self.kernel.size) / (self.size * spacing)
        self.inverse = q + 1.0 / length
        if below is not None:
            self.inverse = self.inverse / below.whole(self.inverse)

    def times(self, content: Array) -> Array:
        """Return K times each row."""
        return self._filtered(content, self.kernel)

    def smoothed_back(self, content: Array) -> Array:
        """Return nearly the inverse of K times each row."""
        return self._filtered(content, self.inverse)

    def _filtered(self, content: Array, factor: Array) -> Array:
        spectrum = self.fft.rfft(content, self.size, axis=-1)
        return np.asarray(self.fft.irfft(spectrum * factor, self.size, axis=-1)[..., : self.count])


def press_line(
    places: Array,
    heights: Array,
    force: float,
    *,
    tilt: float = 0.0,
    moment: float = math.nan,
    below: Below | PowerLawSurface | None = None,
) -> PressedLine:
    """Solve the contact.

    Parameters
    ----------
    places
        x, evenly spaced, (n,), n at least 16.
    heights
        f, (n,), infinite where there is no body.
    force
        2 P / E* [m], positive.
    tilt
        theta, if no moment is given.
    moment
        2 M / E* [m^2] about x = 0; NaN where the tilt is prescribed.
    below
        The layers below the surface, or the power law of the moduli; none of a half-plane.

    Raises
    ------
    NotConverged
        If the set of elements in contact keeps changing.
    """
    grids = [slice(None)]
    step = 1
    while (places.size - 1) // (2 * step) + 1 >= COARSEST:
        step *= 2
        grids.append(slice(None, None, step))
    active = np.isfinite(heights[grids[-1]])
    for part in grids[::-1]:
        x, f = places[part], heights[part]
        if active.size != x.size:
            active = np.repeat(active, 2)[: x.size]
            active = np.append(active, np.full(x.size - active.size, bool(active[-1]))) & np.isfinite(f)
        try:
            pressed = _pressed(x, f, force, tilt, moment, active, below)
        except NotConverged:
            if part == slice(None):
                if math.isnan(moment):
                    raise
                return _balanced(x, f, force, moment, np.isfinite(f), below)
            active = np.isfinite(f)
            continue
        active = pressed.pressure > 0.0
    return pressed


def _pressed(
    x: Array, f: Array, force: float, tilt: float, moment: float, active: Array, below: Below | PowerLawSurface | None
) -> PressedLine:
    spacing = float(x[-1] - x[0]) / (x.size - 1)
    grid, body = _LogKernel(x.size, spacing, below), np.isfinite(f)
    free = not math.isnan(moment)
    rows = np.array([np.ones(x.size), np.where(body, f, 0.0) - (0.0 if free else tilt) * x, x])[: 3 if free else 2]
    span = float(np.ptp(rows[1][body])) or spacing
    known = np.zeros(rows.shape)
    for count in range(MOST_ROUNDS):
        known = _solved(grid, active, rows, known)
        sums = spacing * np.sum(known, axis=1)
        if free:
            turns = spacing * known @ x
            matrix = np.array([[sums[0], sums[2]], [turns[0], turns[2]]])
            right = np.array([force + sums[1], moment + turns[1]])
            sunk, turned = np.linalg.lstsq(matrix, right, rcond=1e-14)[0]
            p, tilt = sunk * known[0] - known[1] + turned * known[2], float(turned)
        else:
            sunk = (force + sums[1]) / sums[0]
            p = sunk * known[0] - known[1]
        sink = float(sunk)
        gap = np.where(body, f - tilt * x, np.inf) - sink + grid.times(p)
        greatest = float(np.max(p))
        pulls, overlaps = active & (p < 0.0), ~active & body & (gap < -TOLERANCE * span)
        if not (np.any(pulls & (p < -TOLERANCE * greatest)) or np.any(overlaps)):
            p = np.where(pulls, 0.0, p)
            bears = p > 0.0
            work = float(np.sum(p[bears] * np.abs(gap[bears])) / np.sum(p)) / span
            return PressedLine(p, gap, tilt, max(0.0, -float(np.min(gap))) / span, work, count)
        active = (active & ~pulls) | overlaps
    raise NotConverged(
        f"the elements in contact still change after {MOST_ROUNDS} rounds on {x.size} places; use more or fewer "
        "elements."
    )


def _balanced(
    x: Array, f: Array, force: float, moment: float, active: Array, below: Below | PowerLawSurface | None
) -> PressedLine:
    """Return the profile under the tilt with which its pressures bear the moment, sought between prescribed tilts."""
    from scipy.optimize import brentq

    spacing = float(x[-1] - x[0]) / (x.size - 1)
    touched = active

    def pressed(tilt: float) -> PressedLine:
        nonlocal touched
        try:
            found = _pressed(x, f, force, tilt, math.nan, touched, below)
        except NotConverged:
            found = _pressed(x, f, force, tilt, math.nan, active, below)
        touched = found.pressure > 0.0
        return found

    def excess(tilt: float) -> float:
        return spacing * float(pressed(tilt).pressure @ x) - moment

    steepest = float(np.max(np.abs(np.diff(f[active])))) / spacing
    low, high = -(steepest + force), steepest + force
    for _ in range(TILTS):
        if excess(low) <= 0.0 <= excess(high):
            break
        low, high = 2.0 * low, 2.0 * high
    else:
        raise NotConverged("no tilt was found under which the force acts where it was given; give a place farther in.")
    return pressed(float(brentq(excess, low, high, xtol=1e-15 * high, rtol=1e-14)))


def _solved(grid: _LogKernel, active: Array, right: Array, start: Array) -> Array:
    """Return p with K p = the rows of `right` on the active elements, zero elsewhere."""
    p = np.where(active, start, 0.0)
    goal = np.where(active, right, 0.0)
    bound = ACCURACY * np.linalg.norm(goal, axis=1)
    r = goal - np.where(active, grid.times(p), 0.0)
    along, before = np.zeros(p.shape), np.ones(len(p))
    for _ in range(MOST_ITERATIONS):
        open_rows = np.linalg.norm(r, axis=1) > np.maximum(bound, grid.rounding * np.linalg.norm(p, axis=1))
        if not open_rows.any():
            return p
        z = np.where(active, grid.smoothed_back(r), 0.0)
        level = np.sum(r * z, axis=1)
        along = z + (level / before)[:, None] * along
        pushed = np.where(active, grid.times(along), 0.0)
        curved = np.sum(along * pushed, axis=1)
        step = np.where(open_rows & (curved > 0.0), level / np.where(curved > 0.0, curved, 1.0), 0.0)
        p += step[:, None] * along
        r -= step[:, None] * pushed
        before = np.where(level > 0.0, level, 1.0)
    raise NotConverged(
        f"the pressures of {int(np.sum(active))} elements in contact were not found; use fewer elements."
    )
