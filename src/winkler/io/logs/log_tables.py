"""Logs of tests in tables, each with names of its own in the header."""

from __future__ import annotations

import os
from collections.abc import Mapping

import numpy as np

from winkler.fitting.logs.contact_resistance import ResistanceLog
from winkler.fitting.logs.friction_log import FrictionLog
from winkler.fitting.logs.runs import BounceTimes, PinOnDisc
from winkler.io.foreign import in_file, reader
from winkler.io.tables.column import Column
from winkler.io.tables.given_units import checked_units
from winkler.io.tables.header import names_columns
from winkler.io.tables.table import HEADER_AGAIN, read_table
from winkler.io.tables.tests_of_table import parts_of_table
from winkler.values.errors import InvalidInput

BOUNCE = Column("time of a bounce", ("bounce", "bounces", "bounce time", "impact time", "bounce_time"), "s")
DISTANCE = Column("distance", ("distance", "sliding distance", "path", "gleitweg"), "m")
FRICTION = Column(
    "coefficient of friction",
    ("cof", "mu", "friction coefficient", "coefficient of friction", "traction coefficient", "traction coeff"),
    "",
)
CLOCK = Column(
    "time", ("time", "t", "timestamp", "elapsed time", "test time", "step time", "zeit", "temps", "tiempo"), "s"
)
LOSS = Column("height loss", ("height loss", "wear depth", "wear", "linear wear", "verschleiss"), "m", "um")
DISPLACEMENT = Column(
    "displacement",
    (
        *("displacement", "position", "shift", "slip", "tangential displacement", "lateral displacement", "stroke"),
        *("fretting displacement", "relative displacement", "disp", "u_x", "ux", "x", "weg", "verschiebung"),
        *("déplacement", "deplacement", "desplazamiento"),
    ),
    "m",
    "um",
)
SHEAR = Column(
    "shear force",
    (
        *("friction force", "tangential force", "shear force", "lateral force", "traction force", "shear_force"),
        *("friction", "f_t", "ft", "f_x", "fx", "q", "tangential load", "reibkraft", "reibungskraft"),
        *("tangentialkraft", "querkraft", "force de frottement", "force tangentielle", "fuerza de fricción"),
    ),
    "N",
)
PRESSED = Column(
    "normal force",
    ("normal force", "normal load", "normal_force", "f_n", "fn", "f_z", "fz", "load", "normalkraft", "force normale"),
    "N",
)
FORCE = Column("force", (*PRESSED.names, "force", "contact force", "kontaktkraft", "kraft"), "N")
RESISTANCE = Column(
    "contact resistance",
    (
        *("contact resistance", "resistance", "rc", "r_c", "contact_resistance", "kontaktwiderstand", "widerstand"),
        *("übergangswiderstand", "résistance", "résistance de contact", "resistencia"),
    ),
    "ohm",
    "mohm",
)


@reader("a log of friction")
def read_friction_log(path: str | os.PathLike[str]) -> FrictionLog:
    """Read loops of friction from a table with a displacement and a friction, tangential or shear force.

    Parameters
    ----------
    path : str or path
        The file.  Its header contains units, as in ``displacement [um], friction force [N]``; a column of the normal
        force is read where there is one.

    Returns
    -------
    FrictionLog

    Raises
    ------
    InvalidInput
        If the file cannot be read, or holds no whole cycle.
    """
    more = (PRESSED,) if names_columns(path, (DISPLACEMENT, SHEAR, PRESSED)) else ()
    table = read_table(path, (DISPLACEMENT, SHEAR, *more))
    with in_file(table.path):
        return FrictionLog(*table.values.T)


@reader("a log of contact resistance")
def read_resistance_log(path: str | os.PathLike[str]) -> ResistanceLog:
    """Read contact resistance over force from a table with both columns, as in ``force [N], resistance [mohm]``.

    Parameters
    ----------
    path : str or path
        The file.

    Returns
    -------
    ResistanceLog

    Raises
    ------
    InvalidInput
        If the file cannot be read, or holds no such log.
    """
    table = read_table(path, (FORCE, RESISTANCE))
    with in_file(table.path):
        return ResistanceLog(*table.values.T)


@reader("times of bounces")
def read_bounces(path: str | os.PathLike[str]) -> BounceTimes:
    """Read times of bounces from a table with a column bounce, bounce time or impact time.

    Parameters
    ----------
    path : str or path
        The file.

    Returns
    -------
    BounceTimes

    Raises
    ------
    InvalidInput
        If the file cannot be read, or there are fewer than five times.
    """
    table = read_table(path, (BOUNCE,))
    with in_file(table.path):
        return BounceTimes(table.values[:, 0])


@reader("a log of a pin on a disc")
def read_pin(path: str | os.PathLike[str], *, speed: float = 0.0, units: Mapping[str, str] | None = None) -> PinOnDisc:
    """Read a log with a distance and a coefficient of friction (cof, mu), a height loss (wear depth), or both.

    Parameters
    ----------
    path : str or path
        The file.
    speed : float, optional
        Sliding speed [m/s], for a log with times instead of distances. If the times start again, as at each step of a
        test program, the distance continues; sections under separate headers are joined.
    units : mapping of str to str, optional
        Of times, where the header states none: ``{"time": "s"}``.

    Returns
    -------
    PinOnDisc

    Raises
    ------
    InvalidInput
        If the file cannot be read, or holds no such log.
    """
    has_places = names_columns(path, (DISTANCE,))
    if has_places and speed:
        raise InvalidInput(f"{path}: its header names a distance; leave speed out.")
    if not (has_places or speed > 0.0) and names_columns(path, (CLOCK,)):
        raise InvalidInput(f"{path}: its header names times and no distance; give speed, that of sliding in m/s.")
    along = DISTANCE if has_places or not speed else CLOCK
    measured = [column for column in (FRICTION, LOSS) if names_columns(path, (along, column))]
    given = checked_units(units or {}) if along is CLOCK else None
    wanted = (along, *(measured or (FRICTION,)))
    try:
        tables = [read_table(path, wanted, units=given)]
    except InvalidInput as error:
        if along is not CLOCK or HEADER_AGAIN not in str(error):
            raise
        tables = [read_table(step, wanted, units=given) for step in parts_of_table(path, (wanted,))]
    values = np.concatenate([one.values for one in tables])
    found = {column.word: values[:, 1 + place] for place, column in enumerate(measured)}
    distance, nothing = values[:, 0], np.zeros(0)
    if along is CLOCK:
        step = np.diff(distance, prepend=0.0)
        distance = speed * np.cumsum(np.where(step < 0.0, distance, step))
    with in_file(path):
        return PinOnDisc(distance, found.get(FRICTION.word, nothing), found.get(LOSS.word, nothing))
