"""A contact law as a functional mock-up unit (FMI 2.0, co-simulation): its source, and a binary."""

from __future__ import annotations

import io
import platform
import sys
import zipfile

from winkler.exporting.step_law import StepLaw
from winkler.exporting.targets.c_law import c_law
from winkler.exporting.targets.compilers import compiled_here, has_compiler
from winkler.exporting.targets.fmu_description import description, unit_guid
from winkler.exporting.targets.fmu_source import fmu_source

__all__ = ["fmu_law"]

SYSTEMS = {
    ("linux", "x86_64"): ("linux64", ".so"),
    ("win32", "amd64"): ("win64", ".dll"),
    ("darwin", "x86_64"): ("darwin64", ".dylib"),
}
"""Systems for which FMI 2.0 has a folder of binaries, and the ending of their libraries."""
DATE = (2026, 1, 1, 0, 0, 0)
"""Of every file in the unit, so that the same law gives the same unit."""


def fmu_law(law: StepLaw, name: str) -> dict[str, str | bytes]:
    """Return the unit; with a binary for the system here where a C compiler is at hand, else as source alone."""
    header = c_law(law, name)
    guid = unit_guid(header)
    sources = {f"{name}.h": header, f"{name}_fmu.c": fmu_source(law, name, guid)}
    contents: dict[str, str | bytes] = {"modelDescription.xml": description(law, name, guid)}
    contents |= {f"sources/{file}": text for file, text in sources.items()}
    folder, ending = SYSTEMS.get((sys.platform, platform.machine().lower()), ("", ""))
    if folder and has_compiler():
        contents[f"binaries/{folder}/{name}{ending}"] = compiled_here(sources, name + ending)
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as unit:
        for file, content in contents.items():
            unit.writestr(zipfile.ZipInfo(file, DATE), content, zipfile.ZIP_DEFLATED)
    return {f"{name}.fmu": archive.getvalue()}
