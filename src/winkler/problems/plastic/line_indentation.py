r"""A cylinder pressed into metal, or metal into it, in plane strain: loaded, let go, and loaded again.

Each of two half-planes stands against a share s of the gap, and both bear the same mean pressure, as for bodies of
revolution (`winkler.problems.plastic.first_loading`), by the tables of `winkler.problems.plastic.yielded_line`:

.. math:: p = p_1(E_1 s_1 P) = p_2(E_2 s_2 P), \qquad P = \frac{\pi a}{8R}, \qquad s_1 + s_2 = 1, \qquad
          d_0 = \frac{a^2}{2R}\left[(s_1+f_2) D_1 + (s_2+f_1) D_2\right] .

Here :math:`f_i=(1-\ln2)\,s_i\,e^{-L_i}(\theta_i-\theta)` is what a body leaves of its share to the other one, as the
common pressure is more even than its own would be: an even pressure bends a surface less between middle and edge.

Unloading is elastic on the dent.  With :math:`\xi = c/a` a strip of the half-width c bears

.. math:: \frac FP = \theta\xi^2 + (1-\theta)\left(1-\sqrt{1-\xi^2}\right) .

The surface of a half-plane sinks without bound, so that a line has no depth; what is lost does not depend on where the
depth is counted from.  With :math:`m = 1 + \theta(\ln2-\tfrac12)` and the energy k of both shapes of pressure,

.. math:: W = \int F\,\mathrm dd_0 + \frac1{\pi E^*}\left[F^2(m-k) + \int F^2\left(\mathrm dm -
          \frac{\mathrm da}a\right)\right] .
"""

from __future__ import annotations

import functools
import math
from typing import ClassVar, NamedTuple

import numpy as np

from winkler.foundation.line import LineFoundation
from winkler.loading.loads import LineForce
from winkler.materials.elastic import Elastic
from winkler.materials.hardening import Hardening
from winkler.media.halfspace import HalfSpace
from winkler.numerics.equations.bracketing import between
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.line.pressing_load import pressing
from winkler.problems.line.validity import line_notes
from winkler.problems.plastic.first_loading import refuse_strengths
from winkler.problems.plastic.yielded_line import (
    GREATEST_POISSON,
    LEAST_POISSON,
    LineHalf,
    beyond_line_tables,
    line_onset,
)
from winkler.problems.plastic.yielding_half import borne_together, divided
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

POINTS_PER_EFOLD, NODES = 48, 4
LEFT_AT_EDGE = 1.0 - math.log(2.0)
"""By which part an even pressure bends the surface less between middle and edge than that of Hertz: what a body does
not take of the gap for that reason stands against the other one."""
JOHNSON = "K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 6.3, doi:10.1017/CBO9781139171731"


class _LineLoad(NamedTuple):
    """States of first loading `(n,)`: a [m], F [N/m], d0 [m], theta [-]."""

    half_width: Array
    force: Array
    dent: Array
    elastic_share: Array


