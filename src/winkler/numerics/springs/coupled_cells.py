r"""Cells of a line load that move one another and creep: one step of a contact with all that it remembers.

The line load q is straight between the middles of cells of a width h, a sum of hats; its displacement is a sum of
exponentials (`winkler.numerics.transforms.wave_creep`), prescribed as a mean over each hat, and over a step of time q
changes steadily.  Then a step is the contact of an elastic surface with the compliance

.. math:: A = G_0 + \sum_m (1-g_m)\,G_m , \qquad g_m = \frac{\lambda_m}{\Delta t}\big(1-e^{-\Delta t/\lambda_m}\big) ,

on a shape that the memory has dented.  With :math:`A = LL^{\mathsf T}` the factors of all contacts [0, a] are blocks of
L: the cells become independent springs whose displacements :math:`v = L^{-1}\,h\,(d-h_i-\text{dent})` say at once how
far the contact reaches, :math:`v_i>0`, and what it bears, :math:`F = 2\sum v_i\,(L^{-1}h)_i`.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

EDGE_SHIFT = 0.5 - 0.5 / math.sqrt(3.0)
"""By so many cells a contact is wider than where the last of its cells would bear nothing.

Of hats on a medium without waves, whose factor has d^2 + e^2 = 2/3 and d e = 1/6, it is e / (d + e).
"""
STRIP_EDGE_SHIFT = 0.0283
"""The same of hats of pressure on a plane surface: what a flat strip sinks by is that of a strip so much wider."""
MOST_FACTORS, MOST_NUMBERS_KEPT = 48, 8_000_000
"""Steps of so many lengths are kept, with so many numbers, but those of two in any case."""


class LoadedCells(NamedTuple):
    """The cells at one moment.

    Parameters
    ----------
    depth, force, radius : float
        d [m], F [N], a [m].
    held : int
        How many cells bear.
    ring : bool
        Whether cells beyond them would be pressed, too.
    load : ndarray, (n,)
        q [N/m].
    waves : ndarray, (2 n,)
        Its waves.
    memory : ndarray, (M, 2 n)
        What every retardation time remembers of q, wave by wave.
    """

    depth: float
    force: float
    radius: float
    held: int
    ring: bool
    load: Array
    waves: Array
    memory: Array


class BorneCells(NamedTuple):
    """What the cells bear at one moment: d [m], F [N], and how many cells bear it."""

    depth: float
    force: float
    held: int


class _Factor(NamedTuple):
    """What depends on the length of a step alone."""

    fade: Array
    share: Array
    faded: Array
    shared: Array
    steady: Array
    lower: Array
    diagonal: Array
    unit: Array


class CoupledCells:
    """Cells from the axis to some radius, under a shape.

    Parameters
    ----------
    kernels : ndarray, (1 + M, 2 n)
        Of `WaveCreep.kernels` [m/Pa].
    times : ndarray, (M,)
        lambda_m [s].
    width : float
        Of the cells [m].
    shape : ndarray, (n,)
        The equivalent profile on a homogeneous body in the middle of the cells [m].
    edge_shift : float, optional
        By so many cells contacts are wider than where their last cells bear nothing.
    odd : bool, optional
        Whether mirror images bear the opposite, as under a twist; such cells are not pressed.
    """

    def __init__(
        self,
        kernels: Array,
        times: Array,
        width: float,
        shape: Array,
        edge_shift: float = EDGE_SHIFT,
        *,
        odd: bool = False,
    ) -> None:
        count, self.edge_shift, self.odd = shape.size, edge_shift, odd
        self.kernels, self.times, self.width, self.shape, self.count = kernels, times, width, shape, count
        self.middle = width * (np.arange(count) + 0.5)
        around = np.zeros((kernels.shape[0], 4 * count))
        around[:, : 2 * count], around[:, 2 * count + 1 :] = kernels, kernels[:, :0:-1]
        self.waves = np.fft.rfft(around, axis=1).real[:, int(odd) : 2 * count + int(odd)]
        self._factors: dict[float, _Factor] = {}
        self._scratch = np.empty((times.size, 2 * count))  # new arrays of this size cost more than what is done in them

    @property
    def at_rest(self) -> LoadedCells:
        """Cells that nothing has ever pressed."""
        memory = np.zeros((self.times.size, 2 * self.count))
        return LoadedCells(
            float(self.shape[0]), 0.0, 0.0, 0, False, np.zeros(self.count), np.zeros(2 * self.count), memory
        )

    def transformed(self, load: Array) -> Array:
        """Return the waves of a load of the cells and their mirror images, ``(2 n,)``."""
        from scipy.fft import dct, dst

        return np.asarray((dst if self.odd else dct)(np.concatenate([load, np.zeros(self.count)]), norm="ortho"))

    def restored(self, waves: Array) -> Array:
        """Return what waves are in the cells, ``(n,)``."""
        from scipy.fft import idct, idst

        return np.asarray((idst if self.odd else idct)(waves, norm="ortho")[: self.count])

    def matrix(self, kernel: Array) -> Array:
        """Return how cells and their mirror images move one another, ``(n, n)``, for one kernel ``(2 n,)``."""
        from scipy.linalg import hankel, toeplitz

        near = kernel[: self.count]  # given twice: a complex row alone would be conjugated
        mirrored = hankel(kernel[1 : self.count + 1], kernel[self.count :])
        return np.asarray(toeplitz(near, near) + (-mirrored if self.odd else mirrored))

    def step(
        self, state: LoadedCells, span: float, depth: float | None, force: float | None, beside: float = 0.0
    ) -> LoadedCells:
        """Return the cells after a time [s], zero for a sudden change, at a depth [m] or under a force [N].

        A spring beside them, of a stiffness [N/m] and without force at no depth, may bear a part of the force.
        """
        from scipy.linalg.lapack import dtrtrs

        factor = self._factor(span)
        depth, pressed, bears, held = self._pressed(span, state, depth, force, beside)
        # behind the contact the load is zero: the leading block of the factor is that of the contact
        load = np.zeros(self.count)
        if held:
            load[:held], _ = dtrtrs(factor.lower[:, :held], pressed[:held], lower=1, trans=1)
        total = 2.0 * self.width * float(np.sum(load))
        ring = bool(bears[held:].any())
        radius = self._radius(pressed / factor.diagonal, held)
        found = self.loaded(state, span, load)
        return found._replace(depth=depth, force=total, radius=radius, held=held, ring=ring)

    def loaded(self, state: LoadedCells, span: float, load: Array) -> LoadedCells:
        """Return the cells after a time [s] in which their load has changed steadily to another one ``(n,)``."""
        factor, waves = self._factor(span), self.transformed(load)
        memory = factor.fade[:, None] * state.memory
        memory += np.multiply(factor.share[:, None], waves - state.waves, out=self._scratch)
        return state._replace(load=load, waves=waves, memory=memory)

    def carried(self, state: LoadedCells, span: float) -> Array:
        """Return how far the cells are displaced after a time [s] without a load of theirs [m], ``(n,)``."""
        factor = self._factor(span)
        dent = factor.shared * state.waves - np.einsum("mk,mk->k", factor.faded, state.memory)
        return self.restored(dent) / self.width

    def effective(self, span: float) -> Array:
        """Return how far loads [N/m] that change steadily over a time [s] displace the cells [m], ``(n, n)``."""
        share = self._factor(span).share
        return self.matrix(self.kernels[0] + (1.0 - share) @ self.kernels[1:]) / self.width

    def borne(self, state: LoadedCells, span: float, depth: float | None, force: float | None) -> BorneCells:
        """Return depth, force and number of cells after a time, as `step`, without what the cells remember of it."""
        factor = self._factor(span)
        depth, pressed, _, held = self._pressed(span, state, depth, force)
        return BorneCells(depth, 2.0 * float(pressed[:held] @ factor.unit[:held]), held)

    def _pressed(
        self, span: float, state: LoadedCells, depth: float | None, force: float | None, beside: float = 0.0
    ) -> tuple[float, Array, Array, int]:
        """Return depth, displacements v of independent springs ``(n,)``, which of them bear, and how many in a row."""
        from scipy.linalg.lapack import dtrtrs

        factor = self._factor(span)
        offset = -self.width * (self.shape + self.carried(state, span))
        still, _ = dtrtrs(factor.lower, offset, lower=1)
        if depth is None:
            depth = self._depth_under(force or 0.0, factor.unit, still, beside)
        pressed = depth * factor.unit + still
        bears = pressed > 0.0
        return depth, pressed, bears, self.count if bears.all() else int(np.argmin(bears))

    def _depth_under(self, force: float, unit: Array, still: Array, beside: float) -> float:
        """Return the depth at which independent springs, and one beside them, bear a force."""
        touched = -still / unit
        if beside > 0.0 and force <= beside * touched[0]:
            return force / beside
        if force <= 0.0:
            return float(np.min(touched))
        stiffness, offset = np.cumsum(unit * unit) + 0.5 * beside, np.cumsum(unit * still)
        beyond = 2.0 * (touched[1:] * stiffness[:-1] + offset[:-1]) >= force
        last = int(np.argmax(beyond)) if beyond.any() else self.count - 1
        return float((0.5 * force - offset[last]) / stiffness[last])

    def _radius(self, last: Array, held: int) -> float:
        """Return where the line load vanishes, from what the last cell of contacts of all widths would bear."""
        if held == 0:
            return 0.0
        if held == self.count:
            return (held + self.edge_shift) * self.width
        inner, outer = float(last[held - 1]), float(last[held])
        return float(self.middle[held - 1]) + self.width * (inner / (inner - outer) + self.edge_shift)

    def _factor(self, span: float) -> _Factor:
        key = float(f"{span:.9e}")
        if key not in self._factors:
            from scipy.linalg import cholesky, solve_triangular

            turns = span / self.times
            fade = np.exp(-turns)
            share = -np.expm1(-turns) / turns if span > 0.0 else np.ones(turns.size)
            matrix = self.matrix(self.kernels[0] + (1.0 - share) @ self.kernels[1:])
            try:
                lower = np.asfortranarray(cholesky(matrix, lower=True, overwrite_a=True, check_finite=False))
            except np.linalg.LinAlgError as failed:
                raise NotConverged(
                    "The compliance of the layers is lost in rounding: the contact is too wide against them, or their "
                    "contrast too large; press less, or give thicker layers."
                ) from failed
            unit = solve_triangular(lower, np.full(self.count, self.width), lower=True, check_finite=False)
            while len(self._factors) >= min(MOST_FACTORS, max(2, MOST_NUMBERS_KEPT // self.count**2)):
                self._factors.pop(next(iter(self._factors)))
            self._factors[key] = _Factor(
                fade, share, fade[:, None] * self.waves[1:], share @ self.waves[1:], _steady(turns) @ self.waves[1:],
                lower, np.diag(lower), unit,
            )  # fmt: skip
        return self._factors[key]

    def displacement(self, state: LoadedCells) -> Array:
        """Return u [m] in the cells."""
        kept = np.subtract(state.waves, state.memory, out=self._scratch)
        return self.restored(self.waves[0] * state.waves + np.einsum("mk,mk->k", self.waves[1:], kept)) / self.width

    def stored(self, state: LoadedCells) -> float:
        """Return the energy stored [J]."""
        kept = np.subtract(state.waves, state.memory, out=self._scratch)
        np.multiply(kept, kept, out=kept)
        return float(self.waves[0] @ state.waves**2 + np.vdot(self.waves[1:], kept))

    def lost(self, before: LoadedCells, after: LoadedCells, span: float) -> float:
        """Return what a step has lost [J], the integral of c_m z_m^2 / lambda_m with the memory z_m in closed form."""
        if span == 0.0:
            return 0.0
        change, factor, gone = after.waves - before.waves, self._factor(span), -np.expm1(-span / self.times)
        borne = np.multiply(self.waves[1:], before.memory, out=self._scratch)
        total = (gone - 0.5 * gone**2) @ np.einsum("mk,mk->m", borne, before.memory)
        total += (gone * factor.share) @ (borne @ change) + factor.steady @ change**2
        return 2.0 * float(total)


def _steady(turns: Array) -> Array:
    """Return what a steady change in steps of so many times loses: turns - 2 (1 - e) + (1 - e^2) / 2 over turns^2."""
    series = turns * (1.0 / 3.0 - turns * (0.25 - 7.0 / 60.0 * turns))  # where it cancels
    with np.errstate(divide="ignore", invalid="ignore"):
        whole = (turns + 2.0 * np.expm1(-turns) - 0.5 * np.expm1(-2.0 * turns)) / turns**2
    return np.asarray(np.where(turns < 1e-2, series, whole))
