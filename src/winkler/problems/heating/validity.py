"""Validity notes of every solution of frictional heating."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from winkler.laws.heat import EqualMean, FixedShare, HeatPartition
from winkler.materials.conductor import ThermalConductor
from winkler.media.halfspace import HomogeneousMedium
from winkler.numerics.types import Array
from winkler.problems.assumptions.coupling import sliding_note
from winkler.problems.assumptions.temperature import temperature_note
from winkler.problems.heating.heat_source import HeatedContact
from winkler.problems.normal.elliptic import pressed_yield_notes
from winkler.problems.normal.elliptic_fields import traction_of
from winkler.problems.normal.indentation import IndentationSolution
from winkler.problems.normal.unknown_yield import unknown_yield
from winkler.problems.normal.yield_of_pressure import ellipse_yield_notes
from winkler.problems.normal.yield_statement import SurfaceFriction
from winkler.values.validity import Assumption, Note, Standing

JAEGER = "J. C. Jaeger, Proc. R. Soc. New South Wales 76 (1942) 203-224"
BLOK = "H. Blok, The flash temperature concept, Wear 6 (1963) 483-494"
OWN = "own quadrature of the moving source, checked against the sum of point sources"
SLOW_PECLET = 0.01
"""Peclet number below which the rule of slow sliding is good to half a per cent."""

RUBBED, EVEN = "pressure times friction coefficient times speed at every point", "the given one over the whole band"
"""Where heat enters, as notes say it: in a contact, and on an even band."""


def _steady(flux: str = RUBBED, plated: bool = False) -> Note:
    """Return what was assumed of conduction under a steady flux, of bodies `plated` or not."""
    thick = "half-spaces of constant conductivity and diffusivity"
    stack = "bonded platings and substrates of constant conductivity and diffusivity, without interface resistance"
    return Note(
        Assumption.CONDUCTION,
        Standing.EXACT,
        f"Steady heat conduction in {stack if plated else thick}. No heat leaves the surface outside the "
        f"{'band' if flux == EVEN else 'contact'}. The flux is {flux}.",
        "own transfer through the layers, wave by wave" if plated else JAEGER,
    )


STEADY_SOURCE = _steady()


BY_PIXELS = Note(
    Assumption.RESOLUTION,
    Standing.ASYMPTOTIC,
    "The heat flux follows the pressure of the pixels. Compared with closed forms for ellipses on half-spaces and "
    "round contacts on equal layers, at Peclet numbers up to 1e7, maximum temperatures differ by at most 5e-4, mean "
    "temperatures by 2e-3.",
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
        rubbed = unknown_yield(layered, "the contact slides along several lines")
        if angle is not None:
            rubbed = pressed_yield_notes(contact, traction_of(coefficient, angle))
        yields = (*rubbed, BY_PIXELS)
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
        f"The motion is included at all speeds (Pe up to {float(np.max(peclets)):.3g}). Heat flows across the "
        "strip and into the depth, not along the strip. A slow body reaches this temperature only after a "
        "sliding distance in which heat spreads over a few times kappa / V.",
        JAEGER,
    )
    rise = float(np.max(greatest))
    hottest = temperature_note(rise, "Conductivity and diffusivity") if flux == EVEN else temperature_note(rise)
    return _steady(flux, plated), motion, _sharing(None, greatest, means, partition), hottest


def swing_of(bodies: Sequence[ThermalConductor], frequency: float, most: float, mean: float) -> float:
    """Return an estimate of the temperature amplitude about the mean of a cycle [K].

    Parameters
    ----------
    bodies : sequence of ThermalConductor
        Both bodies.
    frequency : float
        Of the cycle [Hz].
    most, mean : float
        Greatest mean flux [W/m^2], and greatest mean rise of temperature [K].
    """
    effusivity = sum(body.conductivity / math.sqrt(body.diffusivity) for body in bodies)
    return min(most / (effusivity * math.sqrt(4.0 * math.pi * frequency)), mean) if effusivity > 0.0 else mean


def oscillation_notes(
    bodies: Sequence[ThermalConductor], frequency: float, swing: float, stroke: float
) -> tuple[Note, Note]:
    """Return that motion and swing of a cycle are neglected, and estimated.

    Parameters
    ----------
    bodies, frequency
        As of `swing_of`.
    swing : float
        Its estimate [K].
    stroke : float
        Amplitude of the motion over the radius of the source [-].
    """
    reach = math.sqrt(max(body.diffusivity for body in bodies) / (2.0 * math.pi * frequency))
    deep = f" The thermal penetration depth per cycle is {reach:.2g} m." if reach < math.inf else ""
    return (
        Note(
            Assumption.STEADY,
            Standing.ASYMPTOTIC,
            f"The heat source moves by {stroke:.2g} of its radius to each side; this motion is neglected.",
            "the solution itself",
        ),
        Note(
            Assumption.CONDUCTION,
            Standing.APPROXIMATE,
            f"The oscillation about the mean, about {swing:.3g} K, is an estimate for a heat flux that "
            "varies in time as 1 + cos(4 pi f t). The estimate is the smaller of two values: the mean temperature, "
            f"and the amplitude of a plane that is heated uniformly.{deep}",
            "one-dimensional diffusion; H. S. Carslaw, J. C. Jaeger, Conduction of Heat in Solids, Oxford 1959",
        ),
    )


def _speed(peclets: tuple[Array, Array], overestimate: Array, plated: bool) -> Note:
    fastest, excess = float(np.max(peclets)), float(np.max(overestimate))
    if fastest <= SLOW_PECLET:
        rule = "" if plated else "T = mu v E* u_z / (2 (lambda_1 + lambda_2)) "
        return Note(
            Assumption.CONDUCTION,
            Standing.ASYMPTOTIC,
            f"Slow sliding, Pe = {fastest:.3g} at most: both bodies are treated as at rest. The rule {rule}would "
            f"be at most {100.0 * excess:.2g} % too high.",
            OWN,
        )
    return Note(
        Assumption.CONDUCTION,
        Standing.EXACT,
        f"The motion is included (Pe up to {fastest:.3g}); the approximation of slow sliding would be at most "
        f"{100.0 * excess:.3g} % too high. The temperatures apply after sliding for many times a^2/kappa for a "
        "body at rest relative to the contact, and a/V for a fast body.",
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
            f"The heat partition was prescribed: the first body receives a share of {partition.first_share:g}.",
            "the problem",
        )
    if peclets is not None and max(float(np.max(each)) for each in peclets) <= SLOW_PECLET:
        return Note(
            Assumption.CONDUCTION,
            Standing.ASYMPTOTIC,
            "Both bodies move so slowly that they are treated as at rest. A heat partition proportional to the "
            "conductivities gives equal temperatures everywhere.",
            BLOK,
        )
    scale = np.maximum(*greatest)
    apart = np.max(np.maximum(abs(greatest[0] - greatest[1]), abs(means[0] - means[1])) / np.where(scale > 0, scale, 1))
    equal = "mean" if isinstance(partition, EqualMean) else "maximum"
    other = "maximum" if isinstance(partition, EqualMean) else "mean"
    return Note(
        Assumption.CONDUCTION,
        Standing.APPROXIMATE,
        f"One heat partition for the whole contact makes the {equal} temperatures of both bodies equal, but not "
        f"the temperatures at every point. The {other} temperatures differ by {100.0 * float(apart):.2g} % of the "
        "maximum.",
        BLOK,
    )
