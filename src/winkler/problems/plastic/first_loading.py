r"""The curve along which two bodies of revolution are pressed together for the first time, yielding or not.

A pair of half-spaces yields together: the surface that they share stands against the first body as a share s of the gap
between them, against the second as the rest, and both bear the same mean pressure,

.. math:: p = p_1(E_1 s P) = p_2(E_2 (1-s) P), \qquad P = \frac{2}{\pi a^2}\int_0^a (g(a)-g(x))\,\mathrm dx,
          \qquad d = g(a)\left(\frac{s}{\Gamma_1} + \frac{1-s}{\Gamma_2}\right),

where E P is the mean pressure that an elastic body would bear under a rigid one.  While both are elastic, and where
both are alike, this is no approximation.

On the springs of an ellipse (`winkler.foundation.elliptic`) the mean pressure is that over its area, and the tables of
a ball count from the onset of the ellipse on.  As it yields it gets rounder, from Hertz' ratio of its axes towards the
root of that of the curvature radii, and springs back further by the factor c of a rounder ellipse of the same area.
"""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.elliptic import EllipticFoundation
from winkler.foundation.footprint import EllipticOutline
from winkler.foundation.foundation import Foundation
from winkler.foundation.on_medium import UnderProfile
from winkler.materials.elastic import RIGID, Elastic, Solid
from winkler.media.halfspace import HalfSpace
from winkler.media.offers import LayerStack, offers
from winkler.numerics.equations.roots import invert
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array
from winkler.problems.normal.force_curve import NormalCurves
from winkler.problems.normal.onset.search import onset_in
from winkler.problems.normal.solve_contact import at_depth, at_force, flat_radius
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.problems.normal.yielding import YieldOnset, part_that_yields
from winkler.problems.plastic.dent import Dent
from winkler.problems.plastic.yielded_response import (
    GREATEST_POISSON,
    LEAST_POISSON,
    ball_onset,
    beyond_tables,
)
from winkler.problems.plastic.yielding_half import Parts, YieldingHalf, borne_together, divided
from winkler.values.checks.outline import refuse_unless_round
from winkler.values.errors import InvalidInput, OutsideValidity

POINTS_PER_EFOLD = 48
"""Points of the curve per factor e of the contact radius; the cubics between them give first guesses, and the work to
1e-7."""
START_SHARE = 1e-3
"""Part of the radius of the least load from which the work below a pointed tip is summed: before, it is a power."""
WIDENING, AT_ONCE = 1.5, 4
LAST_SHARE = 0.999
"""Part of the reach of a profile up to which the curve is followed: a ball is vertical there."""
LEAST_STIFFNESS = 50.0
"""Modulus over strength below which strains at yield are not small."""
NODES = 4
ENERGY_NODES = 24
ROUNDING_POWER, DEPTH_POWER = 1.5, 0.6
"""Power of the part of the recovery that is that of an even pressure with which an ellipse has got rounder, and power
of c by which its depth is less; fitted to finite elements of ellipses of b/a = 4.5 and 21."""
MOST_SLENDER = 100.0
"""Greatest ratio of the semi-axes of an ellipse; beyond, a residual depth could come out negative."""


class GreatestLoad(NamedTuple):
    """States of first loading.

    Parameters
    ----------
    radius, depth : ndarray, (n,)
        a and d [m].
    force : ndarray, (n,)
        F [N].
    recovery : ndarray, (n,)
        d_e [m], by which the bodies spring back; d while they are elastic.
    elastic_share : ndarray, (n,)
        theta [-].
    """

    radius: Array
    depth: Array
    force: Array
    recovery: Array
    elastic_share: Array

    def level(self, by_force: bool) -> Array:
        """Return the forces [N], or the depths [m]."""
        return self.force if by_force else self.depth


