"""Forces of held contacts in tables: time and force."""

from __future__ import annotations

import os

from winkler.fitting.holds.held_force import HeldForce
from winkler.io.foreign import in_file, reader
from winkler.io.tables.relaxation_table import TIME
from winkler.io.tables.table import Column, read_table
from winkler.problems.poroelastic.held import HeldProfile

FORCE = Column("force", ("force", "load", "f", "f_n"), "N", "mN")


@reader("forces of a hold")
def read_held_force(path: str | os.PathLike[str], *, profile: HeldProfile, depth: float) -> HeldForce:
    """Read the force on an indenter that was pressed in at once and held.

    Parameters
    ----------
    path : str or path
        A table with the columns time (t), since the depth was reached, and force (load, f), without its baseline, as in
        ``time [s], force [uN]``.
    profile : Paraboloid, Sphere, Cone or FlatPunch
        The indenter.
    depth : float
        d [m] at which it was held.

    Returns
    -------
    HeldForce

    Raises
    ------
    InvalidInput
        If the file cannot be read, or its rows are not those of a hold.
    """
    time, force = read_table(path, (TIME, FORCE)).values.T
    with in_file(str(path)):
        return HeldForce(profile, depth, time, force)
