"""Stresses below cylinders that roll, from a strip of elements, and what is stated: elements, coupling, yield."""

from __future__ import annotations

import numpy as np

from winkler.numerics.equations.highest import highest
from winkler.numerics.surfaces.strip_elements import linear_potential
from winkler.numerics.types import Array
from winkler.problems.line.greatest_stress import Placed
from winkler.problems.line.indentation import LineSolution
from winkler.problems.line.stress import LineFields, fields_of
from winkler.problems.line.yield_statement import nearest_to_strength
from winkler.problems.line_rolling.rolled_strip import RolledStrip, creepage_error, loss_error
from winkler.problems.normal.strong_parts import strong_parts
from winkler.problems.normal.yield_statement import elastic_note
from winkler.values.validity import Assumption, Note, Standing

BENTALL = "R. H. Bentall, K. L. Johnson, Int. J. Mech. Sci. 9 (1967) 389-404, doi:10.1016/0020-7403(67)90043-4"
FULL_COUPLING = Note(
    Assumption.UNCOUPLED,
    Standing.EXACT,
    "Pressure and traction are coupled in both directions.",
    BENTALL,
)
ACROSS, DOWN = 61, 31
"""Places at which von Mises' stress is compared with the strength."""


def strip_stresses(
    strip: RolledStrip, half_width: float, modulus: float, poisson: float, below: bool, x: Array, z: Array
) -> LineFields:
    """Return the stresses below a strip, in the first body (`below`) or the second.

    Parameters
    ----------
    strip : RolledStrip
    half_width, modulus : float
        Of similar bodies [m]; E* [Pa].
    poisson : float
        Of the body.
    below : bool
    x, z : ndarray
        Places in the axes of the body [m], of one shape, z not negative.
    """
    side = 1.0 if below else -1.0
    rows = (modulus * strip.pressure, side * modulus * strip.traction)
    found = [np.array(linear_potential(strip.x * half_width, row, x.ravel(), z.ravel())) for row in rows]
    pressed, dragged = (each.reshape(2, *x.shape) for each in found)
    return fields_of(x, z, pressed, poisson, dragged)


def strip_note(strip: RolledStrip, slope: float) -> Note:
    """Return how far creepage, force and loss of a strip are off, under a slope a/R [-]."""
    part, lost = 100.0 * creepage_error(strip), "The dissipated energy is too small to be resolved by these elements."
    error = loss_error(strip, slope)
    if error < strip.loss:
        lost = f"The error of the dissipated energy is at most {100.0 * error / strip.loss:.2g} % of this energy."
    return Note(
        Assumption.SLIP,
        Standing.APPROXIMATE,
        f"Steady rolling with Coulomb friction in plane strain is solved on {strip.slip.size} elements. The error of "
        f"the creepage is at most {part:.2g} % of the creepage or of the full-stick creepage at zero shear force, "
        f"whichever is greater. If the creepage is prescribed, the error of the shear force is at most {part:.2g} "
        f"% of the friction limit. {lost}",
        "closed form where all sticks; random strips compared with finer elements",
    )


def rolled_yield_notes(contact: LineSolution, strip: RolledStrip) -> tuple[Note, ...]:
    """Return whether the body that comes nearest to its strength stays elastic, from stresses on a grid of places."""
    medium, a = contact.problem.bed.medium, float(contact.half_width)
    grid, found = [a * np.linspace(-1.2, 1.2, ACROSS), a * np.linspace(0.0, 1.5, DOWN)], []
    for part in strong_parts(medium):
        own = medium.modulus, part.solid.poisson, part.first
        top = highest(lambda *at, own=own: strip_stresses(strip, a, *own, *at).von_mises, grid, rounds=0)
        along, deep = top.place
        found.append((Placed(top.value, along, deep if part.first else -deep), part))
    return (elastic_note(*nearest_to_strength(found), Standing.APPROXIMATE),) if found else ()