class FirstLoading(NamedTuple):
    """First loading of a bed.

    Parameters
    ----------
    bed : Foundation or EllipticFoundation
        Of a rising profile on half-spaces or layers, or of bodies of two curvatures on half-spaces.
    first, second : YieldingHalf
        The bodies, the first as its surface is; of layers nothing is followed beyond the onset.
    onset : float
        Contact radius where one of them begins to yield [m]; zero of a sharp tip, infinite if none does.
    where : str
        On layers where that is, the end of a sentence; empty on half-spaces, which are followed beyond it.
    """

    bed: UnderProfile
    first: YieldingHalf
    second: YieldingHalf
    onset: float
    where: str = ""

    def refuse_yielded_layers(self, owner: str) -> None:
        """Refuse what is beyond the onset of yield on layers.

        Raises
        ------
        OutsideValidity
        """
        if self.where:
            raise OutsideValidity(
                f"{owner}: the load leads beyond {self.at_onset(by_force=True):.6g} N, under which {self.where}. How "
                "deep layers are dented depends on strength, modulus and thickness of each of them, and no table "
                "holds it: stay below this load, up to which no dent is left, or give a HalfSpace."
            )

    def at_onset(self, *, by_force: bool) -> float:
        """Return force [N] or depth [m] where one of the bodies begins to yield."""
        if not 0.0 < self.onset < math.inf:
            return self.onset
        place = np.array([self.onset])
        depth = self.bed.gap(place)
        return float((self.bed.stiffness(place) * depth - self.bed.gap_load(place) if by_force else depth)[0])

    def edge(self, radius: Array) -> Array:
        """Return the height of the gap at the edge of contacts of radii `(n,)` [m], the mean around an ellipse."""
        bed = self.bed
        if not (isinstance(bed, EllipticFoundation) and isinstance(outline := bed.footprint, EllipticOutline)):
            return bed.profile.height(radius)
        (along, across), bodies = outline.semi_axes(radius), bed.bodies.together
        return np.asarray(
            0.25 * (along**2 / bodies.longitudinal_curvature_radius + across**2 / bodies.lateral_curvature_radius)
        )

    def exponent(self, radius: Array) -> Array:
        """Return d ln g / d ln a [-] at contact radii `(n,)` [m]."""
        return np.asarray(radius * self.bed.gap_slope(radius) / self.bed.gap(radius))

    def beyond_tables(self, radius: float) -> bool:
        """Whether the law of a body is continued beyond its finite elements at a contact radius [m]."""
        at = np.array([radius])
        strain, exponent, share = self._strain(at), self.exponent(at), self.parts(at).share
        return any(
            bool(beyond_tables(body.modulus * part * strain / body.strength / body.rise, body.poisson, exponent)[0])
            for body, part in ((self.first, share), (self.second, 1.0 - share))
            if math.isfinite(body.strength)
        )

    def _strain(self, radius: Array) -> Array:
        """Return P [-], the mean pressure of the elastic contact over its modulus."""
        bed = self.bed
        force = bed.stiffness(radius) * bed.gap(radius) - bed.gap_load(radius)
        return np.asarray(force / (bed.footprint.area(radius) * bed.medium.modulus))  # type: ignore[attr-defined]

    def _rounder(self, kept: Array) -> Array:
        """Return c [-], with the parts of the recovery that have the shape of an elastic contact; one of a disc."""
        bed = self.bed
        if not (isinstance(bed, EllipticFoundation) and isinstance(outline := bed.footprint, EllipticOutline)):
            return np.ones_like(kept)
        bodies = bed.bodies.together
        last = math.sqrt(bodies.lateral_curvature_radius / bodies.longitudinal_curvature_radius)
        part = np.clip(1.0 - kept, 0.0, 1.0) ** ROUNDING_POWER
        now = _area_of_stiffness(outline.slenderness ** (1.0 - part) * last**part)
        return np.sqrt(now / _area_of_stiffness(np.array(outline.slenderness)))

    def at(self, radius: Array, parts: Parts | None = None) -> GreatestLoad:
        """Return the states of first loading at contact radii `(n,)` [m], positive.

        Parameters
        ----------
        radius : ndarray, (n,)
        parts : Parts, optional
            `parts` at these radii, where they are known.
        """
        bed = self.bed
        gap = bed.gap(radius)
        stiffness = bed.stiffness(radius)
        elastic_force = stiffness * gap - bed.gap_load(radius)
        exponent = self.exponent(radius)
        strain = self._strain(radius)
        pressure, kept, answers = borne_together(
            self.first, self.second, self.parts(radius) if parts is None else parts, strain, exponent
        )
        taken = sum(part / (1.0 + answer.sinking) for part, answer in answers)
        force = bed.footprint.area(radius) * pressure
        # q(x) = E* d_e (theta (1 - g/g(a)) + (1 - theta) sqrt(1 - x^2/a^2)) has the integral F
        own, even = elastic_force / (stiffness * gap), 0.25 * np.pi
        fullness = kept * own + (1.0 - kept) * even
        if bed.footprint.unlike_disc:
            rounder = self._rounder(kept)
            fullness = np.maximum(fullness / rounder, own)
            kept, taken = (even - fullness) / (even - own), taken * rounder**-DEPTH_POWER
        return GreatestLoad(radius, gap * taken, force, force / (stiffness * fullness), kept)

    def parts(self, radius: Array, guess: Parts | None = None) -> Parts:
        """Return how the bodies divide the contact at contact radii `(n,)` [m].

        Parameters
        ----------
        radius : ndarray, (n,)
        guess : Parts, optional
            What is near by.

        Raises
        ------
        NotConverged
        """
        return divided(self.first, self.second, self._strain(radius), self.exponent(radius), guess)

    def at_level(self, level: Array, *, by_force: bool) -> tuple[GreatestLoad, Array]:
        """Return the states of first loading at forces [N] or depths [m] `(n,)`, and the work spent on each [J].

        Raises
        ------
        OutsideValidity
            If one is beyond the reach of the profile.
        """
        solve = at_force if by_force else at_depth
        yielding = level > 0.0
        if self.onset > 0.0:
            yielding &= level > self.at_onset(by_force=by_force)
        elastic = ~yielding
        depth, radius = solve(self.bed, np.where(elastic, level, 0.0))
        force = np.where(radius > 0.0, self.bed.stiffness(radius) * depth - self.bed.gap_load(radius), 0.0)
        if by_force:
            force = np.where(elastic, level, 0.0)
        if yielding.any():
            self.refuse_yielded_layers("PlasticIndentation")
        work = stored_energy(self.bed, depth, radius)
        state = GreatestLoad(radius, depth, force, depth.copy(), np.ones_like(depth))
        if not yielding.any():
            return state, work
        table = LoadingTable.of_levels(self, level[yielding], by_force)
        found = table.at(table.radii(level[yielding], by_force))
        found = found._replace(**{"force" if by_force else "depth": level[yielding]})
        for whole, part in zip((*state, work), (*found, table.work(found.radius)), strict=True):
            whole[yielding] = part
        return state, work

    @property
    def greatest_force(self) -> float:
        """Force [N] at the end of what is known of the profile; infinite if it has none."""
        last = LAST_SHARE * self.bed.reach
        return float(self.at(np.array([last])).force[0]) if last < math.inf else math.inf

    def wider(self, radius: float) -> Iterator[float]:
        """Yield this contact radius and wider ones, up to the end of what is known of the profile [m]."""
        end = max(radius, LAST_SHARE * self.bed.reach)
        while radius < end:
            yield radius
            radius *= WIDENING
        yield end

    def stored(self, state: GreatestLoad) -> Array:
        """Return the energies that unloading from states would give back [J]."""
        if self.where:
            return stored_energy(self.bed, state.depth, state.radius)
        touching = state.radius > 0.0
        radius, recovery, share = (part[touching] for part in (state.radius, state.recovery, state.elastic_share))
        whole = self.bed.gap(radius)

        def pressed(x: Array, index: Array) -> Array:
            even = np.sqrt(np.maximum(1.0 - (x / radius[index]) ** 2, 0.0))
            kept = share[index]
            return recovery[index] * (kept * (1.0 - self.bed.gap(x) / whole[index]) + (1.0 - kept) * even)

        energy = np.zeros(touching.shape)
        modulus = self.bed.medium.modulus  # type: ignore[attr-defined]
        energy[touching] = modulus * integral_of_square(pressed, self.bed, radius, radius)
        return energy

    def springs(self, owner: str, state: GreatestLoad, index: int) -> Foundation:
        """Return the bed on which the contact is elastic after one of the states; `owner` is who asks, for a message.

        Raises
        ------
        OutsideValidity
            If the contact is no disc.
        """
        refuse_unless_round(self.bed, owner, "the bed of a dent")
        assert isinstance(self.bed, Foundation)
        radius, recovery, share = (float(part[index]) for part in (state.radius, state.recovery, state.elastic_share))
        if radius <= self.onset:
            return self.bed
        return Foundation(Dent(self.bed.profile, radius, recovery, share), self.bed.medium)


