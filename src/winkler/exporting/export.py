"""A contact law as a source file of another language, which tests itself against a trace of winkler."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from winkler.exporting.choose import law_of
from winkler.exporting.names import refuse_reserved
from winkler.exporting.sizes import of_every_radius
from winkler.exporting.step_law import StepLaw
from winkler.exporting.targets.c_law import c_law
from winkler.exporting.targets.dem_engine_law import dem_engine_law
from winkler.exporting.targets.fmu_law import fmu3_law, fmu_law
from winkler.exporting.targets.fortran_law import fortran_law
from winkler.exporting.targets.lammps_law import lammps_law
from winkler.exporting.targets.python_law import python_law
from winkler.exporting.targets.single import single_law
from winkler.exporting.targets.wasm_law import wasm_law
from winkler.io.whole_file import write_whole
from winkler.values.checks.number_checks import POSITIVE, Whole, checked
from winkler.values.errors import InvalidInput, suggest
from winkler.values.value import value, words

__all__ = ["TARGETS", "ExportedLaw", "export", "write_export"]

TARGETS: dict[str, tuple[str, Callable[[StepLaw, str], Mapping[str, str | bytes]]]] = {
    "c": ("one header in C99, without dependencies", lambda law, name: {f"{name}.h": c_law(law, name)}),
    "python": ("one file that needs numpy alone", lambda law, name: {f"{name}.py": python_law(law, name)}),
    "fortran": ("a module in Fortran 2008 over the header", fortran_law),
    "lammps": ("a pair style for LAMMPS' plugin load; without friction a sub-model of granular, too", lammps_law),
    "dem-engine": ("text of a force model for DEM-Engine, without friction", dem_engine_law),
    "fmu": ("a unit for co-simulation by FMI 2.0: source, and a binary where there is a C compiler", fmu_law),
    "fmu3": ("the same by FMI 3.0", fmu3_law),
    "wasm": ("a module of WebAssembly with an example in JavaScript; needs winkler[export]", wasm_law),
}
"""Target -> what it is, and what writes its files."""


@value
class ExportedLaw:
    """A contact law in another language.

    Parameters
    ----------
    name : str
        With which its functions begin.
    to : str
        The language.
    title : str
        What it is.
    files : tuple of (str, str or bytes)
        Name and content of every file.
    state_size : int
        How many bytes a contact remembers.
    """

    __words__ = words(
        to=("", None, "language of the file"),
        files=("", None, "name and content of every file"),
        state_size=("", "", "bytes that a contact remembers"),
    )

    name: str
    to: str
    title: str
    files: tuple[tuple[str, str | bytes], ...]
    state_size: int

    @property
    def text(self) -> str:
        """The first file; empty if it is no text."""
        first = self.files[0][1]
        return first if isinstance(first, str) else ""


def export(
    law: Any, to: str, *, name: str = "contact", tolerance: float = 1e-6, count: int = 32, precision: str = "double",
    every_radius: bool = False,
) -> ExportedLaw:  # fmt: skip
    """Return a contact law as a source file of another language.

    The law is translated from the source of winkler's own compiled loops.  Its heading states units, signs, inputs and
    validity; it holds a trace made by winkler with which it can be compared where it is compiled.

    Parameters
    ----------
    law : problem
        One of the problems of `winkler.exporting.choose.LAWS`, such as Indentation, Tangential or Contacts.
    to : str
        One of "c", "python", "fortran", "lammps", "dem-engine", "fmu", "fmu3", "wasm".
    name : str, optional
        With which functions and types begin; a word in small letters that is none of a target's language.
    tolerance : float, optional
        Error of a normal force that is given by a table, over the greatest force.
    count : int, optional
        How many springs a Tangential has; `Contacts` state it themselves.
    precision : str, optional
        "double", or "float" in C: the heading states by how much the answers are off along the test trace.

    every_radius : bool, optional
        Whether R of the pair goes into every step, so that balls of all sizes follow one law: of balls on homogeneous
        media.  Lengths of the study (deepest point, rolling arm) are then in proportion to R; works of adhesion stay.

    Returns
    -------
    ExportedLaw

    Raises
    ------
    InvalidInput
        If there is no such target, the name is none, or the problem is no law for other programs.
    NotConverged
        If a table would need too many rows.

    Examples
    --------
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.problems.particles.contacts import Contacts
    >>> glass = HalfSpace.between(Elastic(70e9, 0.22), Elastic(70e9, 0.22))
    >>> beads = export(Contacts.apart(glass, curvature_radius=1e-3, coefficient=0.3, reach=2e-6, count=8), "c")
    >>> [file for file, _ in beads.files], beads.state_size
    (['contact.h'], 168)
    """
    if to not in TARGETS:
        raise InvalidInput(f"export: there is no target {to!r}{suggest(to, TARGETS)}; give {', '.join(TARGETS)}.")
    if not re.fullmatch(r"[a-z][a-z0-9_]*", name) or len(name) > MOST_LETTERS:
        raise InvalidInput(
            f"export: {name!r} cannot begin the names of functions; give a word of small letters, digits and _, of at "
            f"most {MOST_LETTERS} letters."
        )
    refuse_reserved(name)
    checked(POSITIVE, "export", "tolerance", tolerance)
    checked(Whole(2, what="springs"), "export", "count", count)
    if precision not in PRECISIONS or (precision == "float" and to != "c"):
        raise InvalidInput(
            f"export: there is no precision {precision!r} for {to}; give double for all targets, float for c."
        )
    steps = law_of(law, tolerance=tolerance, count=count)
    steps = of_every_radius(steps, law) if every_radius else steps
    files = single_law(steps, name) if precision == "float" else TARGETS[to][1](steps, name)
    return ExportedLaw(name, to, steps.title, tuple(files.items()), steps.state_size)


MOST_LETTERS = 24
PRECISIONS = ("double", "float")


def write_export(exported: ExportedLaw, folder: str | os.PathLike[str]) -> tuple[Path, ...]:
    """Write the files of an exported law.

    Parameters
    ----------
    exported : ExportedLaw
    folder : str or path
        Where they are written; made if it is not there.

    Returns
    -------
    tuple of Path

    Raises
    ------
    InvalidInput
        If a file cannot be written.
    """
    if not isinstance(exported, ExportedLaw):
        raise InvalidInput(f"write_export: a {type(exported).__name__} is no exported law; give export(law, to).")
    target = Path(folder)
    try:
        target.mkdir(parents=True, exist_ok=True)
    except FileExistsError:
        raise InvalidInput(f"write_export: {target} is a file, not a folder; give another folder.") from None
    except OSError as error:
        raise InvalidInput(f"write_export: {target} cannot be made ({error.strerror}); give another folder.") from None
    files = {target / name: text.encode("utf-8") if isinstance(text, str) else text for name, text in exported.files}
    write_whole(files)
    return tuple(files)
