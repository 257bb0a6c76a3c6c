r"""How much the springs of a twisted contact bear before they slide.

A ring that slides carries :math:`\mu p(r)`, so the springs of a sliding outer part of the contact carry
:math:`q(x) = 4\mu x\int_x^a p(r)\,(r^2-x^2)^{-1/2}\,\mathrm dr`: each depends on the pressure of all
rings farther out.  With :math:`q = x\,h(x)` and the pressure as a sum of flat punches' pressures

.. math:: b(x) = \frac{4\mu E^*}\pi\Big[\int_x^a K\big(1-\tfrac{x^2}{t^2}\big)\frac{g'(t)}t\,\mathrm dt
          + (d-g(a))\,\frac{K(1-x^2/a^2)}{a}\Big], \qquad |h|\le b ,

K the complete elliptic integral of the first kind (of the parameter m).  b falls with x where g rises, grows without
limit towards the axis, and is a concave function of the depth, and of the force.  In layered and graded bodies another
kernel takes the place of K (`winkler.media.twisting.kernels`); there b need be none of these.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from winkler.foundation.bed import Bed
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.offers import TwistedWaves, offers
from winkler.media.twisting.kernels import TwistKernel, panel_width, twist_kernel
from winkler.numerics.panels.kink_panels import HALVINGS, Sample, Stretches, stretches
from winkler.numerics.types import Array
from winkler.values.errors import OutsideValidity

if TYPE_CHECKING:  # numerics of layers are loaded with layers
    from winkler.numerics.transforms.cosine_transform import SurfaceResponse

BOUND_ROUNDING = 1e-9
"""Part of the greatest bound that is rounding."""
CONCAVITY_ROUNDING = 1e-9
"""Relative rise of a bound's rate from node to node that is rounding."""


SLIDING_TOLERANCE = 1e-9
"""A load beyond what friction bears by no more than this part of it, as tables of layers err, is that of sliding."""


class PressedState(NamedTuple):
    """How a contact is pressed: what is prescribed (depth [m] or force [N]), its radius [m], and d - g(a) [m]."""

    level: float
    radius: float
    excess: float