def _area_of_stiffness(slenderness: Array) -> Array:
    """Return the areas of ellipses b/a [-] over those of the discs that are as stiff."""
    from scipy.special import elliprf

    ratio = np.minimum(slenderness, 1.0 / slenderness)
    return np.asarray(ratio * (2.0 / math.pi * elliprf(0.0, ratio**2, 1.0)) ** 2)


class LoadingTable:
    """The curve from one contact radius to another."""

    def __init__(self, curve: FirstLoading, first: float, last: float) -> None:
        from scipy.interpolate import CubicSpline

        self.curve = curve
        count = 2 + math.ceil(POINTS_PER_EFOLD * math.log(last / first))
        self.places = np.linspace(math.log(first), math.log(last), count)
        radii = np.exp(self.places)
        radii[0], radii[-1] = first, last
        parts = curve.parts(radii)
        self.states = state = curve.at(radii, parts)
        _refuse_turning(state.depth)
        self.log_force = CubicSpline(self.places, np.log(state.force))
        self.log_depth = CubicSpline(self.places, np.log(state.depth))
        self.parts = CubicSpline(self.places, np.stack(parts, axis=1))
        self.nodes, self.weights = gauss_legendre(NODES)
        if curve.onset > 0.0:
            start = float(stored_energy(curve.bed, state.depth[:1], state.radius[:1])[0])
        else:  # force and depth are powers of the radius
            power = float(self.log_force(self.places[0], 1) / self.log_depth(self.places[0], 1))
            start = float(state.force[0] * state.depth[0]) / (1.0 + power)
        steps = self._spent(self.places[:-1], self.places[1:])
        self.works = start + np.concatenate([[0.0], np.cumsum(steps)])

    @classmethod
    def of_levels(cls, curve: FirstLoading, level: Array, by_force: bool) -> LoadingTable:
        """Return the curve from where yielding begins to beyond the greatest of some loads."""
        solve = at_force if by_force else at_depth
        least, most = (float(solve(curve.bed, np.array([end]))[1][0]) for end in (np.min(level), np.max(level)))
        first, greatest = curve.onset or START_SHARE * least, float(np.max(level))
        wider = curve.wider(max(first, most))
        while radii := list(itertools.islice(wider, AT_ONCE)):
            beyond = curve.at(np.array(radii)).level(by_force) > greatest
            if beyond.any():
                return cls(curve, first, radii[int(np.argmax(beyond))])
        word, unit = ("force", "N") if by_force else ("depth", "m")
        end = curve.bed.reach
        raise OutsideValidity(
            f"The {word} of {greatest:.6g} {unit} leads beyond the reach of the profile ({end:.6g} m), where nothing "
            "is known of it; give a smaller one."
        )

    def at(self, radius: Array) -> GreatestLoad:
        """Return the states at radii, as `FirstLoading.at`, sooner."""
        return self.curve.at(radius, self.curve.parts(radius, Parts(*self.parts(np.log(radius)).T)))

    def radii(self, level: Array, by_force: bool) -> Array:
        """Return the radii at which the curve meets loads."""
        spline, levels = self.log_force if by_force else self.log_depth, self.states.level(by_force)
        _refuse_turning(levels)

        def with_slope(radius: Array) -> tuple[Array, Array]:
            value = self.at(radius).level(by_force)
            return value, value * spline(np.log(radius), 1) / radius

        guess = np.exp(np.interp(np.log(level), np.log(levels), self.places))
        first, last = math.exp(self.places[0]), math.exp(self.places[-1])
        guess = np.clip(guess, first * (1.0 + 1e-15), last * (1.0 - 1e-15))
        return invert(with_slope, level, lower=0.0, upper=last, guess=guess)

    def work(self, radius: Array) -> Array:
        """Return what was spent up to radii [J]."""
        place = np.clip(np.log(radius), self.places[0], self.places[-1])
        index = np.clip(np.searchsorted(self.places, place, side="right") - 1, 0, self.places.size - 2)
        return np.asarray(self.works[index] + self._spent(self.places[index], place))

    def _spent(self, low: Array, high: Array) -> Array:
        """Integrate the force over the depth between logarithms of radii."""
        place = low[:, None] + (high - low)[:, None] * self.nodes
        rate = np.exp(self.log_force(place) + self.log_depth(place)) * self.log_depth(place, 1)
        return np.asarray((rate @ self.weights) * (high - low))


