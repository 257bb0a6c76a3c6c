"""Kinds of tables by the columns that their headers name, in the order in which they are tried.

The first kind that the header names and whose reader takes the file is what the file is taken for.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from winkler.io.indenter_file import AREA, read_area
from winkler.io.indenter_file import DEPTH as CONTACT_DEPTH
from winkler.io.logs import log_tables as logs
from winkler.io.swapped_columns import refuse_list
from winkler.io.tables import (
    bed_table,
    cross_profile_file,
    grading_table,
    held_force_table,
    path_table,
    profile_table,
    relaxation_table,
    spectrum_table,
    surface_load_table,
    sweeps_table,
)
from winkler.io.tables.column import Column
from winkler.io.tables.curve_table import RESULTS
from winkler.io.tables.header import names_columns
from winkler.io.tables.relaxation_table import TIME
from winkler.io.tables.table import read_table
from winkler.materials.depth_grading import TabulatedGrading
from winkler.materials.sweeps import DynamicSweeps
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words

Header = tuple[Column, ...]
REDUCED = Column("reduced modulus", ("er", "reduced modulus"), "Pa")
"""In lists of results."""
GREATEST = (
    Column("greatest force", ("pmax", "fmax", "max load", "max. load", "maximum load", "peak load", "max force"), "N"),
    Column("greatest depth", ("hmax", "max depth", "max. depth", "maximum depth", "peak depth"), "m"),
)
"""In lists of results, and in no curve."""
HELD = "force over time of a hold"
ASSUMED_POISSON = 0.3
"""Of a grading whose table has no Poisson's ratio; the study to start from states it."""


class TableKind(NamedTuple):
    """A kind of table.

    Parameters
    ----------
    name : str
        What a file is taken for.
    headers : tuple of tuple of Column
        Alternatives; one of them names the columns.
    read : callable
        Reads the file; InvalidInput where it is none.
    study : str
        Name of the study to start from; empty where there is none.
    """

    name: str
    headers: tuple[Header, ...]
    read: Callable[[str | os.PathLike[str]], Any]
    study: str


@value
class AreaTable:
    """Cross-sections of a tip over the contact depth."""

    __words__ = words(contact_depth=("h_c", "m", "contact depth"), area=("A", "m^2", "cross-section of the tip"))

    contact_depth: Array
    area: Array


@value
class HeldTable:
    """The force over the time of a contact that is held."""

    __words__ = words(time=("t", "s", "time since the depth was reached"), force=("F_N", "N", "force on the indenter"))

    time: Array
    force: Array


def _area(path: str | os.PathLike[str]) -> AreaTable:
    read_area(path)
    table = read_table(path, (CONTACT_DEPTH, AREA))
    if any(names_columns(path, (AREA, one)) for one in (*RESULTS, REDUCED)):
        refuse_list(path, table.read_as, *table.values.T)
    return AreaTable(*table.values.T)


def _held(path: str | os.PathLike[str]) -> HeldTable:
    return HeldTable(*read_table(path, (TIME, held_force_table.FORCE)).values.T)


def _grading(path: str | os.PathLike[str]) -> TabulatedGrading:
    has_poisson = names_columns(path, (grading_table.POISSON,))
    return (
        grading_table.read_grading(path) if has_poisson else grading_table.read_grading(path, poisson=ASSUMED_POISSON)
    )


def _sweeps(path: str | os.PathLike[str]) -> DynamicSweeps:
    sweeps = sweeps_table.read_dynamic_sweeps(path)
    if np.ptp(sweeps.temperature) < sweeps_table.LEAST_RANGE:
        raise InvalidInput(f"{path}: all rows have one temperature, {sweeps.temperature[0]:.4g} K; it is one sweep.")
    return sweeps


def _headers(first: tuple[Header, ...], *rest: tuple[Header, ...]) -> tuple[Header, ...]:
    """Return the combinations of parts of headers."""
    if not rest:
        return first
    return tuple((*one, *other) for one in first for other in _headers(*rest))


