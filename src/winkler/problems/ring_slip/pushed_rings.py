"""Rings of a layered or graded body that is pushed to and fro under a steady depth: their force, loss and reach."""

from __future__ import annotations

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.torsion_bound import PressedState
from winkler.numerics.types import Array
from winkler.problems.ring_slip.push_bound import layers_of_rings, push_bound
from winkler.problems.ring_slip.steady_path import FreshSprings, falls


class PushedRings:
    """The rings of one pressed contact; `winkler.problems.friction.damping_springs.SlippingSprings` in springs.

    Parameters
    ----------
    springs : FreshSprings
    modulus : float
        G* [Pa].
    """

    def __init__(self, springs: FreshSprings, modulus: float) -> None:
        self._springs, self._modulus = springs, modulus

    @property
    def stiffness(self) -> float:
        """Stiffness without slip [N/m]."""
        return self._modulus * self._springs.inertia

    def stick_radius(self, moved: float) -> float:
        """Return the radius of the part that sticks [m] at an amplitude of the shift [m]; zero if all slides."""
        return float(self._springs.curve(np.array([self._modulus * moved])).front[0])

    def loss(self, moved: Array) -> Array:
        """Return the loss per cycle [J] at amplitudes of the shift [m], both ``(m,)``."""
        return np.asarray(8.0 / self._modulus * self._springs.curve(self._modulus * moved).lost)

    def force(self, moved: Array) -> Array:
        """Return the amplitude of the shear force [N] at amplitudes of the shift [m], both ``(m,)``."""
        return np.asarray(self._springs.curve(self._modulus * moved).load)

    def shift(self, targets: Array) -> Array:
        """Return the least amplitudes of the shift [m] at amplitudes of the shear force [N], both ``(m,)``."""
        return np.asarray(self._springs.amplitude(targets) / self._modulus)


def pushed_rings(bed: Bed, coefficient: float, depth: float, radius: float) -> PushedRings | None:
    """Return the rings of a contact; None where the medium is not layered, the contact no disc or no outer ring slides.

    Parameters
    ----------
    bed : Bed
    coefficient : float
        mu [-].
    depth, radius : float
        d [m] and a [m], positive.
    """
    medium = layers_of_rings(bed)
    if medium is None:
        return None
    bound = push_bound(bed, coefficient, radius, False)
    excess = depth - float(bed.gap(np.array([radius]))[0]) if radius >= bed.rim else 0.0
    press = PressedState(depth, radius, max(excess, 0.0))
    return PushedRings(FreshSprings(bound, press), medium.shear_modulus) if falls(bound, press) else None