def _refuse_turning(levels: Array) -> None:
    if np.any(np.diff(levels) <= 0.0):
        raise OutsideValidity(
            "Within this load the curve of first loading turns back, which the law for bodies of revolution that yield "
            "does not cover; give a smaller load or a smoother profile."
        )


def stored_energy(bed: UnderProfile, depth: Array, radius: Array) -> Array:
    """Return the elastic energy [J] of contacts on half-spaces or layers at depths [m] and radii [m] `(n,)`."""
    if not isinstance(bed.medium, HalfSpace):
        curves = _elastic_curves(bed)
        return np.array([curves.at(one)[2] if a > 0.0 else 0.0 for one, a in zip(depth, radius, strict=True)])
    wall = bed.reach if isinstance(bed.profile, Dent) else math.inf
    squares = integral_of_square(lambda x, _: bed.gap(x), bed, np.full(radius.shape, wall), radius)
    modulus = bed.medium.modulus
    return np.asarray(modulus * (depth * depth * radius + squares) - depth * bed.gap_load(radius))


@functools.lru_cache(maxsize=16)
def _elastic_curves(bed: UnderProfile) -> NormalCurves:
    """Return force and energy on layers up to the onset of yield."""
    return NormalCurves(bed, first_loading(bed).at_onset(by_force=False))