class _LineLoading(NamedTuple):
    """First loading of a cylinder on two half-planes; `onset` is the half-width where one of them yields [m]."""

    radius: float
    modulus: float
    first: LineHalf
    second: LineHalf
    onset: float

    def strain(self, half_width: Array) -> tuple[Array, Array]:
        """Return P [-], and the exponent of a parabola, at half-widths `(n,)` [m]."""
        return math.pi * half_width / (8.0 * self.radius), np.full_like(half_width, 2.0)

    def at(self, half_width: Array) -> _LineLoad:
        """Return the states at half-widths `(n,)` [m], positive."""
        bodies, shape = (self.first, self.second), self.strain(half_width)
        pressure, kept, answers = borne_together(*bodies, divided(*bodies, *shape), *shape)
        flatter = [part * np.exp(-answer.fall) * (1.0 - kept - answer.evening) for part, answer in answers]
        dent = sum(
            answer.sinking * (part + LEFT_AT_EDGE * (sum(flatter) - own))
            for (part, answer), own in zip(answers, flatter, strict=True)
        )
        return _LineLoad(half_width, 2.0 * half_width * pressure, dent * half_width**2 / (2.0 * self.radius), kept)

    def under(self, force: Array) -> Array:
        """Return the half-widths [m] under forces per length [N/m], positive."""
        elastic = np.sqrt(4.0 * self.radius * force / (math.pi * self.modulus))
        wide = elastic.copy()
        yields = elastic > self.onset
        if yields.any():
            low, wanted = elastic[yields], force[yields]
            high = low * wanted / self.at(low).force  # the mean pressure grows with the half-width
            wide[yields] = between(lambda a, index: self.at(a).force - wanted[index], low, high * (1.0 + 1e-12))
        return wide

    def lost(self, reached: _LineLoad) -> Array:
        """Return what first loading up to states `(n,)` has cost for good [J/m]."""
        from scipy.interpolate import CubicSpline

        half_width = reached.half_width
        lost = np.zeros_like(half_width)
        past = half_width > self.onset
        if not past.any():
            return lost
        low, high = math.log(self.onset), math.log(float(np.max(half_width)))
        places = np.linspace(low, high, 3 + math.ceil(POINTS_PER_EFOLD * (high - low)))
        state = self.at(np.exp(places))
        middle, apart = _shapes(state.elastic_share)
        force, dent, turned = (CubicSpline(places, row) for row in (state.force, state.dent, middle))
        nodes, weights = gauss_legendre(NODES)
        scale = 1.0 / (math.pi * self.modulus)

        def spent(start: Array, end: Array) -> Array:
            x = start[:, None] + (end - start)[:, None] * nodes
            f = force(x)
            rate = f * dent(x, 1) + scale * f * f * (turned(x, 1) - 1.0)
            return np.asarray((rate @ weights) * (end - start))

        whole = np.append(0.0, np.cumsum(spent(places[:-1], places[1:])))
        reversible = scale * state.force**2 * (middle - apart)
        at = np.log(half_width[past])
        index = np.clip(np.searchsorted(places, at, side="right") - 1, 0, places.size - 2)
        m, k = _shapes(reached.elastic_share[past])
        rest = scale * reached.force[past] ** 2 * (m - k) - reversible[0]
        lost[past] = np.maximum(whole[index] + spent(places[index], at) + rest, 0.0)
        return lost


def _shapes(share: Array) -> tuple[Array, Array]:
    """Return m and k of pressures of which a share is Hertz's and the rest even."""
    log, even = math.log(2.0), 1.0 - share
    energy = share**2 * (log + 0.25) + 2.0 * share * even * (log + 1.0 / 6.0) + even**2 * (1.5 - log)
    return 1.0 + share * (log - 0.5), energy


@value
class LinePlasticIndentation:
    """A cylinder pressed on a half-plane in plane strain; at least one body yields.

    Parameters
    ----------
    bed : LineFoundation
        A `Paraboloid` (the parabolic cylinder) over a `HalfSpace`; at least one body has a strength.
    path : LineForce
        Forces per length [N/m], in sequence, ``(steps,)``.

    Raises
    ------
    InvalidInput
        If no body has a strength, or a strength is above a fiftieth of Young's modulus. If profile, medium or path has
        the wrong type.

    References
    ----------
    K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 6.3, doi:10.1017/CBO9781139171731

    Examples
    --------
    >>> from winkler.profiles.power import Paraboloid
    >>> steel = Elastic(young=210e9, poisson=0.3, strength=1e9)
    >>> bed = LineFoundation(Paraboloid(10e-3), HalfSpace(steel))
    >>> pressed = LinePlasticIndentation(bed, LineForce([1e6, 3e6, 0.0])).solve()
    >>> bool(pressed.residual_depth[0] > 5e-7), bool(pressed.half_width[2] > 0.0)
    (True, False)
    """

    __words__ = words(
        bed=("", None, "profile and bodies of the line contact"),
        path=("", None, "the forces per length, one after the other"),
        yield_force=("P_Y", "N/m", "force per length under which a body begins to yield"),
    )

    bed: LineFoundation
    path: LineForce[Array]

    references: ClassVar[tuple[str, ...]] = ("johnson_1985",)
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED

    def __post_init__(self) -> None:
        shape = np.shape(self.path.force_per_length)
        if len(shape) != 1:
            raise InvalidInput(
                f"LinePlasticIndentation: the path has the shape {shape}; give its forces one after the other in one "
                "row."
            )
        _refuse_unknown(self.bed)

    @property
    def yield_force(self) -> float:
        """Force per length under which one of the bodies begins to yield [N/m]."""
        loading = _line_loading(self.bed)
        return math.pi * loading.modulus * loading.onset**2 / (4.0 * loading.radius)

    def solve(self) -> LinePlasticSolution:
        """Return the whole path.

        Raises
        ------
        OutsideValidity
            If a force is tensile.
        """
        force = pressing("LinePlasticIndentation", self.path)
        loading = _line_loading(self.bed)
        greatest, group = np.unique(np.maximum.accumulate(force), return_inverse=True)
        pressed = greatest > 0.0
        wide, dent, lost = (np.zeros_like(greatest) for _ in range(3))
        even = np.zeros_like(greatest)
        wide[pressed] = loading.under(greatest[pressed])
        state = loading.at(wide[pressed])
        dent[pressed], even[pressed], lost[pressed] = state.dent, 1.0 - state.elastic_share, loading.lost(state)
        even, most = even[group], greatest[group]
        left = 1.0 - np.where(most > 0.0, force / np.where(most > 0.0, most, 1.0), 0.0)
        root = 2.0 * left / (even + np.sqrt(even**2 + 4.0 * (1.0 - even) * left) + (left == 0.0))
        xi = np.where(most > 0.0, np.sqrt(np.maximum((1.0 - root) * (1.0 + root), 0.0)), 0.0)
        return LinePlasticSolution(self, force, xi * wide[group], dent[group], wide[group], even, lost[group])


