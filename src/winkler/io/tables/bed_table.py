r"""Measured beds in tables: a force curve, or contact radius, stiffness and depth side by side.

A force curve F(d) and the modulus of the medium are enough, since its slope gives the contact radius,
:math:`a = \frac{1}{2E^*}\frac{\mathrm dF}{\mathrm dd}`.  Where the radius was measured as well, no modulus is needed.
"""

from __future__ import annotations

import os

from winkler.foundation.measured import MeasuredBed
from winkler.io.foreign import in_file, reader
from winkler.io.tables.header import names_columns
from winkler.io.tables.table import Column, read_table
from winkler.values.errors import InvalidInput

DEPTH = Column("depth", ("depth", "d", "indentation", "displacement"), "m", "nm")
FORCE = Column("force", ("force", "load", "f", "p"), "N", "mN")
RADIUS = Column("contact radius", ("radius", "a", "contact radius"), "m", "um")
STIFFNESS = Column("stiffness", ("stiffness", "k", "s"), "N/m")


@reader("a measured bed")
def read_bed(path: str | os.PathLike[str], *, modulus: float = 0.0, mindlin_ratio: float = 0.0) -> MeasuredBed:
    """Read a measured bed from a table: depth and force, or contact radius, stiffness and depth.

    Parameters
    ----------
    path : str or path
        The file.  Its header contains units, as in ``depth [nm], force [mN]`` (loading alone, counted from first
        touch) or ``radius [um], stiffness [N/m], depth [nm]``; columns with other names are ignored.
    modulus : float, optional
        E* [Pa] of the medium, positive: needed with a force curve, and only there.
    mindlin_ratio : float, optional
        c_T/c_N [-], for tangential problems; zero (the default) if it is not known.

    Returns
    -------
    MeasuredBed

    Raises
    ------
    InvalidInput
        If the file cannot be read or does not define a foundation, or the modulus is missing or superfluous.
    """
    has_radii = names_columns(path, (RADIUS, STIFFNESS, DEPTH))
    if has_radii and modulus != 0.0:
        raise InvalidInput(
            f"{path}: the table holds contact radii and stiffnesses, so that modulus = {modulus:g} Pa is not "
            "needed; leave it out."
        )
    table = read_table(path, (RADIUS, STIFFNESS, DEPTH) if has_radii else (DEPTH, FORCE))
    if not has_radii and modulus == 0.0:
        raise InvalidInput(
            f"{path}: a force curve alone does not give the contact radius; give modulus = E* of the medium, such as "
            "115 GPa for a hard tip on steel."
        )
    with in_file(table.path):
        if has_radii:
            radii, stiffnesses, depths = table.values.T
            return MeasuredBed(radii, stiffnesses, depths, mindlin_ratio=mindlin_ratio)
        depth, force = table.values.T
        return MeasuredBed.from_curve(depth, force, modulus, mindlin_ratio=mindlin_ratio)