def integral_of_square(curve: Callable[[Array, Array], Array], bed: UnderProfile, wall: Array, radius: Array) -> Array:
    """Return the integrals of curve(x, index)^2 from 0 to radii; it may end like a root at the wall of that index."""
    nodes, weights = gauss_legendre(ENERGY_NODES)
    total, walled = np.zeros(radius.shape), np.isfinite(wall)[:, None]
    scale = np.where(np.isfinite(wall), wall, 1.0)
    index = np.broadcast_to(np.arange(radius.size)[:, None], (radius.size, nodes.size))
    for low, high in itertools.pairwise([0.0, *(b for b, _ in bed.kinks if b > 0.0), math.inf]):
        top = np.clip(radius, low, high)
        if not np.any(top > low):
            break
        # the root of a dent ends at its wall, that of a kink begins there: neither is left in these variables
        start, end = (np.where(walled[:, 0], np.arcsin(np.minimum(place / scale, 1.0)), place) for place in (low, top))
        width = (end - start)[:, None]
        place = start[:, None] + width * nodes**2
        step = 2.0 * width * nodes * np.where(walled, scale[:, None] * np.cos(place), 1.0)
        x = np.where(walled, np.minimum(scale[:, None] * np.sin(place), scale[:, None]), place)
        total += (curve(x.ravel(), index.ravel()).reshape(x.shape) ** 2 * step) @ weights
    return total


def refuse_unknown(owner: str, bed: Bed, *, layers: bool = False) -> None:
    """Refuse a bed of which it is not known how its bodies yield.

    Parameters
    ----------
    owner : str
        The problem, for messages.
    bed : Bed
    layers : bool
        Whether layers are taken, up to the onset of yield in one of them.

    Raises
    ------
    InvalidInput
        If no body has a strength, a strength is above a fiftieth of Young's modulus, the medium is no half-space, or
        the profile has a flat end, a rim or a valley.
    """
    if not isinstance(bed, Foundation | EllipticFoundation):
        raise InvalidInput(
            f"{owner}: the bed is a {type(bed).__name__}; how bodies yield is known by their shape: give a Foundation "
            "of a profile on a HalfSpace, or an EllipticFoundation; of lines LinePlasticIndentation knows it."
        )
    if isinstance(bed, Foundation):
        refuse_unless_round(bed, owner, "yielding, whose laws are those of bodies of revolution and of ellipses,")
    elif isinstance(outline := bed.footprint, EllipticOutline):
        ratio = max(outline.slenderness, 1.0 / outline.slenderness)
        if ratio > MOST_SLENDER:
            raise InvalidInput(
                f"{owner}: one semi-axis of the contact is {ratio:.4g} times the other one, nearly a line, and what "
                f"is known of ellipses ends at {MOST_SLENDER:g} times: give curvature radii that are less different, "
                "or press a cylinder with LinePlasticIndentation."
            )
    homogeneous, name = isinstance(bed.medium, HalfSpace), type(bed.medium).__name__
    if not (homogeneous or offers(bed.medium, LayerStack)):
        raise InvalidInput(
            f"{owner}: the medium is a {name}; a transversely isotropic body has no single strength, and the "
            "strength of a graded body varies with depth. Give a HalfSpace of isotropic bodies."
        )
    if not (homogeneous or layers):
        raise InvalidInput(
            f"{owner}: the medium is a {name}; a dent in layers depends on the strength, modulus and thickness of "
            "every layer. A single strength neither determines the dent nor follows from the dent. Give a HalfSpace. "
            "PlasticIndentation and YieldOnset compute the load up to which layers keep no dent."
        )
    refuse_strengths(owner, bed.medium, (LEAST_POISSON, GREATEST_POISSON) if homogeneous else (-1.0, 0.5))
    if not bed.profile.rising or bed.rim < np.inf or flat_radius(bed) > 0.0:
        raise InvalidInput(
            f"{owner}: the profile has a flat end, a rim or a valley, under which bodies yield in another way; "
            "give a profile that rises from its apex on, such as Sphere, Paraboloid or Cone."
        )


