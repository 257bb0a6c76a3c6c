"""Validity notes of every solution of frictional heating."""

from __future__ import annotations

import math

import numpy as np

from winkler.laws.heat import EqualMean, FixedShare, HeatPartition
from winkler.media.halfspace import HomogeneousMedium
from winkler.numerics.types import Array
from winkler.problems.assumptions.coupling import sliding_note
from winkler.problems.assumptions.temperature import temperature_note
from winkler.problems.heating.heat_source import HeatedContact
from winkler.problems.normal.elliptic import IN_LAYERS
from winkler.problems.normal.indentation import IndentationSolution
from winkler.problems.normal.unknown_yield import unknown_yield
from winkler.problems.normal.yield_of_pressure import ellipse_yield_notes
from winkler.problems.normal.yield_statement import SurfaceFriction
from winkler.values.validity import Assumption, Note, Standing

__all__ = ["EVEN", "RUBBED", "STEADY_SOURCE", "heating_notes", "moving_notes", "sliding_contact_notes"]

JAEGER = "J. C. Jaeger, Proc. R. Soc. New South Wales 76 (1942) 203-224"
BLOK = "H. Blok, The flash temperature concept, Wear 6 (1963) 483-494"
OWN = "own quadrature of the moving source, checked against the sum of point sources"
SLOW_PECLET = 0.01
"""Peclet number below which the rule of slow sliding is good to half a per cent."""

RUBBED, EVEN = "the pressure times friction and speed, everywhere", "the one given, all over the band"
"""Where heat enters, as notes say it: in a contact, and on an even band."""


def _steady(flux: str = RUBBED, plated: bool = False) -> Note:
    """Return what was assumed of conduction under a steady flux, of bodies `plated` or not."""
    thick = "half-spaces of constant conductivity and diffusivity, nothing lost"
    stack = (
        "platings and what carries them, of constant conductivity and diffusivity, bonded without resistance; nothing "
        "is lost"
    )
    return Note(
        Assumption.CONDUCTION,
        Standing.EXACT,
        f"Steady heat conduction in {stack if plated else thick} through the surface outside the "
        f"{'band' if flux == EVEN else 'contact'}; the flux is {flux}.",
        "own transfer through the layers, wave by wave" if plated else JAEGER,
    )


STEADY_SOURCE = _steady()


BY_PIXELS = Note(
    Assumption.RESOLUTION,
    Standing.ASYMPTOTIC,
    "The heat follows the pressure of pixels: where closed forms are known, equal layers and round contacts, greatest "
    "temperatures were within 5e-4 of them and means within 2e-3, at Peclet numbers up to 1e7.",
    "comparison with ellipses on half-spaces and round contacts on layers",
)


def sliding_contact_notes(contact: HeatedContact, coefficient: float, angle: float | None = 0.0) -> tuple[Note, ...]:
    """Return how far a contact can be trusted all of which slides.

    Parameters
    ----------
    contact : IndentationSolution or EllipticSolution
    coefficient : float
        Of friction [-].
    angle : float, optional
        That of the line along which it slides to x [rad]; none if there are several.
    """
    if isinstance(contact, IndentationSolution):
        rubbed, medium = contact.notes_with(SurfaceFriction(coefficient, math.inf)), contact.problem.bed.medium
        return (*rubbed, sliding_note(medium, coefficient))
    layered, axes = contact.problem.medium, (contact.longitudinal_semi_axis, contact.lateral_semi_axis)
    if isinstance(layered, HomogeneousMedium):
        yields = ellipse_yield_notes(layered, axes, contact.force, coefficient, angle)
    else:
        yields = (*unknown_yield(layered, IN_LAYERS), BY_PIXELS)
    elastic = (note for note in contact.validity if note.assumption is not Assumption.ELASTIC)
    return (*elastic, *yields, sliding_note(layered, coefficient))  # type: ignore[arg-type]