FREQUENCIES = (
    (relaxation_table.ANGULAR,),
    (relaxation_table.FREQUENCY,),
)
MODULI = tuple((size, other) for size, other, _, _ in relaxation_table.MODULI)
RELAXATIONS = ((relaxation_table.SHEAR_MODULUS,), (relaxation_table.YOUNG_MODULUS,))
WAVES = ((spectrum_table.WAVE_NUMBER,), (spectrum_table.WAVELENGTH,), (spectrum_table.FREQUENCY,))
NORMALS = tuple(path_table.NORMAL_COLUMNS.values())
LATERALS = tuple(path_table.LATERAL_COLUMNS.values())

SPECIFIC = (
    TableKind(
        "storage and loss at several temperatures",
        _headers(((sweeps_table.TEMPERATURE_OR_T,),), FREQUENCIES, MODULI),
        _sweeps,
        "dynamic_sweeps",
    ),
    TableKind(
        "relaxation at several temperatures",
        _headers(((sweeps_table.TEMPERATURE,),), ((TIME,),), RELAXATIONS),
        sweeps_table.read_relaxation_sweeps,
        "relaxation_sweeps",
    ),
    TableKind("storage and loss", _headers(FREQUENCIES, MODULI), relaxation_table.read_dynamic, "dynamic"),
    TableKind("relaxation", relaxation_table.RELAXATION_HEADERS, relaxation_table.read_relaxation, "relaxation"),
    TableKind("creep", relaxation_table.CREEP_HEADERS, relaxation_table.read_creep, "creep"),
    TableKind(
        "map of pressures",
        ((surface_load_table.X, surface_load_table.Y, surface_load_table.PRESSURE),),
        surface_load_table.read_surface_load,
        "surface_load",
    ),
    TableKind(
        "power spectrum",
        _headers(WAVES, ((spectrum_table.DENSITY,),)),
        spectrum_table.read_spectrum,
        "spectrum",
    ),
    TableKind(
        "measured bed",
        ((bed_table.RADIUS, bed_table.STIFFNESS, bed_table.DEPTH),),
        bed_table.read_bed,
        "bed",
    ),
    TableKind("loops of friction", ((logs.DISPLACEMENT, logs.SHEAR),), logs.read_friction_log, "friction_loops"),
    TableKind(
        "contact resistance over force",
        ((logs.FORCE, logs.RESISTANCE),),
        logs.read_resistance_log,
        "measured_constriction",
    ),
    TableKind("path", _headers(((path_table.TIME,),), NORMALS, LATERALS), path_table.read_path, "path"),
    TableKind("bounces by their times", ((logs.BOUNCE,),), logs.read_bounces, "bounces"),
    TableKind(
        "log of a pin on a disc",
        _headers(((logs.DISTANCE,), (logs.CLOCK,)), ((logs.FRICTION,), (logs.LOSS,))),
        logs.read_pin,
        "",
    ),
)
"""Tables whose names are those of no force curve."""
GENERAL = (
    TableKind("area function of a tip", ((CONTACT_DEPTH, AREA),), _area, "area"),
    TableKind("grading", ((grading_table.DEPTH, grading_table.YOUNG),), _grading, "grading"),
    TableKind(
        "profile of a body of revolution",
        ((Column("radius", ("radius", "r"), "m"), profile_table.HEIGHT),),
        profile_table.read_profile,
        "profile",
    ),
    TableKind(
        "profile across the direction of rolling",
        ((Column("place across", ("y", "lateral"), "m", "mm"), cross_profile_file.UP),),
        cross_profile_file.read_cross_profile,
        "cross_profile",
    ),
    TableKind(HELD, ((TIME, held_force_table.FORCE),), _held, ""),
    TableKind("creep", (relaxation_table.STRAINED[:2],), relaxation_table.read_creep, "creep"),
)
"""Tables that are sought where a file is no force curve."""
