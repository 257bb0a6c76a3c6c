"""A half-space that may yield, and how two of them divide a contact between them."""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

import numpy as np

from winkler.materials.elastic import Solid
from winkler.materials.hardening import Hardening
from winkler.numerics.types import Array
from winkler.problems.plastic.yielded_response import (
    Yielded,
    round_part,
    strain_of_pressure,
    strain_of_shape,
    yielded,
)
from winkler.values.errors import NotConverged

SHARE_POWER = 1.5
"""Power of its share of the gap with which a body counts for the shape of the pressure, from finite elements of two
bodies: the one that yields more decides."""
NEAR, LAST_STEP, MOST_STEPS = 1e-7, 3e-8, 60
"""Difference over which slopes are taken, the last step of Newton's method, which leaves its square, and how many."""
WIDEST_STEP = 0.8
"""Part of the way to none of the gap, or to all of it, that one step may go."""
GREATEST_SINKING = 0.872
"""Gamma - 1 at the end of the tables of a ball, where the pressure of an ellipse is that of a ball."""
LEAST_LOAD = 1e-12
"""A load over the strength of which no table knows anything: the bodies are elastic."""


class Tangent(NamedTuple):
    """The pressure of a body near an elastic one, all by logarithms and `(n,)`, while the flow stress follows.

    Parameters
    ----------
    value, rise : ndarray, (n,)
        The pressure once the stress has made its step, and its slope.
    step, follow : ndarray, (n,)
        How the flow stress moves at once, and with the elastic pressure.
    """

    value: Array
    rise: Array
    step: Array
    follow: Array


class YieldingHalf(NamedTuple):
    """A half-space that may yield.

    Parameters
    ----------
    modulus : float
        E / (1 - nu^2) [Pa], infinite of a rigid one.
    poisson, strength : float
        nu, and Y [Pa], infinite of one that does not yield.
    start : float
        p_el / Y [-] where it begins to yield.
    solid : Elastic or Rigid
        What it is made of.
    rise : float
        `start` below an ellipse over that below a ball [-].
    """

    modulus: float
    poisson: float
    strength: float
    start: float
    solid: Solid
    rise: float = 1.0

    def answer(self, elastic: Array, exponent: Array, stress: Array) -> Yielded:
        """Return the departure from an elastic body that would bear a pressure [Pa]; `stress` is near the flow's."""
        if math.isinf(self.strength):
            return Yielded(*(np.zeros(elastic.shape),) * 3)
        load = np.maximum(elastic / self.strength, LEAST_LOAD)
        past = load > self.start
        if isinstance(self.solid, Hardening):
            departure = self._hardened(elastic, exponent, stress, past)
        else:
            departure = self.beyond_start(load, exponent)
        return Yielded(*(np.where(past, part, 0.0) for part in departure))

    def beyond_start(self, load: Array, exponent: Array) -> Yielded:
        """Return the departure under loads p_el over the flow stress [-] beyond the onset."""
        start, part, load = max(self.start / self.rise, LEAST_LOAD), round_part(exponent), load / self.rise
        alike = part.size and bool(np.all(part == part[0]))
        begun = (
            _begun(start, self.poisson, float(part[0]))
            if alike
            else yielded(np.full(exponent.shape, start), self.poisson, exponent)
        )
        departure = yielded(load, self.poisson, exponent).less(begun)
        if self.rise == 1.0:
            return departure
        fuller = math.log(self.rise) * np.minimum(departure.sinking / GREATEST_SINKING, 1.0)
        return departure._replace(fall=departure.fall + fuller)

    def _hardened(self, elastic: Array, exponent: Array, stress: Array, past: Array) -> Yielded:
        """Return the departure with the flow stress in place of the strength; zeros where it has not yielded.

        The pressure has that at one strain, the shape that at another one (`strain_of_pressure`, `strain_of_shape`).
        """
        answer = np.zeros((3, elastic.size))
        elastic, exponent, stress = elastic[past], exponent[past], stress[past]
        place = np.log(elastic)
        for _ in range(MOST_STEPS):
            _, _, step, _ = self.tangent(place, stress, exponent)
            stress = self.within(stress + step, elastic)
            if np.all(np.abs(step) <= LAST_STEP):
                break
        else:
            raise NotConverged(f"The flow stress of a body was not found in {MOST_STEPS} steps.")
        load = np.maximum(np.exp(place - stress), LEAST_LOAD)
        fall = self.beyond_start(load, exponent).fall
        missing = -elastic * np.expm1(-fall) / self.modulus
        shaped = self.shaped(elastic, load, missing, exponent)
        answer[:, past] = fall, shaped.sinking, shaped.evening
        return Yielded(*answer)

    def shaped(self, elastic: Array, load: Array, missing: Array, exponent: Array) -> Yielded:
        """Return the departure whose shape is that of a metal that hardens.

        Parameters
        ----------
        elastic, load, missing, exponent : ndarray, (n,)
            The elastic pressure [Pa], that over the flow stress [-], (p_el - p) / E* [-], and the local exponent [-].
        """
        flow = self.solid.flow_stress  # type: ignore[union-attr]
        return self.beyond_start(elastic / flow(strain_of_shape(load, missing)), exponent)

    def least_stress(self) -> float:
        """Logarithm of the strength [Pa]; zero of one that does not yield."""
        return math.log(self.strength) if math.isfinite(self.strength) else 0.0

    def part_against(self, other: YieldingHalf) -> float:
        """Return the part of a gap that stands against this body while both are elastic."""
        if math.isinf(self.modulus) or math.isinf(other.modulus):
            return 0.0 if math.isinf(self.modulus) else 1.0
        return other.modulus / (self.modulus + other.modulus)

    def within(self, stress: Array, elastic: Array) -> Array:
        """Return logarithms of flow stresses, not below the strength nor above what all of the strain would give."""
        if not isinstance(self.solid, Hardening):
            return stress
        return np.clip(stress, math.log(self.strength), np.log(self.solid.flow_stress(elastic / self.modulus)))

    def _borne(self, place: Array, stress: Array, exponent: Array) -> tuple[Array, Array]:
        """Return logarithms of the pressure, and of the flow stress over the one that its own strain gives."""
        if math.isinf(self.strength):
            return place, np.zeros_like(place)
        load = np.maximum(np.exp(place - stress), LEAST_LOAD)
        past = place > self.least_stress() + math.log(max(self.start, LEAST_LOAD))
        fall = np.where(past, self.beyond_start(load, exponent).fall, 0.0)
        if not isinstance(self.solid, Hardening):
            return place - fall, np.zeros_like(place)
        strain = strain_of_pressure(load, -np.exp(place) * np.expm1(-fall) / self.modulus)
        return place - fall, stress - np.log(self.solid.flow_stress(strain))

    def tangent(self, place: Array, stress: Array, exponent: Array) -> Tangent:
        """Return the pressure near logarithms of the elastic pressure and of flow stresses near by, each `(n,)`."""
        hardens = isinstance(self.solid, Hardening)
        rows = 3 if hardens else 2
        places, stresses = np.tile(place, (rows, 1)), np.tile(stress, (rows, 1))
        places[1] += NEAR
        stresses[2:] += NEAR
        found = self._borne(places.ravel(), stresses.ravel(), np.tile(exponent, rows))
        pressure, missed = (part.reshape(rows, -1) for part in found)
        slopes = (pressure[1:] - pressure[0]) / NEAR
        if not hardens:
            still = np.zeros_like(place)
            return Tangent(pressure[0], slopes[0], still, still)
        by_place, by_stress = slopes
        moved, met = (missed[1:] - missed[0]) / NEAR
        step, follow = -missed[0] / met, -moved / met
        return Tangent(pressure[0] + by_stress * step, by_place + by_stress * follow, step, follow)