class TwistBound:
    """The bound b of springs at fixed places, for every contact up to a widest one.

    Parameters
    ----------
    bed : Bed
        Its medium offers `winkler.media.offers.TwistModuli`.
    coefficient : float
        mu [-].
    widest : float
        [m].
    forced : bool
        Whether the level of a contact is its force, not its depth.
    """

    owner, load, unit, motion, free_motion = "Torsion", "torque", "N m", "angle", "spin"
    """Words of messages."""
    slides = False
    """Whether all of the contact slides at a finite motion; a twist never moves the middle so far."""
    miss = 0.0
    """By which part of them loads are known to err; bounds that rise by no more than this part do not rise."""
    halvings = HALVINGS
    """How often panels halve towards the axis, where the bound of a twist grows like a logarithm."""

    def __init__(self, bed: Bed, coefficient: float, widest: float, forced: bool) -> None:
        self.bed, self.coefficient, self.forced = bed, coefficient, forced
        self.widest = widest
        self.narrowest = widest * 0.5**HALVINGS
        """Radius [m] below which panels resolve no contact: what it bears is far below rounding of the widest."""
        self.endless = math.isinf(coefficient)
        """Whether nothing ever slides."""
        responses = self._responses()
        width, precision = (
            panel_width(self.owner, responses, widest),
            max((r.precision for r in responses), default=0.0),
        )
        self.panels: Stretches = stretches(
            bed.gap_slope, [b for b, _ in bed.kinks], widest, width, precision, self.halvings
        )
        self.x: Array = self.panels.nodes
        self.logarithmic = any(each.smooth > each.length for each in responses)
        """Whether kernels have a logarithm, so that what springs bear is smooth between the ends of panels alone."""
        self._coefficient = 0.0 if self.endless else coefficient
        self.clock: Array = self.level(self.x.ravel()).reshape(self.x.shape)
        """At which level each spring comes into contact, at the nodes."""
        self._kernel: TwistKernel = self._springs()
        self.weight: Array = self._kernel.weight.reshape(self.x.shape)
        """e(x)^2 [m^2] at the nodes: what springs count in torque and energy."""
        self._gather()

    def _responses(self) -> tuple[SurfaceResponse, ...]:
        """Return the responses whose kernels are read on the panels."""
        medium = self.bed.medium
        return (medium.response, medium.across_response) if offers(medium, TwistedWaves) else ()

    def _springs(self) -> TwistKernel:
        return twist_kernel(self.bed.medium, self.panels)

    def level(self, radius: Array) -> Array:
        """Return the level at which the contact has this radius: g, or the force."""
        if not self.forced:
            return self.bed.gap(radius)
        return self.bed.stiffness(radius) * self.bed.gap(radius) - self.bed.gap_load(radius)

    @functools.lru_cache(maxsize=64)  # noqa: B019 - as `at`
    def inertia(self, radius: float) -> float:
        """Return 2 int e^2 dx up to a radius [m^3]: the torsional stiffness over 8 G_t."""
        if isinstance(self.bed.medium, HomogeneousMedium):
            return 2.0 / 3.0 * radius**3
        return 2.0 * float(self.panels.integral(self.weight, np.array([radius]))[0])

    def weigh(self, sample: Sample) -> Array:
        """Return e(x)^2 [m^2] at the places of a sample."""
        return sample.x**2 if isinstance(self.bed.medium, HomogeneousMedium) else sample.read(self.weight)

    def _gather(self) -> None:
        panels, t = self.panels, self.x.ravel()
        self._table: Array = self._kernel.bound * (self.bed.gap_slope(t) * panels.stretch.ravel())
        table = self._table.reshape(t.size, *self.x.shape)
        number, own = np.arange(self.x.shape[0]), np.arange(t.size) // self.x.shape[1]
        whole = np.einsum("ipk,pk->ip", table, panels.part(panels.edges[1:], number))
        whole[number < own[:, None]] = 0.0
        before = panels.part(t, own) * table[np.arange(t.size), own]
        self._sums: Array = np.cumsum(whole, axis=1) - whole - np.sum(before, axis=1)[:, None]

    @functools.lru_cache(maxsize=64)  # noqa: B019 - bounds are few and cached by `twist_bound`
    def at(self, press: PressedState) -> Array:
        """Return b at the nodes [Pa], and what it would go on to be just beyond the edge, in the edge's panel.

        Raises
        ------
        OutsideValidity
            If sliding rings would turn the inner part of the contact against the twist: then no outer ring slides
            alone.
        """
        return np.asarray(self._each([press])[0])

    def each(self, presses: Sequence[PressedState]) -> Array:
        """Return `at` of each of several contacts, ``(m, panels, nodes)``."""
        return self.at(presses[0])[None] if len(presses) == 1 else self._each(presses)

    def _each(self, presses: Sequence[PressedState]) -> Array:
        radii, excess = (np.array([press[part] for press in presses]) for part in (1, 2))
        found, place = self.over(radii, excess), self.x.ravel()
        inside = np.where(place < radii[:, None], found, 0.0)
        wrong = np.min(inside, axis=1) < -BOUND_ROUNDING * np.max(inside, axis=1)
        if wrong.any():
            raise OutsideValidity(
                f"{self.owner}: at a contact radius of {radii[np.argmax(wrong)]:.3g} m the rings that would slide "
                "first are not the outer ones, since the coating spreads their traction inwards; request a narrower "
                "contact."
            )
        return np.asarray(self._coefficient * found.reshape(-1, *self.x.shape))

    def over(self, radii: Array, excess: Array) -> Array:
        """Return the bounds over mu of contacts of these radii, pressed beyond the rim so far, ``(m, nodes)``."""
        panels, count = self.panels, self.x.shape[1]
        result, k = np.zeros((radii.size, self.x.size)), panels.panel(radii)
        for panel in np.unique(k[radii > 0.0]).tolist():  # contacts whose edges share a panel, at once
            rows = np.flatnonzero((k == panel) & (radii > 0.0))
            used = (panel + 1) * count
            last, place = slice(used - count, used), (radii[rows], k[rows])
            found = self._sums[:used, panel] + panels.part(*place) @ self._table[:used, last].T
            if np.any(excess[rows] > 0.0):
                found += excess[rows, None] * (panels.reading(*place) @ self._kernel.bound[:used, last].T)
            result[rows, :used] = found
        return result

    @functools.cached_property
    def concave(self) -> bool:
        """Whether every bound is a concave function of the level, so that one move is right, however long."""
        if isinstance(self.bed.medium, HomogeneousMedium):
            return True
        x = self.x.ravel()
        rate = self._kernel.bound / (self.bed.stiffness(x) if self.forced else 1.0)
        # where a spring is deep inside the contact, or at its edge
        falls = np.diff(rate, axis=1) <= CONCAVITY_ROUNDING * np.abs(rate[:, :-1])
        return bool(np.all(falls[np.triu_indices(x.size, 0, x.size - 1)]))

    def onset(self, kink: float, strength: float) -> float:
        """Return how -b' diverges above a kink at which g' holds strength / sqrt(x^2 - kink^2) [Pa]."""
        meeting = np.diagonal(self._kernel.bound).reshape(self.x.shape)
        return self._coefficient * float(self.panels.value(meeting * self.x, np.array([kink]))[0]) * strength / kink

    @functools.lru_cache(maxsize=64)  # noqa: B019 - as `at`
    def most(self, press: PressedState) -> float:
        """Return the torque at which everything slides [N m]."""
        if self.endless:
            return math.inf if press.radius > 0.0 else 0.0
        return 2.0 * float(self.panels.integral(self.at(press) * self.weight, np.array([press.radius]))[0])

    def borne(self, load: float, limit: float) -> float:
        """Return a load, or where it is that of sliding but for rounding, what the contact bears at most."""
        sliding = self.slides and limit < abs(load) <= limit * (1.0 + SLIDING_TOLERANCE)
        return math.copysign(limit, load) if sliding else load


@functools.lru_cache(maxsize=8)
def twist_bound(bed: Bed, coefficient: float, widest: float, forced: bool) -> TwistBound:
    """Return the bound, cached by value."""
    return TwistBound(bed, coefficient, widest, forced)
