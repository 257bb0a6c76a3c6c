"""Studies with ``[indentation]`` or ``[calibration]`` read from TOML.

::

    [indentation]
    curve = "steel/*.csv"
    poisson = 0.3
    indenter = "results/calibration/indenter.toml"

    [calibration]
    [[calibration.reference]]
    curve = "silica/*.csv"
    young = "72 GPa"
    poisson = 0.17
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from winkler.fitting.nanoindentation.indenter import DIAMOND, CalibratedIndenter
from winkler.fitting.nanoindentation.reference_samples import ReferenceSample
from winkler.fitting.unloading.contact_reading import CalibratedArea
from winkler.io.indenter_file import read_area, read_indenter
from winkler.io.tables.given_units import checked_columns, checked_units
from winkler.materials.elastic import Elastic
from winkler.study.language import quantities
from winkler.study.language.compared.expectations import expectations
from winkler.study.language.fit_reading import curve_files
from winkler.study.language.reading import parsed, read_text
from winkler.study.language.segmenting import stated_segments
from winkler.study.language.study import Expectation, Output
from winkler.study.nanoindentation.keys import UNITS
from winkler.values.errors import InvalidInput, WinklerError, suggest
from winkler.values.value import value

SECTIONS = ("indentation", "calibration")
TOP = ("title", *SECTIONS, "indenter", "output", "expect", "source", "grade")
OF_OUTPUT = ("folder", "figures", "report", "workbook")
MEASURED, NO_DRIFT = "measured", "none"
LOWEST, HIGHEST = "depths.0", "depths.1"
"""Keys of the ends of the window of depths."""


@value
class NanoindentationStudy:
    """What to evaluate, or to calibrate.

    Parameters
    ----------
    title
        One line for tables, figures and the report.
    sources : tuple of str
        Files of curves, in their order.
    references : tuple
        Reference of every file in a calibration; empty otherwise.
    indenter : CalibratedIndenter
        The calibrated one; in a calibration solid and shape factor of it.
    numbers : tuple of (str, float)
        Numbers of the section, SI.
    output
        What is written.
    text, folder
        The study file, word for word, and where it lies.
    segments : tuple of str
        Stated segments of the curves; none where they are those of the file, or found.
    units : tuple of (str, str)
        Units that the files do not state.
    columns : tuple of (str, int)
        Numbers of columns that the files do not name.
    expect
        Expected numbers.
    source, grade
        Of a case: where these come from, and how independent they are.
    """

    title: str
    sources: tuple[str, ...]
    references: tuple[Any, ...]
    indenter: CalibratedIndenter
    numbers: tuple[tuple[str, float], ...]
    output: Output = Output()
    text: str = ""
    folder: str = "."
    expect: tuple[Expectation, ...] = ()
    source: str = ""
    grade: str = ""
    segments: tuple[str, ...] = ()
    units: tuple[tuple[str, str], ...] = ()
    columns: tuple[tuple[str, int], ...] = ()

    @property
    def calibrates(self) -> bool:
        """Whether this is a calibration."""
        return bool(self.references)

    @property
    def window(self) -> tuple[float, float] | tuple[()]:
        """The depths [m] between which continuous stiffness is averaged; empty where none are stated."""
        given = self.given
        return (given[LOWEST], given[HIGHEST]) if LOWEST in given else ()

    @property
    def given(self) -> dict[str, float]:
        """Numbers of the section by their keys, SI."""
        return dict(self.numbers)


def is_nanoindentation(path: Path) -> bool:
    """Return whether a study file has ``[indentation]`` or ``[calibration]``; False if it cannot be read."""
    try:
        raw = parsed(read_text(path), path.name)
    except WinklerError:
        return False
    return any(section in raw for section in SECTIONS)


def read_nanoindentation_study(path: Path, *, settings: Sequence[str] = ()) -> NanoindentationStudy:
    """Read a study, in which `settings` replace contents; the files that it names lie relative to it.

    Raises
    ------
    InvalidInput
        With one sentence: file, key, what it was, what is allowed.
    """
    text = read_text(path, settings)
    raw = parsed(text, path.name)
    try:
        return _study(raw, text, path)
    except InvalidInput as error:
        raise error.reworded(lambda one: one if one.startswith(path.name) else f"{path.name}: {one}") from None


def _study(raw: dict[str, Any], text: str, path: Path) -> NanoindentationStudy:
    _known(raw, TOP, "the study")
    if all(section in raw for section in SECTIONS):
        raise InvalidInput("a study has either [indentation] or [calibration]; write two studies.")
    title, output = str(raw.get("title", path.stem)), _output(raw.get("output", {}))
    folder = path.parent
    segments: tuple[str, ...] = ()
    if "calibration" in raw:
        section = _section(raw["calibration"], UNITS["calibration"], "calibration")
        units, columns = _tables(section, "calibration")
        if "indenter" in raw:
            raise InvalidInput("[indenter] is what a calibration finds; leave it out, or use [indentation].")
        sources, references = _references(section.pop("reference", []), folder)
        terms = section.pop("terms", 0)
        if isinstance(terms, bool) or not isinstance(terms, int) or not 0 <= terms <= 8:
            raise InvalidInput(
                f"calibration.terms is {terms!r}; give a whole number from 0 (the mean over 1 to 4) to 8."
            )
        solid = Elastic(section.pop("young", DIAMOND.young), section.pop("poisson", DIAMOND.poisson))
        indenter = CalibratedIndenter(
            CalibratedArea((24.5,)), solid=solid, shape_factor=section.pop("shape_factor", 1.0)
        )
        numbers = {"terms": float(terms), **section}
    else:
        section = _section(raw["indentation"], UNITS["indentation"], "indentation")
        for key in ("curve", "poisson"):
            if key not in section:
                raise InvalidInput(f"indentation.{key} is missing; give it.")
        sources, references = _files(section.pop("curve"), folder, "indentation.curve"), ()
        indenter = _indenter(section.pop("indenter", ""), raw.get("indenter"), folder)
        if "segments" in section:
            segments = quantities.read_at(
                "indentation.segments", section.pop("segments"), None, lambda stated, _: stated_segments(stated)
            )
        units, columns = _tables(section, "indentation")
        _state_drift(section)
        _state_depths(section)
        seeks = section.pop("pop_ins", False)
        if not isinstance(seeks, bool):
            raise InvalidInput(f"indentation.pop_ins is {seeks!r}; give true or false.")
        if seeks != ("tip_radius" in section):
            raise InvalidInput("indentation: pop_ins = true and tip_radius belong together; give both or none.")
        if not section.get("tip_radius", 1.0) > 0.0:
            raise InvalidInput(f"indentation.tip_radius is {section['tip_radius']:g} m; it must be positive.")
        numbers = section
        if ("contact_point" in numbers) != ("contact_point_error" in numbers):
            raise InvalidInput("indentation: contact_point and contact_point_error belong together; give both or none.")
    of_case = str(raw.get("source", "")), str(raw.get("grade", ""))
    return NanoindentationStudy(
        title,
        sources,
        references,
        indenter,
        tuple(numbers.items()),
        output,
        text,
        str(folder),
        expectations(raw.get("expect", []), path.name),
        *of_case,
        segments,
        units,
        columns,
    )


def _tables(section: dict[str, Any], where: str) -> tuple[tuple[tuple[str, str], ...], tuple[tuple[str, int], ...]]:
    """Return what the files do not state: units, and numbers of columns."""
    units = checked_units(section.pop("units", {}), f"{where}.units")
    columns = checked_columns(section.pop("columns", {}), f"{where}.columns")
    return tuple(sorted(units.items())), tuple(sorted(columns.items()))


def _state_drift(section: dict[str, Any]) -> None:
    """Put the number of a stated drift [m/s] in place of its word; "measured" is the same as none stated."""
    stated = section.pop("drift", MEASURED)
    if stated == MEASURED:
        if "drift_error" in section:
            raise InvalidInput(
                "indentation.drift_error belongs to a given drift; give drift as a number, or leave it out."
            )
        return
    section["drift"] = (
        0.0 if stated == NO_DRIFT else float(quantities.read_at("indentation.drift", stated, "m/s", quantities.number))
    )


def _state_depths(section: dict[str, Any]) -> None:
    """Put the ends [m] of the window of depths in place of its list."""
    stated = section.pop("depths", None)
    if stated is None:
        return
    if not isinstance(stated, list) or len(stated) != 2:
        raise InvalidInput(f"indentation.depths is {stated!r}; give two depths, such as ['75 nm', '85 nm'].")
    low, high = (
        float(quantities.read_at(f"indentation.depths[{place}]", one, "m", quantities.number))
        for place, one in enumerate(stated)
    )
    if not 0.0 <= low < high:
        raise InvalidInput(f"indentation.depths is {stated!r}; give the lesser depth first, and none below zero.")
    section[LOWEST], section[HIGHEST] = low, high


def _known(raw: Any, allowed: Any, where: str) -> None:
    if not isinstance(raw, dict):
        raise InvalidInput(f"{where} is {raw!r}; give a table of keys.")
    for key in raw:
        if key not in allowed:
            raise InvalidInput(f"{where} has no key '{key}'{suggest(key, tuple(allowed))}; give {', '.join(allowed)}.")


def _section(raw: Any, allowed: dict[str, str | None], where: str) -> dict[str, Any]:
    """Return a section with its quantities in SI units."""
    _known(raw, allowed, f"[{where}]")
    found = {}
    for key, content in raw.items():
        unit = allowed[key]
        found[key] = (
            content if unit is None else float(quantities.read_at(f"{where}.{key}", content, unit, quantities.number))
        )
    return found


def _output(raw: Any) -> Output:
    _known(raw, OF_OUTPUT, "[output]")
    figures = raw.get("figures", ["svg"])
    if not isinstance(figures, list) or any(one not in ("svg", "png", "pdf") for one in figures):
        raise InvalidInput(f"output.figures is {figures!r}; give a list of svg, png, pdf.")
    switches = {name: raw[name] for name in ("report", "workbook") if name in raw}
    for name, given in switches.items():
        if not isinstance(given, bool):
            raise InvalidInput(f"output.{name} is {given!r}; give true or false.")
    return Output(folder=str(raw.get("folder", "")), figures=tuple(figures), **switches)


def _references(raw: Any, folder: Path) -> tuple[tuple[str, ...], tuple[ReferenceSample, ...]]:
    if not isinstance(raw, list) or not raw:
        raise InvalidInput(
            "calibration.reference is missing; give [[calibration.reference]] with curve, young, poisson."
        )
    sources: list[str] = []
    references: list[ReferenceSample] = []
    for place, one in enumerate(raw):
        where = f"calibration.reference[{place}]"
        content = _section(one, UNITS["calibration.reference"], where)
        for key in ("curve", "young", "poisson"):
            if key not in content:
                raise InvalidInput(f"{where}.{key} is missing; give it.")
        files = _files(content.pop("curve"), folder, f"{where}.curve")
        sources += files
        references += [ReferenceSample(**content)] * len(files)
    return tuple(sources), tuple(references)


def _indenter(named: Any, raw: Any, folder: Path) -> CalibratedIndenter:
    if named and raw is not None:
        raise InvalidInput("the indenter is given twice; give indentation.indenter, a file, or the section [indenter].")
    if named:
        if not isinstance(named, str) or not (folder / named).is_file():
            raise InvalidInput(
                f"indentation.indenter is {named!r}; give the indenter.toml of a calibration, or a table of depth and "
                "area."
            )
        path = folder / named
        return read_indenter(path) if named.endswith(".toml") else CalibratedIndenter(read_area(path))
    if raw is None:
        raise InvalidInput(
            "there is no indenter; give indentation.indenter, a file, or [indenter] with its area function."
        )
    content = _section(raw, UNITS["indenter"], "indenter")
    stiffness = content.get("frame_stiffness", math.inf)
    if not stiffness > 0.0:
        raise InvalidInput(f"indenter.frame_stiffness is {stiffness:g} N/m; it must be positive.")
    area = _area(content, folder)
    solid = Elastic(content.get("young", DIAMOND.young), content.get("poisson", DIAMOND.poisson))
    return CalibratedIndenter(area, 1.0 / stiffness, solid=solid, shape_factor=content.get("shape_factor", 1.0))


def _area(content: dict[str, Any], folder: Path) -> CalibratedArea:
    """Return the area of a tip by its coefficients, or a file of it."""
    coefficients, header = content.get("area"), content.get("header", "")
    if not isinstance(header, str) or (header and not isinstance(coefficients, str)):
        raise InvalidInput(f"indenter.header is {header!r}; it names the columns of a file, which area gives.")
    if isinstance(coefficients, str):
        table = read_area(folder / coefficients, header)
        ends = content.get("shallowest", table.shallowest), content.get("deepest", table.deepest)
        return CalibratedArea(table.coefficients, *ends)
    if not isinstance(coefficients, list) or not coefficients:
        raise InvalidInput('indenter.area is missing; give a list C0, C1, ..., such as [24.5, "1.1 um"].')
    exponents = ["", "m", "m^1.5", "m^1.75", "m^1.875", "m^1.9375", "m^1.96875", "m^1.984375", "m^1.9921875"]
    if len(coefficients) > len(exponents):
        raise InvalidInput(f"indenter.area has {len(coefficients)} coefficients; give at most {len(exponents)}.")
    numbers = [
        float(quantities.read_at(f"indenter.area[{n}]", c, exponents[n], quantities.number))
        for n, c in enumerate(coefficients)
    ]
    return CalibratedArea(tuple(numbers), content.get("shallowest", 0.0), content.get("deepest", math.inf))


def _files(given: Any, folder: Path, where: str) -> tuple[str, ...]:
    """Return the files that a key names, in the order of their numbers."""
    if not isinstance(given, str) or not given:
        raise InvalidInput(f"{where} is {given!r}; give a file, a folder or a pattern from the study.")
    return curve_files(given, folder, where)
