"""A contact law as a functional mock-up unit (FMI 2.0 or 3.0, co-simulation): its source, and a binary."""

from __future__ import annotations

import io
import platform
import sys
import zipfile
from collections.abc import Mapping

from winkler.exporting.step_law import StepLaw
from winkler.exporting.targets.c_law import c_law
from winkler.exporting.targets.compilers import compiled_here, has_compiler
from winkler.exporting.targets.fmu3_description import build_description3, description3
from winkler.exporting.targets.fmu3_source import fmu3_source
from winkler.exporting.targets.fmu_description import description, unit_guid
from winkler.exporting.targets.fmu_source import fmu_source
from winkler.values.errors import InvalidInput

__all__ = ["fmu3_law", "fmu_law"]

SYSTEMS = {
    ("linux", "x86_64"): ("linux64", ".so"),
    ("win32", "amd64"): ("win64", ".dll"),
    ("darwin", "x86_64"): ("darwin64", ".dylib"),
}
"""Systems for which FMI 2.0 has a folder of binaries, and the ending of their libraries."""
SYSTEMS3 = {
    ("linux", "x86_64"): ("x86_64-linux", ".so"),
    ("linux", "aarch64"): ("aarch64-linux", ".so"),
    ("win32", "amd64"): ("x86_64-windows", ".dll"),
    ("darwin", "x86_64"): ("x86_64-darwin", ".dylib"),
    ("darwin", "arm64"): ("aarch64-darwin", ".dylib"),
}
"""The same for FMI 3.0."""
DATE = (2026, 1, 1, 0, 0, 0)
"""Of every file in the unit, so that the same law gives the same unit."""


def refuse_every_radius(law: StepLaw) -> None:
    """Refuse a law of all radii: a unit is one contact."""
    if law.every_radius:
        raise InvalidInput("export: a unit is one contact, of the R of the study; leave every-radius out.")


def fmu_law(law: StepLaw, name: str) -> dict[str, str | bytes]:
    """Return the unit of FMI 2; with a binary for the system here where a C compiler is at hand, else as source."""
    refuse_every_radius(law)
    header = c_law(law, name)
    guid = unit_guid(header)
    sources = {f"{name}.h": header, f"{name}_fmu.c": fmu_source(law, name, guid)}
    return {f"{name}.fmu": _unit(name, description(law, name, guid), sources, {}, SYSTEMS)}


def fmu3_law(law: StepLaw, name: str) -> dict[str, str | bytes]:
    """Return the unit of FMI 3, in the same way."""
    refuse_every_radius(law)
    header = c_law(law, name)
    token = unit_guid(header)
    sources = {f"{name}.h": header, f"{name}_fmu.c": fmu3_source(law, name, token)}
    extra = {"sources/buildDescription.xml": build_description3(name)}
    return {f"{name}_fmi3.fmu": _unit(name, description3(law, name, token), sources, extra, SYSTEMS3)}


def _unit(
    name: str,
    described: str,
    sources: Mapping[str, str],
    extra: Mapping[str, str],
    systems: Mapping[tuple[str, str], tuple[str, str]],
) -> bytes:
    """Return the archive."""
    contents: dict[str, str | bytes] = {"modelDescription.xml": described}
    contents |= {f"sources/{file}": text for file, text in sources.items()}
    contents |= extra
    folder, ending = systems.get((sys.platform, platform.machine().lower()), ("", ""))
    if folder and has_compiler():
        contents[f"binaries/{folder}/{name}{ending}"] = compiled_here(sources, name + ending)
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as unit:
        for file, content in contents.items():
            unit.writestr(zipfile.ZipInfo(file, DATE), content, zipfile.ZIP_DEFLATED)
    return archive.getvalue()
