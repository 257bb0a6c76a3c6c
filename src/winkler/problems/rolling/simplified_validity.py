"""The validity notes of the simplified theory of rolling."""

from __future__ import annotations

import math

import numpy as np

from winkler.problems.rolling.creepage import Creepage
from winkler.problems.rolling.distances import MEASURED_BY, ellipse_distances
from winkler.problems.rolling.kalker import CreepCoefficients
from winkler.profiles.curved_pair import CurvedPair
from winkler.profiles.ellipse import ContactEllipse, CurvedBodies
from winkler.values.validity import Assumption, Note, Standing

__all__ = ["distance_notes", "falling_note", "moment_note", "size_note"]

JOHNSON = "K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 4.2, doi:10.1017/CBO9781139171731"
PRESCRIBED_ELLIPSE = Note(
    Assumption.SHAPE,
    Standing.ASYMPTOTIC,
    "The ellipse was given: that these bodies touch on it under this load, and are large beside it, is not checked.",
    JOHNSON,
)
LARGEST_CHANGE = 1.0
"""Of friction by the unloading of the springs; beyond it friction falls faster than they unload, and they jump."""
POLACH = "O. Polach, Wear 258 (2005) 992-1000, doi:10.1016/j.wear.2004.03.046"
FIRST_DIGITS = Note(
    Assumption.CALIBRATION,
    Standing.APPROXIMATE,
    "The springs have no separate coefficient for the moment under spin. Its initial slope is up to 27 per cent too "
    "low on ellipses of 1 : 5 to 2 : 1.",
    "compared with CONTACT's coefficients of ellipses",
)
THEORY = (
    "Simplified theory: one spring for every point, its flexibility chosen by Kalker's coefficients, under a "
    "parabolic bound. "
)


def distance_notes(creepage: Creepage, ratio: float, poisson: float) -> tuple[Note, ...]:
    """Return how far forces and moments are from the exact theory on an ellipse of a ratio a/b.

    Parameters
    ----------
    creepage : Creepage
    ratio : float
        a/b [-].
    poisson : float
        Of the pair of bodies [-].
    """
    known = ellipse_distances(ratio, poisson)
    spun = bool(np.any(np.asarray(creepage.spin) != 0.0))
    both = bool(np.any(np.multiply(creepage.longitudinal, creepage.lateral) != 0.0))
    if known is None:
        statement = f"{THEORY}On an ellipse of a/b = {ratio:.3g} creep forces were not compared with the exact theory."
        return (Note(Assumption.CALIBRATION, Standing.APPROXIMATE, statement, MEASURED_BY),)
    under = "With spin" if spun else "Under both creepages" if both else "Under longitudinal or lateral creepage alone"
    distance = known.spun if spun else known.both if both else known.one
    turned = known.spun_moment if spun else known.moment
    statement = (
        f"{THEORY}{under} the force stays within {distance:.2g} of mu F_N of the exact theory. The moment stays "
        f"within {turned:.2g} of mu F_N sqrt(a b). These are the greatest distances near this ellipse and this "
        "Poisson's ratio."
    )
    first = Note(Assumption.CALIBRATION, Standing.APPROXIMATE, statement, MEASURED_BY)
    return (first, FIRST_DIGITS) if spun else (first,)


def moment_note(coefficients: CreepCoefficients, longitudinal: float, lateral: float) -> Note:
    """Return how much of the moment under lateral creepage the springs bear, on an ellipse of these semi-axes [m].

    Of the exact theory it begins as -G (ab)^1.5 c23 eta; of springs, whose p_y = (l - x) eta / L_2 grows from the
    leading edge l on, as -eta / L_2 times the integral of x^2 over the ellipse.
    """
    slender = math.sqrt(longitudinal / lateral)
    part = 3.0 * math.pi / 32.0 * coefficients.lateral / coefficients.spin * slender
    return Note(
        Assumption.CALIBRATION,
        Standing.APPROXIMATE,
        f"The moment under lateral creepage begins at {100.0 * part:.2g} per cent of that of the exact theory on "
        "this ellipse.",
        "Kalker's coefficient c23, by reciprocity",
    )


def falling_note(change: float) -> Note:
    """Return what friction that falls with the velocity of slip leaves out.

    Parameters
    ----------
    change : float
        Greatest change of friction by the velocity at which springs that slide unload, over friction [-].
    """
    return Note(
        Assumption.SLIP,
        Standing.APPROXIMATE if change <= LARGEST_CHANGE else Standing.OUTSIDE,
        "Friction falls with the velocity at which rigid bodies would slip; that at which the springs unload, left "
        f"out, changes it by about {100.0 * change:.2g} per cent at most.",
        POLACH,
        change,
    )


def size_note(footprint: ContactEllipse | CurvedBodies | CurvedPair, longitudinal: float, lateral: float) -> Note:
    """Return whether the bodies may be taken for half-spaces, with a contact of these semi-axes [m]."""
    if isinstance(footprint, ContactEllipse):
        return PRESCRIBED_ELLIPSE
    radii = footprint.longitudinal_curvature_radius, footprint.lateral_curvature_radius
    ratio = max(longitudinal / radii[0], lateral / radii[1])
    if ratio <= 0.1:
        standing, verdict = Standing.ASYMPTOTIC, "the bodies may be taken for half-spaces"
    elif ratio <= 0.5:
        standing, verdict = Standing.APPROXIMATE, "the bodies are hardly half-spaces any more"
    else:
        standing, verdict = Standing.OUTSIDE, "the bodies are no half-spaces"
    statement = f"The semi-axes are up to {ratio:.3g} of the relative radii of curvature: {verdict}."
    return Note(Assumption.HALF_SPACE, standing, statement, JOHNSON)
