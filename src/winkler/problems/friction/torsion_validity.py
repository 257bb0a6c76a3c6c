"""The validity notes of torsion: how exact the springs are, and whether the contact stays elastic.

The twist adds shear stresses of its own to those of the pressure, so that the squares of both von Mises stresses add.
"""

from __future__ import annotations

import functools
from collections.abc import Iterator, Sequence

import numpy as np

from winkler.foundation.bed import Bed
from winkler.laws.friction import Coulomb
from winkler.media.halfspace import HalfSpace
from winkler.media.interior.peak import greatest
from winkler.numerics.types import Array
from winkler.problems.friction.torsion_fields import body_of_twisted
from winkler.problems.friction.torsion_states import TorsionState
from winkler.problems.normal.greatest_stress import sharp_places
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.problems.normal.unknown_yield import MISES, unknown_yield
from winkler.problems.normal.yield_statement import SurfaceFriction, yield_notes_of_bed
from winkler.problems.ring_slip.ring_notes import ring_notes
from winkler.problems.ring_slip.twisted_layers import twisted_layer_notes
from winkler.values.validity import Assumption, Note, Standing

LEAST_DEPTH = 1e-3
"""Stresses of a twist are sought below this depth, in contact radii."""
ROUNDS = 4
"""Rounds of the search: the value is good to about a per mille."""
PATH_SAMPLES, RADIUS_SAMPLES = 24, 193
"""At so many points of a path where the load falls the traction is examined, at so many radii."""


def torsion_notes(bed: Bed, law: Coulomb, states: Sequence[TorsionState], by_torque: bool) -> Iterator[Note]:
    """Yield how exact torsion with friction is along a path.

    Parameters
    ----------
    bed : Bed
    law : Coulomb
    states : sequence of TorsionState
        Those of the path.
    by_torque : bool
        Whether the torque is prescribed and the angle computed.
    """
    yield Note(
        Assumption.SLIP,
        Standing.EXACT,
        "Torsion of a round contact and its normal load are uncoupled for all Poisson's ratios, even for "
        "elastically dissimilar bodies. For small rotations the springs are equal to the three-dimensional "
        "solution, as long as the slip zone is an outer annulus.",
        "J. Jaeger, Arch. Appl. Mech. 65 (1995) 478-487, doi:10.1007/BF00835661",
    )
    widest = max(states, key=lambda state: state.radius)
    yield from twisted_layer_notes(bed, widest.radius, widest.springs.bound)
    depth, radius = (np.array([getattr(state, word) for state in states]) for word in ("depth", "radius"))
    falling = np.flatnonzero((np.diff(depth) < 0.0) & (radius[1:] > 0.0)) + 1
    examined = falling[:: max(1, falling.size // PATH_SAMPLES)].tolist()
    words = ("angle", "torque")
    yield from ring_notes(
        bed, law.coefficient, states, examined, RADIUS_SAMPLES, words, by_torque, states[0].springs.bound.logarithmic
    )


def torsion_yield_notes(bed: Bed, states: Sequence[TorsionState]) -> tuple[Note, ...]:
    """Return whether a twisted contact stays elastic; nothing where no body has a strength.

    Parameters
    ----------
    bed : Bed
    states : sequence of TorsionState
        Those of a path; examined are that of the greatest torque and that of the greatest depth.
    """
    depth, radius, torque = (
        np.array([abs(getattr(state, word)) for state in states]) for word in ("depth", "radius", "torque")
    )
    if not np.any(torque > 0.0):
        return yield_notes_of_bed(bed, depth, radius)
    plain = yield_notes_of_bed(bed, depth, radius)
    if not plain or any(note.standing is Standing.OUTSIDE for note in plain):
        return plain
    if not isinstance(bed.medium, HalfSpace):
        return yield_notes_of_bed(bed, depth, radius, SurfaceFriction(np.inf))
    examined = [states[index] for index in sorted({int(np.argmax(torque)), int(np.argmax(depth))})]
    if any(_sharp(state, part) for state in examined for part in strong_parts(bed.medium)):
        why = "the stresses of a twist near a sharp place, or without slip, are not resolved"
        return unknown_yield(bed.medium, why, plain[0].statement)
    weakest: dict[float, StrongPart] = {}  # bodies of one Poisson's ratio have the same stresses
    for part in sorted(strong_parts(bed.medium), key=lambda part: -part.solid.strength):
        weakest[part.solid.poisson] = part
    share, part = max(
        ((_greatest(state, part.first) / part.solid.strength, part) for state in examined for part in weakest.values()),
        key=lambda pair: pair[0],
    )
    stays = "the contact stays elastic" if share < 1.0 else "yielding has begun, and the result is not elastic"
    statement = (
        f"By von Mises' criterion {stays}: at the greatest torque and the greatest load of the path the greatest "
        f"stress is {share:.3g} {'times' if share >= 1.0 else 'of'} the strength of the {part.name}."
    )
    return (Note(Assumption.ELASTIC, Standing.EXACT if share < 1.0 else Standing.OUTSIDE, statement, MISES),)


def _sharp(state: TorsionState, part: StrongPart) -> bool:
    if state.radius == 0.0:
        return False
    return state.springs.edge != 0.0 or any(sharp_places(state._pressed, part.solid.poisson, 1.0))


@functools.lru_cache(maxsize=64)
def _greatest(state: TorsionState, first: bool) -> float:
    """Return the greatest von Mises stress in one of the bodies [Pa]."""
    if state.radius == 0.0:
        return 0.0
    sign = 1.0 if first else -1.0

    def field(r: Array, z: Array) -> Array:
        return body_of_twisted(state, r, np.zeros(r.shape), sign * np.maximum(z, LEAST_DEPTH * state.radius)).von_mises

    return greatest(field, state.radius, rounds=ROUNDS).value
