"""A contact law as a source file of another language, which tests itself against a trace of winkler.

Names with which the functions and files of an exported law cannot begin: words that a language has or a file uses.

One list serves all targets, so that a law keeps its name when it is exported to another one.
"""

from __future__ import annotations

import keyword
import math
import os
import re
import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from winkler.exporting.choose import law_of
from winkler.exporting.laws.particle import ball_of
from winkler.exporting.step_law import RADIUS, StepLaw
from winkler.exporting.targets.c_law import c_law
from winkler.exporting.targets.dem_engine_law import dem_engine_law
from winkler.exporting.targets.fmu_law import fmu3_law, fmu_law
from winkler.exporting.targets.fortran_law import fortran_law
from winkler.exporting.targets.lammps_law import lammps_law
from winkler.exporting.targets.python_law import python_law
from winkler.exporting.targets.single import single_law
from winkler.exporting.targets.wasm_law import wasm_law
from winkler.io.whole_file import write_whole
from winkler.media.offers import offers
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.problems.viscoelastic.march import elastic_like
from winkler.values.checks.number_checks import POSITIVE, Whole, checked
from winkler.values.errors import InvalidInput, suggest
from winkler.values.value import value, words

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
    """A contact law translated into another programming language.

    Parameters
    ----------
    name : str
        Prefix of the names of its functions.
    to : str
        The language.
    title : str
        A title for the heading of the file.
    files : tuple of (str, str or bytes)
        Name and content of every file.
    state_size : int
        Size of the state of one contact in bytes.
    """

    __words__ = words(
        to=("", None, "language of the file"),
        files=("", None, "name and content of every file"),
        state_size=("", "", "bytes of the state of a contact"),
    )

    name: str
    to: str
    title: str
    files: tuple[tuple[str, str | bytes], ...]
    state_size: int

    @property
    def text(self) -> str:
        """Content of the first file; empty if the file is binary."""
        first = self.files[0][1]
        return first if isinstance(first, str) else ""