def heating_notes(
    peclets: tuple[Array, Array],
    greatest: tuple[Array, Array],
    means: tuple[Array, Array],
    overestimate: Array,
    partition: HeatPartition,
    plated: bool = False,
) -> tuple[Note, ...]:
    """Return how far temperatures can be trusted.

    Parameters
    ----------
    peclets, greatest, means : tuple of ndarray
        Peclet numbers [-], greatest and mean temperatures [K] of both bodies.
    overestimate : ndarray
        By how much the rule of slow sliding is too high [-].
    partition : EqualMaximum, EqualMean or FixedShare
    plated : bool
        Whether a body has platings of another conductor.
    """
    hottest = temperature_note(float(np.max(greatest)))
    alike = None if plated else peclets
    return (
        _steady(plated=plated),
        _speed(peclets, overestimate, plated),
        _sharing(alike, greatest, means, partition),
        hottest,
    )


def moving_notes(
    peclets: tuple[Array, Array],
    greatest: tuple[Array, Array],
    means: tuple[Array, Array],
    partition: HeatPartition,
    plated: bool = False,
    flux: str = RUBBED,
) -> tuple[Note, ...]:
    """Return how far temperatures under a strip of heat can be trusted; parameters as of `heating_notes`."""
    motion = Note(
        Assumption.CONDUCTION,
        Standing.EXACT,
        f"Motion is taken into account at all speeds (Pe up to {float(np.max(peclets)):.3g}); heat flows across the "
        "strip and into the depth, not along it. A slow body comes to this temperature late: the heat must spread over "
        "a few times kappa / V.",
        JAEGER,
    )
    rise = float(np.max(greatest))
    hottest = temperature_note(rise, "Conductivity and diffusivity") if flux == EVEN else temperature_note(rise)
    return _steady(flux, plated), motion, _sharing(None, greatest, means, partition), hottest


def _speed(peclets: tuple[Array, Array], overestimate: Array, plated: bool) -> Note:
    fastest, excess = float(np.max(peclets)), float(np.max(overestimate))
    if fastest <= SLOW_PECLET:
        rule = "" if plated else "T = mu v E* u_z / (2 (lambda_1 + lambda_2)) "
        return Note(
            Assumption.CONDUCTION,
            Standing.ASYMPTOTIC,
            f"Slow sliding, Pe = {fastest:.3g} at most: both bodies are as good as at rest, and the rule {rule}would "
            f"be {100.0 * excess:.2g} % too high at most.",
            OWN,
        )
    return Note(
        Assumption.CONDUCTION,
        Standing.EXACT,
        f"Motion is taken into account (Pe up to {fastest:.3g}); the rule of slow sliding would be "
        f"{100.0 * excess:.3g} % too high at most. Temperatures are those after sliding for many times "
        "a^2/kappa where a body rests against the contact, and a/V where it moves fast.",
        OWN,
    )


def _sharing(
    peclets: tuple[Array, Array] | None,
    greatest: tuple[Array, Array],
    means: tuple[Array, Array],
    partition: HeatPartition,
) -> Note:
    if isinstance(partition, FixedShare):
        return Note(
            Assumption.CONDUCTION,
            Standing.EXACT,
            f"The share of the first body was given, {partition.first_share:g}.",
            "the problem",
        )
    if peclets is not None and max(float(np.max(each)) for each in peclets) <= SLOW_PECLET:
        return Note(
            Assumption.CONDUCTION,
            Standing.ASYMPTOTIC,
            "Both bodies are as good as at rest: shared in proportion to their conductivities, the heat makes their "
            "temperatures agree everywhere.",
            BLOK,
        )
    scale = np.maximum(*greatest)
    apart = np.max(np.maximum(abs(greatest[0] - greatest[1]), abs(means[0] - means[1])) / np.where(scale > 0, scale, 1))
    equal = "mean" if isinstance(partition, EqualMean) else "greatest"
    other = "greatest" if isinstance(partition, EqualMean) else "mean"
    return Note(
        Assumption.CONDUCTION,
        Standing.APPROXIMATE,
        f"One heat partition for the whole contact makes the {equal} temperatures of both bodies equal, but not "
        f"those at every point. The {other} ones differ by {100.0 * float(apart):.2g} % of the greatest.",
        BLOK,
    )
