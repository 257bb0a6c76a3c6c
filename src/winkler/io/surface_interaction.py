r"""A rough joint as a surface interaction of Abaqus and CalculiX: pressure over closure, heat, friction.

Both take a joint as a law per area between smooth surfaces.  Of a periodic map that is pressed step by step,

.. math:: p = \frac{F}{A_0}, \quad h = \frac{2}{E^*(k_1^{-1}+k_2^{-1})}\,\frac{F'(d)}{A_0}, \quad
          \lambda = \frac{G^*}{E^*}\,\frac{F'(d)}{A_0}

are the pressure over the closure d, the conductance, in proportion to the stiffness (Barber), and the tangential
stiffness of the sticking joint, over the area of one period.  The bodies' own deformation is no part of d: the mean
displacement under a periodic load is left out, and the finite elements compute it.

References
----------
J. R. Barber, Proc. R. Soc. A 459 (2003) 53-66, doi:10.1098/rspa.2002.1038
G. Dhondt, CalculiX CrunchiX user's manual: \*SURFACE BEHAVIOR, \*GAP CONDUCTANCE, \*FRICTION
"""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Literal

import numpy as np

from winkler.io.whole_file import write_whole_text
from winkler.laws.friction import Coulomb
from winkler.media.conduction.conductors import HeatConductors
from winkler.media.halfspace import HomogeneousMedium
from winkler.numerics.types import Array
from winkler.problems.conduction.stiffness_analogy import conductance_of_stiffness
from winkler.problems.rough.surface_contact import SurfaceContactSolution
from winkler.values.errors import InvalidInput, OutsideValidity

NAME_PATTERN = r"[A-Za-z][A-Za-z0-9_]{0,79}"
UNITS = {"m": (1.0, "m, Pa, W/(m2 K)"), "mm": (1e3, "mm, N, s, K: MPa, mW/(mm2 K)")}
"""Unit of length -> how many are a metre, and the units that go with it and with N, s, K."""
PROGRAMS = ("abaqus", "calculix")


def write_surface_interaction(
    contact: SurfaceContactSolution,
    path: str | os.PathLike[str],
    *,
    program: Literal["abaqus", "calculix"],
    name: str = "ROUGH",
    conductors: HeatConductors | None = None,
    law: Coulomb | None = None,
    length_unit: Literal["m", "mm"] = "m",
) -> Path:
    r"""Write a rough joint as a surface interaction of Abaqus or CalculiX, a file that an input deck includes.

    Parameters
    ----------
    contact : SurfaceContactSolution
        A periodic map between homogeneous half-spaces under at least two rising loads.  The programs interpolate
        linearly between the rows, so give closely spaced loads.
    path : str or path
        The file; its ending must be ``.inp``.
    program : {"abaqus", "calculix"}
        The program that reads the file; the keywords for friction and heat differ.
    name : str, optional
        Of the surface interaction.
    conductors : HeatConductors, optional
        Thermal conductors: adds ``*GAP CONDUCTANCE`` as a function of pressure, for the contact spots only. Both must
        be thick, without platings or interface resistance.
    law : Coulomb, optional
        Adds ``*FRICTION``, with the tangential stiffness of the sticking joint under the maximum load: the stick slope
        of CalculiX, the elastic slip of Abaqus.
    length_unit : {"m", "mm"}, optional
        With "mm" pressures are in MPa and conductances in mW/(mm\ :sup:`2` K).

    Returns
    -------
    Path

    Raises
    ------
    InvalidInput
        If the file extension, program, name or unit is not supported, the map is not periodic, the loads do not rise,
        or the file cannot be written.
    OutsideValidity
        If the medium has layers, the surfaces touch everywhere (the joint is as stiff as one body), or the
        conductors are plated.
    """
    target = Path(path)
    if not isinstance(contact, SurfaceContactSolution):
        raise InvalidInput(
            f"write_surface_interaction: a {type(contact).__name__} is no contact of a map; give "
            "SurfaceContact(...).solve()."
        )
    if target.suffix != ".inp":
        raise InvalidInput(f"{target}: the ending is {target.suffix!r}; give .inp.")
    for what, given, allowed in (("program", program, PROGRAMS), ("length_unit", length_unit, tuple(UNITS))):
        if given not in allowed:
            raise InvalidInput(f"write_surface_interaction: {what} is {given!r}; give {' or '.join(allowed)}.")
    if not re.fullmatch(NAME_PATTERN, name):
        raise InvalidInput(
            f"write_surface_interaction: name is {name!r}; give letters, digits and _, a letter first, at most 80."
        )
    write_whole_text(target, "\n".join(_lines(contact, program, name, conductors, law, length_unit)) + "\n")
    return target


