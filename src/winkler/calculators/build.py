"""Make the kernels of the calculators: translated to C, compiled to WebAssembly, and kept beside this file.

``python -m winkler.calculators.build`` does it anew; it needs the compiler of ``pip install winkler[export]`` and a
minute or two.  What is kept says of which source and which numbers it was made.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from winkler.calculators import kernels, series, tables
from winkler.calculators.catalogue import CALCULATORS
from winkler.exporting.targets.c_law import numbers_of_c
from winkler.exporting.translation.c_writer import INCLUDES, c_source
from winkler.exporting.translation.translate import Translation
from winkler.exporting.translation.tree import Routine, array_of
from winkler.numerics.types import Array

__all__ = ["MODULE", "MOST", "STAMP", "TABLE_FILE", "c_of_calculators", "digest_of_files", "made_of"]

HERE = Path(__file__).parent / "page"
MODULE, TABLE_FILE, STAMP = HERE / "calculators.wasm", HERE / "tables.npz", HERE / "calculators.sha256"
OPTIONS = ("-mexec-model=reactor", "-Wl,--strip-all")
INNER = "in_"
MOST = 16
"""Most sliders or numbers of a calculator."""


def made_of() -> str:
    """Return the digest of all from which the module is made: kernels, tables, and the sliders that fix their order."""
    digest = hashlib.sha256()
    for module in (kernels, series, tables):
        digest.update(Path(str(module.__file__)).read_bytes().replace(b"\r\n", b"\n"))
    for one in CALCULATORS:
        digest.update(repr((one.name, [s.name for s in one.sliders], [n.name for n in one.numbers])).encode())
    return digest.hexdigest()


def digest_of_files() -> str:
    """Return the digest of what is kept: the module and the tables."""
    return hashlib.sha256(MODULE.read_bytes() + TABLE_FILE.read_bytes()).hexdigest()


def c_of_calculators(numbers: Mapping[str, Mapping[str, Array]]) -> str:
    """Return one file in C with all kernels and their tables.

    Parameters
    ----------
    numbers : mapping
        Calculator -> name -> table.
    """
    translation, entries, glue = Translation(), [], []
    for one in CALCULATORS:
        mine = numbers[one.name]
        routine = translation.routine(one.kernel, (array_of(1),) * (len(mine) + 2))
        entries.append(routine)
        glue.append(_entry(one.name, routine, mine))
    source = c_source(translation.unit(*entries), INNER)
    head = (
        "/* Kernels of winkler's calculators; numbers go in and out by two arrays. */\n"
        "#define EXPORTED(name) __attribute__((export_name(name)))\n"
        f"static double given[{MOST}], found[{MOST}];\n"
        'EXPORTED("given") double *given_at(void) { return given; }\n'
        'EXPORTED("found") double *found_at(void) { return found; }\n'
    )
    return "\n".join([INCLUDES, source, head, *glue])


def _entry(name: str, routine: Routine, numbers: Mapping[str, Array]) -> str:
    """Return the tables of one calculator, and the function that is called from outside."""
    parts = [
        f"static const double {name}_{key}[{table.size}] = {{\n{numbers_of_c(table)}\n}};"
        for key, table in numbers.items()
    ]
    views = [f"{INNER}make_real1((double *){name}_{key}, {table.size})" for key, table in numbers.items()]
    passed = ",\n    ".join([f"{INNER}make_real1(given, {MOST})", *views, f"{INNER}make_real1(found, {MOST})"])
    parts.append(f'EXPORTED("{name}") void run_{name}(void) {{\n    {INNER}{routine.name}({passed});\n}}')
    return "\n".join(parts)


def main() -> None:
    """Make the module, and note of what."""
    from winkler.exporting.targets.compilers import compiled_by_zig

    numbers = {name: {key: np.asarray(table) for key, table in made().items()} for name, made in tables.TABLES.items()}
    module = compiled_by_zig({"calculators.c": c_of_calculators(numbers)}, "wasm32-wasi", OPTIONS, "calculators.wasm")
    MODULE.write_bytes(module)
    named = {f"{name}.{key}": table for name, mine in numbers.items() for key, table in mine.items()}
    np.savez_compressed(TABLE_FILE, **named)  # type: ignore[arg-type]
    STAMP.write_text(f"{made_of()}\n{digest_of_files()}\n", encoding="ascii")


if __name__ == "__main__":
    main()