@functools.lru_cache(maxsize=64)
def _begun(start: float, poisson: float, part: float) -> Yielded:
    """Return the departure where yielding begins, of profiles all alike."""
    return yielded(np.array([start]), poisson, np.array([1.0 + part]))


class Parts(NamedTuple):
    """How the bodies divide a contact.

    Parameters
    ----------
    share : ndarray, (n,)
        Part of the gap that stands against the first body [-].
    first, second : ndarray, (n,)
        Logarithms of their flow stresses [Pa]; of bodies that are alike near them.
    """

    share: Array
    first: Array
    second: Array


def divided(
    first: YieldingHalf, second: YieldingHalf, strain: Array, exponent: Array, guess: Parts | None = None
) -> Parts:
    """Return how two bodies divide contacts.

    Parameters
    ----------
    first, second : YieldingHalf
    strain : ndarray, (n,)
        P [-], the mean pressure of the elastic contact over its modulus.
    exponent : ndarray, (n,)
        d ln g / d ln a [-].
    guess : Parts, optional
        What is near by.

    Raises
    ------
    NotConverged
    """
    if guess is None:
        alone = first.part_against(second), first.least_stress(), second.least_stress()
        guess = Parts(*(np.full_like(strain, one) for one in alone))
    if first == second or math.isinf(first.modulus) or math.isinf(second.modulus):
        return guess
    share, *stress = guess
    for _ in range(MOST_STEPS):
        elastic = first.modulus * share * strain, second.modulus * (1.0 - share) * strain
        stress = [body.within(*of) for body, *of in zip((first, second), stress, elastic, strict=True)]
        one, two = (
            body.tangent(np.log(pressed), flow, exponent)
            for body, pressed, flow in zip((first, second), elastic, stress, strict=True)
        )
        step = (two.value - one.value) / (one.rise / share + two.rise / (1.0 - share))
        step = np.clip(step, -WIDEST_STEP * share, WIDEST_STEP * (1.0 - share))
        grown = step / share, -step / (1.0 - share)
        moves = [body.step + body.follow * part for body, part in zip((one, two), grown, strict=True)]
        share, stress = share + step, [flow + move for flow, move in zip(stress, moves, strict=True)]
        if all(np.all(np.abs(part) <= LAST_STEP) for part in (*grown, *moves)):
            return Parts(share, *stress)
    raise NotConverged(f"How two bodies that yield share a contact was not found in {MOST_STEPS} steps.")


def borne_together(
    first: YieldingHalf, second: YieldingHalf, parts: Parts, strain: Array, exponent: Array
) -> tuple[Array, Array, list[tuple[Array, Yielded]]]:
    """Return the mean pressures [Pa], the elastic shares of the recovery, and of each body its part and departure."""
    pressure, kept, weights = (np.zeros_like(strain) for _ in range(3))
    answers: list[tuple[Array, Yielded]] = []
    for body, part, stress in ((first, parts.share, parts.first), (second, 1.0 - parts.share, parts.second)):
        if math.isinf(body.modulus):
            continue
        elastic = body.modulus * part * strain
        answer = body.answer(elastic, exponent, stress)
        pressure = elastic * np.exp(-answer.fall)
        weight = part**SHARE_POWER
        kept += weight * (1.0 - answer.evening)
        weights += weight
        answers.append((part, answer))
    return pressure, kept / weights, answers