def _lines(
    contact: SurfaceContactSolution,
    program: str,
    name: str,
    conductors: HeatConductors | None,
    law: Coulomb | None,
    length_unit: str,
) -> list[str]:
    owner = "write_surface_interaction"
    medium = contact.problem.medium
    if not isinstance(medium, HomogeneousMedium):
        raise OutsideValidity(
            f"{owner}: the closure of a height map on a {type(medium).__name__} is not implemented; pressures, gaps "
            "and stiffness are. Give a HalfSpace."
        )
    closure, pressure, stiffness = _rows(contact)
    scale, units = UNITS[length_unit]
    lines = [
        f"** a rough joint by winkler, per area of the smooth surface; units: {units}",
        "** closure counts from the first touch of the summits; beyond the last row the law is not known",
        f"*SURFACE INTERACTION, NAME={name}",
        "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR",
        *_table(pressure / scale**2, closure * scale),
    ]
    if conductors is not None:
        each = conductance_of_stiffness(owner, medium, conductors) * stiffness / scale
        if program == "abaqus":
            lines += ["*GAP CONDUCTANCE, PRESSURE", *_table(each, pressure / scale**2)]
        else:  # the third number is a temperature, on which nothing depends
            lines += ["*GAP CONDUCTANCE", *_table(each, pressure / scale**2, np.zeros(each.size))]
    if law is not None:
        slope = medium.shear_modulus / medium.modulus * float(stiffness[-1])
        if program == "abaqus":
            slip = law.coefficient * float(pressure[-1]) / slope * scale
            lines += [f"*FRICTION, ELASTIC SLIP={slip:.10e}", f"{law.coefficient:.10e}"]
        else:
            lines += ["*FRICTION", f"{law.coefficient:.10e}, {slope / scale**3:.10e}"]
    return lines


def _rows(contact: SurfaceContactSolution) -> tuple[Array, Array, Array]:
    """Return closure [m], pressure [Pa] and stiffness [Pa/m], the first touch before the loads."""
    rough = contact.problem.topography
    if not rough.periodic:
        raise InvalidInput(
            "write_surface_interaction: the map stands alone, and has no pressure of a smooth surface; give a periodic "
            "one."
        )
    area = float(np.prod(rough.lengths))
    columns = (contact.depth, np.asarray(contact.force) / area, np.asarray(contact.stiffness) / area)
    closure, pressure, stiffness = (np.concatenate([[0.0], np.ravel(column)]) for column in columns)
    if closure.size < 3 or np.any(np.diff(closure) <= 0.0) or np.any(np.diff(pressure) <= 0.0):
        raise InvalidInput("write_surface_interaction: give a contact under at least two loads, each above the last.")
    if not np.all(np.isfinite(stiffness)):
        raise OutsideValidity(
            "write_surface_interaction: under the maximum load the surfaces touch everywhere; leave such loads out."
        )
    return closure, pressure, stiffness


def _table(*columns: Array) -> list[str]:
    return [", ".join(f"{number:.10e}" for number in row) for row in zip(*columns, strict=True)]