@value
class LinePlasticSolution:
    """The solution of a `LinePlasticIndentation`, point by point.

    Parameters
    ----------
    problem : LinePlasticIndentation
        The problem that was solved.
    force_per_length, half_width : ndarray, (steps,)
        P [N/m], compression positive, and a [m], zero without contact.
    residual_depth : ndarray, (steps,)
        d0 [m], the depth of the dent after unloading: its middle below points far away, sum over both bodies.
    largest_half_width : ndarray, (steps,)
        Half-width under the maximum load so far [m]: half the width of the dent.
    even_share : ndarray, (steps,)
        Fraction of the maximum load that is carried by a uniform pressure [-]; the rest has Hertz's pressure. Zero for
        elastic bodies.
    dissipation : ndarray, (steps,)
        Work of loading that unloading does not return [J/m]; a part of it remains as residual stress.
    """

    __words__ = words(
        largest_half_width=("a_m", "m", "half-width of the contact under the greatest load so far"),
        even_share=("", "", "part of the greatest load that has an even pressure"),
        dissipation=("W", "J/m", "energy lost per length"),
        yield_force=("P_Y", "N/m", "force per length under which a body begins to yield"),
    )

    problem: LinePlasticIndentation
    force_per_length: Array
    half_width: Array
    residual_depth: Array
    largest_half_width: Array
    even_share: Array
    dissipation: Array

    @property
    def yield_force(self) -> float:
        """As in the problem [N/m]."""
        return self.problem.yield_force

    @property
    def mean_pressure(self) -> Array:
        """P / (2 a) [Pa]; zero without contact."""
        width = 2.0 * self.half_width
        return np.asarray(self.force_per_length / np.where(width > 0.0, width, 1.0))

    def surface(self, x: Array) -> Array:
        """Return the unloaded surface after the path, both bodies together.

        Parameters
        ----------
        x : ndarray
            Positions within the dent [m], on either side of its middle.

        Returns
        -------
        ndarray
            Height relative to points far away [m], negative below; nan outside the dent.
        """
        if self.half_width.size == 0 or self.largest_half_width[-1] <= _line_loading(self.problem.bed).onset:
            return np.zeros(np.shape(x))
        loading, a = _line_loading(self.problem.bed), float(self.largest_half_width[-1])
        most, even = float(np.max(self.force_per_length)), float(self.even_share[-1])
        rho = np.asarray(x, dtype=float) / a
        rho = np.where(np.abs(rho) <= 1.0 + 1e-12, np.clip(rho, -1.0, 1.0), np.nan)
        strip = sum(
            (1.0 + way * rho) * np.log(np.maximum(1.0 + way * rho, np.finfo(float).tiny)) for way in (1.0, -1.0)
        )
        back = 2.0 * most / (math.pi * loading.modulus) * ((1.0 - even) * rho**2 + even * 0.5 * strip)
        return np.asarray(0.5 * (rho * a) ** 2 / loading.radius - back - self.residual_depth[-1])

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        bed, widest = self.problem.bed, float(np.max(self.largest_half_width, initial=0.0))
        loading = _line_loading(bed)
        if widest <= loading.onset:
            return line_notes(bed, widest)
        notes = [note for note in line_notes(bed, widest) if note.assumption is not Assumption.RESPONSE]
        notes.append(LAW)
        if any(isinstance(body.solid, Hardening) for body in (loading.first, loading.second)):
            notes.append(HARDENED)
        strain, exponent = loading.strain(np.array([widest]))
        share = divided(loading.first, loading.second, strain, exponent).share
        bodies = ((loading.first, share), (loading.second, 1.0 - share))
        if any(
            beyond_line_tables(float((body.modulus * part * strain)[0]) / body.strength, body.start)
            for body, part in bodies
            if math.isfinite(body.strength)
        ):
            notes.append(FULLY_PLASTIC)
        return tuple(notes)