def export(
    law: Any, to: str, *, name: str = "contact", tolerance: float = 1e-6, count: int = 32, precision: str = "double",
    every_radius: bool = False,
) -> ExportedLaw:  # fmt: skip
    """Return a contact law as a source file of another language.

    The law is translated from the source of winkler's compiled loops. The heading of the file states units, signs,
    inputs and validity. The file also contains results of winkler for one load history, so that the compiled code can
    test itself.

    Parameters
    ----------
    law : problem
        One of the problems of `winkler.exporting.choose.LAWS`, such as Indentation, Tangential or Contacts.
    to : str
        One of "c", "python", "fortran", "lammps", "dem-engine", "fmu", "fmu3", "wasm".
    name : str, optional
        Prefix of functions and types: a word in lower-case letters that is not a keyword of the target language.
    tolerance : float, optional
        Maximum error of a tabulated normal force, relative to the maximum force.
    count : int, optional
        Number of springs of a `Tangential`; `Contacts` define their own number.
    precision : str, optional
        "double", or "float" in C. For "float" the heading of the file states the resulting error along the test
        history.

    every_radius : bool, optional
        Whether the radius R of the pair is an input of every step, so that balls of all sizes have one law; for balls
        on homogeneous media.  The maximum depth and the rolling arm of the study then scale with R; the work of
        adhesion does not.

    Returns
    -------
    ExportedLaw

    Raises
    ------
    InvalidInput
        If the target is unknown, the name is not allowed, or the problem cannot be exported.
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
        Folder for the files; it is created if it does not exist.

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


C = """
alignas alignof auto bool break case char const constexpr continue default do double else enum extern false float for
goto if inline int long main nullptr register restrict return short signed sizeof static struct switch thread_local true
typedef typeof union unsigned void volatile while
assert complex ctype errno fenv inttypes iso646 limits locale math setjmp signal stdalign stdarg stdatomic stdbool
stddef stdint stdio stdlib stdnoreturn string tgmath threads time uchar wchar wctype
"""
"""Words of C, and its headers: a file of the same name in the folder would be taken for them."""
CPP = """
and asm bitand bitor catch class compl concept consteval constinit decltype delete dynamic_cast explicit export friend
mutable namespace new noexcept not operator or private protected public reinterpret_cast requires static_assert
static_cast template this throw try typeid typename using virtual xor std lammps
"""
FORTRAN = """
abs bind block call contains do else end error function if implicit import in inout integer intent interface intrinsic
logical max maxval merge module name none out parameter print procedure program real result stop submodule subroutine
type use
iso_c_binding c_alert c_associated c_backspace c_bool c_carriage_return c_char c_double c_double_complex c_f_pointer
c_f_procpointer c_f_strpointer c_float c_float128 c_float128_complex c_float_complex c_form_feed c_funloc c_funptr
c_horizontal_tab c_int c_int8_t c_int16_t c_int32_t c_int64_t c_int128_t c_int_fast8_t c_int_fast16_t c_int_fast32_t
c_int_fast64_t c_int_fast128_t c_int_least8_t c_int_least16_t c_int_least32_t c_int_least64_t c_int_least128_t
c_intmax_t c_intptr_t c_loc c_long c_long_double c_long_double_complex c_long_long c_new_line c_null_char
c_null_funptr c_null_ptr
c_ptr c_ptrdiff_t c_short c_signed_char c_size_t c_sizeof c_vertical_tab
"""
"""Words of the module and of what it uses: a module cannot have the name of anything within."""
JAVASCRIPT = "arguments await debugger eval extends function instanceof let null super undefined var"
FILES = "aux con nul prn " + " ".join(f"com{k} lpt{k}" for k in range(1, 10))
USED = "answer expected got motion nothing numpy scale state step trial worst"
RESERVED = {
    **dict.fromkeys(USED.split(), "the exported files"),
    **dict.fromkeys(FILES.split(), "Windows, for a device"),
    **dict.fromkeys(sys.stdlib_module_names, "Python"),
    **dict.fromkeys(keyword.kwlist, "Python"),
    **dict.fromkeys(JAVASCRIPT.split(), "JavaScript"),
    **dict.fromkeys(CPP.split(), "C++"),
    **dict.fromkeys(FORTRAN.split(), "Fortran"),
    **dict.fromkeys(C.split(), "C"),
}
"""Word -> whose it is."""


def refuse_reserved(name: str) -> None:
    """Refuse a name that is a word of a target.

    Raises
    ------
    InvalidInput
    """
    if name in RESERVED:
        raise InvalidInput(
            f"export: {name!r} is a word of {RESERVED[name]}, not a name of functions and files; give another, such as "
            "contact."
        )


TRIAL_SIZE = 0.4
"""Of the pair in the test trace, over that of the study."""


def of_every_radius(law: StepLaw, problem: Any) -> StepLaw:
    """Return the law with R of the pair as the last number that goes in.

    Raises
    ------
    InvalidInput
        If the problem is not one of balls on homogeneous bodies, whose contacts of all radii are alike.
    """
    if math.isnan(law.curvature_radius):
        raise InvalidInput(
            "export: every-radius needs a paraboloid as profile, whose contacts of all radii are similar; leave it "
            "out, or give another profile."
        )
    bed = getattr(getattr(problem, "problem", problem), "bed", None)
    if bed is not None:
        ball_of(elastic_like(bed) if offers(bed.medium, RelaxingMedium) else bed)
    given = law.curvature_radius
    note = (
        f"R of the pair goes in. The numbers below are those of R = {given:.4g} m; lengths that they state are in "
        "proportion to R."
    )
    powers = np.array([TRIAL_SIZE if one.unit == "m" else 1.0 for one in law.motion])
    trial = np.column_stack([law.trial * powers, np.full(len(law.trial), TRIAL_SIZE * given)])
    return law._replace(motion=(*law.motion, RADIUS), trial=trial, notes=(note, *law.notes), every_radius=True)