def refuse_strengths(owner: str, medium: object, poisson: tuple[float, float]) -> None:
    """Refuse bodies none of which has a strength, one that metals do not have, or Poisson's ratios outside of two."""
    parts = strong_parts(medium)
    if not parts:
        raise InvalidInput(f"{owner}: no body has a strength; give Elastic(young, poisson, strength=...).")
    for part in parts:
        solid = part.solid
        if solid.strength * LEAST_STIFFNESS > solid.young:
            raise InvalidInput(
                f"{owner}: the strength of the {part.name} is {solid.strength:.4g} Pa, more than a fiftieth of "
                f"Young's modulus, {solid.young:.4g} Pa; metals have less: check the units."
            )
        if not poisson[0] <= solid.poisson <= poisson[1]:
            raise InvalidInput(
                f"{owner}: Poisson's ratio of the {part.name} is {solid.poisson:g}; yielding of such a body is not "
                f"implemented: give one from {poisson[0]:g} to {poisson[1]:g}."
            )


@functools.lru_cache(maxsize=64)
def first_loading(bed: UnderProfile) -> FirstLoading:
    """Return the loading curve of a bed on half-spaces, or on layers up to the onset of yield in one of them.

    Raises
    ------
    OutsideValidity, NotConverged
        If the onset of yield of a body is not found.
    """
    medium = bed.medium
    if not isinstance(medium, HalfSpace):
        found = YieldOnset(bed).solve()
        part = part_that_yields(found)
        where = f"yielding begins ({part.name}, {abs(found.z):.4g} m deep, {found.r:.4g} m from the axis)"
        rigid = _body(bed, RIGID, math.inf)
        return FirstLoading(bed, rigid, rigid, found.radius, where)
    assert isinstance(medium, HalfSpace)
    onsets = {part.first: _onset(bed, part) for part in strong_parts(medium)}
    first = _body(bed, medium.first, onsets.get(True, math.inf))
    second = _body(bed, medium.second, onsets.get(False, math.inf))
    return FirstLoading(bed, first, second, min(onsets.values(), default=math.inf))


def _onset(bed: UnderProfile, part: StrongPart) -> float:
    """Return the contact radius at which a part begins to yield [m]; zero of a sharp tip, infinite if it never does."""
    try:
        found = onset_in(bed, part, 0.0)
    except OutsideValidity:  # of a body without a flat end and on half-spaces: its apex is pointed
        return 0.0
    return math.inf if isinstance(found, str) else found[0]


def _body(bed: UnderProfile, solid: Solid, onset: float) -> YieldingHalf:
    if not isinstance(solid, Elastic):
        return YieldingHalf(math.inf, 0.0, math.inf, math.inf, solid)
    modulus = solid.young / (1.0 - solid.poisson**2)
    start, rise = math.inf, 1.0
    if onset == 0.0:
        start = 0.0
    elif math.isfinite(onset):
        at = np.array([onset])
        pressure = (bed.stiffness(at) * bed.gap(at) - bed.gap_load(at)) / bed.footprint.area(at)
        start = float(pressure[0]) / solid.strength
        if bed.footprint.unlike_disc:
            rise = start / ball_onset(solid.poisson)
    return YieldingHalf(modulus, solid.poisson, solid.strength, start, solid, rise)