LAW = Note(
    Assumption.RESPONSE,
    Standing.APPROXIMATE,
    "Plastic deformation follows tables fitted to plane-strain finite elements (small strains, no friction). In "
    "their range the half-width at a given force has an error of up to 1 %. The residual depth has an error of "
    "0.03 of a^2/2R. The force during unloading has an error of 0.03 of the maximum force. Part of the dissipated "
    "energy remains in the bodies as residual stress.",
    "finite elements of this package, of two kinds; " + JOHNSON,
    0.03,
)
HARDENED = Note(
    Assumption.RESPONSE,
    Standing.APPROXIMATE,
    "A body hardens: its strength is the flow stress at the representative strain of a ball. Against finite elements "
    "that harden linearly by up to 0.1 E the half-width errs by up to 1 % and the residual depth by 0.02 of a^2/2R, at "
    "0.2 E by 2 % and 0.03. Power laws were not tested. The edge of the dent is 0.03 of a^2/2R too low at 0.05 E, and "
    "0.08 at 0.2 E.",
    "finite elements of this package; D. Tabor, The Hardness of Metals, Oxford University Press 1951",
    0.03,
)
FULLY_PLASTIC = Note(
    Assumption.RESPONSE,
    Standing.APPROXIMATE,
    "The load exceeds the range of the finite elements, which ends at 20 times the pressure of first yield. "
    "Beyond it the mean pressure is continued to Prandtl's limit, 2.97 times the strength. Its error may be 5 %.",
    "R. Hill, The Mathematical Theory of Plasticity, Oxford University Press 1950",
    0.05,
)


def _refuse_unknown(bed: LineFoundation) -> None:
    """Refuse a bed of which it is not known how its bodies yield."""
    owner = "LinePlasticIndentation"
    if not isinstance(bed.medium, HalfSpace):
        raise InvalidInput(
            f"{owner}: the medium is a {type(bed.medium).__name__}; yield in line contact is implemented for "
            "isotropic bodies with one strength each. Give a HalfSpace."
        )
    if not bed.hertzian:
        raise InvalidInput(
            f"{owner}: the profile is a {type(bed.profile).__name__}; how a line yields is known of cylinders only: "
            "give a Paraboloid."
        )
    refuse_strengths(owner, bed.medium, (LEAST_POISSON, GREATEST_POISSON))


@functools.lru_cache(maxsize=64)
def _line_loading(bed: LineFoundation) -> _LineLoading:
    medium = bed.medium
    assert isinstance(medium, HalfSpace)
    onset, halves = math.inf, []
    for solid in (medium.first, medium.second):
        if not isinstance(solid, Elastic):
            halves.append(LineHalf(math.inf, 0.0, math.inf, math.inf, solid))
            continue
        start, modulus = line_onset(solid.poisson), solid.young / (1.0 - solid.poisson**2)
        halves.append(LineHalf(modulus, solid.poisson, solid.strength, start, solid))
        onset = min(onset, 8.0 * bed.hertz_radius * start * solid.strength / (math.pi * medium.modulus))
    return _LineLoading(bed.hertz_radius, medium.modulus, halves[0], halves[1], onset)
