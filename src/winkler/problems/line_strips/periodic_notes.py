"""The load that closes periodic strips, their greatest pressure, and what is stated about them."""

from __future__ import annotations

import functools
from typing import cast

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.foundation.periodic import PeriodicBed, in_closed_form
from winkler.numerics.equations.highest import highest
from winkler.problems.line.greatest_stress import Placed, greatest, von_mises
from winkler.problems.line.peak_pressure import is_sharp
from winkler.problems.line.stress import LineContact, Strip, stresses
from winkler.problems.line.validity import HALF_PLANES, WAVES
from winkler.problems.line.yield_statement import line_yield_notes, nearest_to_strength
from winkler.problems.normal.strong_parts import strong_parts
from winkler.problems.normal.unknown_yield import MISES
from winkler.problems.normal.validity import steepness_note
from winkler.problems.normal.yield_statement import elastic_note
from winkler.values.validity import Assumption, Note, Standing

WESTERGAARD = "H. M. Westergaard, J. Appl. Mech. 6 (1939) A49-A53"
PRESSURE_SAMPLES, REFINEMENTS = 65, 9
ROUNDING = 1e-9
"""Tension over the greatest pressure that counts as none."""
WIDEST, SHALLOWEST, DEEPEST, PLACES = 1.5, 0.02, 2.5, 24
"""Grid of stresses below profiles that have no closed form, in half-widths."""


@functools.lru_cache(maxsize=16)
def closing_load(bed: PeriodicBed) -> float:
    """Return the load per strip over E* [m] from which on all is in contact, without tension; infinite if never."""
    line = bed.line
    if not np.isfinite(line.rim):
        return np.inf
    low, high, tension = 0.0, 0.5 * bed.pitch, 0.0
    for _ in range(REFINEMENTS):
        places = np.linspace(low, high, PRESSURE_SAMPLES)[:-1]
        levels = bed.pressure(places, 0.5 * bed.pitch, 0.0)
        best = int(np.argmin(levels))
        if levels[best] >= -ROUNDING * float(np.max(np.abs(levels))):
            break
        tension = -float(levels[best])
        low, high = places[max(best - 1, 0)], places[min(best + 1, places.size - 1)]
    return float(line.load_profile(np.array([line.rim]))[0] + bed.pitch * tension / bed.medium.modulus)


def periodic_notes(bed: PeriodicBed, one: LineFoundation | LayeredLineFoundation, strip: Strip) -> tuple[Note, ...]:
    """Return the notes of the widest of several contacts.

    Parameters
    ----------
    bed : PeriodicBed
    one : LineFoundation or LayeredLineFoundation
        The bed of one crest, as it was given.
    strip : Strip
        The widest contact.
    """
    a, extra = strip
    layered = isinstance(one, LayeredLineFoundation)
    exact = Standing.EXACT, HALF_PLANES
    standing, bodies = one.layered_body.in_plane if isinstance(one, LayeredLineFoundation) else exact
    repeated = "Equal strips repeat at the pitch without end. Far below the surface they act like a uniform pressure."
    response = Note(Assumption.RESPONSE, standing, f"{bodies}. {repeated}", WAVES if layered else WESTERGAARD)
    if a == 0.0:
        apart = "The bodies do not touch under this load."
        return (*one.notes, response, Note(Assumption.EQUILIBRIUM, Standing.EXACT, apart, "the load is zero"))
    inside = np.linspace(0.0, a, 66)[1:-1]
    notes = [*one.notes, response, steepness_note(float(np.max(np.abs(one.slope(inside)))))]
    if extra > 0.0:
        text = "The surfaces are in full contact; additional load adds a uniform pressure."
        notes.append(Note(Assumption.EQUILIBRIUM, Standing.EXACT, text, WESTERGAARD))
    if not bed.line.single:
        text = "It was checked that each crest has one strip: no tension inside, no overlap outside."
        source = "a-posteriori check of pressure and separation, at sampled places"
        notes.append(Note(Assumption.SINGLE_CONTACT, Standing.EXACT, text, source))
    return (*notes, *(line_yield_notes(bed, strip) if layered else _yield_notes(bed, strip)))


def _yield_notes(bed: PeriodicBed, strip: Strip) -> tuple[Note, ...]:
    parts = strong_parts(bed.medium)
    if not parts:
        return ()
    if is_sharp(bed.line, bed.line.rim, 0.0):
        text = "The elastic stress is infinite at a sharp crest or kink, which yields under any load."
        return (Note(Assumption.ELASTIC, Standing.APPROXIMATE, text, MISES),)
    closed, found = in_closed_form(bed.profile), []
    for part in parts:
        contact = LineContact(cast(LineFoundation, bed), *strip, part.solid.poisson, 0.0)
        place = greatest(contact, von_mises) if closed else _on_grid(contact)
        found.append((place if part.first else place._replace(z=-place.z), part))
    share, where = nearest_to_strength(found)
    return (elastic_note(share, where, Standing.EXACT if closed else Standing.APPROXIMATE),)


def _on_grid(contact: LineContact) -> Placed:
    """Return the greatest von Mises stress on a grid below the strip, where a finer search would take too long."""
    a = contact.half_width
    x, z = a * np.linspace(0.0, WIDEST, PLACES), a * np.geomspace(SHALLOWEST, DEEPEST, PLACES)
    top = highest(lambda across, down: von_mises(stresses(contact, across, down)), [x, z], rounds=0)
    return Placed(top.value, *top.place)
