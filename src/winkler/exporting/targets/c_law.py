"""A contact law as one C99 file without dependencies: translated kernels, tables, a state, and a test of itself."""

from __future__ import annotations

import textwrap
from typing import Any

import numpy as np

from winkler.exporting.step_law import SIZE_POWERS, StepLaw, StepNumber
from winkler.exporting.targets.c_example import TRACE_TOLERANCE, c_main
from winkler.exporting.targets.heading import heading_lines
from winkler.exporting.translation.c_writer import INCLUDES, c_source
from winkler.exporting.translation.translate import Translation
from winkler.exporting.translation.tree import BOOL, INT, REAL, Routine, TranslatedType, TranslationUnit, array_of

OWN_NAMES = frozenset({"begin", "step", "main"})
"""Functions that every file has."""
ITEMS = {"f": (REAL, "double"), "i": (INT, "int64_t"), "b": (BOOL, "bool")}


def translated_step(law: StepLaw) -> tuple[TranslationUnit, Routine]:
    """Return the kernel of a law, translated."""
    translation = Translation(OWN_NAMES)
    tables = [array_of(table.numbers.ndim) for table in law.tables]
    state = [array_of(part.begin.ndim, ITEMS[part.begin.dtype.kind][0]) for part in law.state]
    routine = translation.routine(law.kernel, (*tables, *state, array_of(1), array_of(1)))
    return translation.unit(routine), routine


def factors_of_size(law: StepLaw, size: str = "size") -> list[str]:
    """Return by what every answer of a law of all radii grows with the size of a pair, as text after it."""
    return ["".join(f" * {size}" for _ in range(SIZE_POWERS.get(one.unit, 0))) for one in law.answer]


def c_law(law: StepLaw, name: str, tolerance: float = TRACE_TOLERANCE) -> str:
    """Return the file; its functions and types begin with the name.

    Parameters
    ----------
    law : StepLaw
    name : str
        An identifier of C.
    tolerance : float
        To which its program compares the trace, over the greatest number of a column.
    """
    guard = f"{name.upper()}_H"
    use = [
        f'Use: #include "{name}.h"; {name}_begin(&state) before the first touch, {name}_step(&state, &motion, &answer)',
        "in every step. Each contact has its own state; nothing is shared, so that contacts may run in parallel.",
        "",
        f"Test: cc -x c -D{name.upper()}_MAIN {name}.h -o {name} -lm && ./{name}",
        "compares a trace of winkler with what this file computes; it returns 0 if they agree.",
    ]
    comment = "\n".join(f" * {line}".rstrip() for line in [*heading_lines(law), "", *use])
    parts = [
        f"/*\n{comment.replace('*/', '* /')}\n */",
        f"#ifndef {guard}\n#define {guard}\n\n{INCLUDES}#include <string.h>",
        *law_parts(law, name),
        f"#ifdef {name.upper()}_MAIN\n{c_main(law, name, tolerance)}\n#endif",
        "#endif",
    ]
    return "\n\n".join(parts) + "\n"


def law_parts(law: StepLaw, name: str) -> list[str]:
    """Return kernels, tables, structures and functions of a law."""
    unit, routine = translated_step(law)
    return [
        c_source(unit, f"{name}_in_").rstrip(),
        *(_table(f"{name}_{table.name}", table.meaning, table.numbers) for table in law.tables),
        _structures(law, name),
        _begin(law, name),
        _step(law, name, routine),
    ]


def numbers_of_c(numbers: np.ndarray[Any, Any]) -> str:
    """Return numbers to the last digit, in lines."""
    texts = ["NAN" if x != x else repr(float(x)) for x in np.ravel(numbers)]
    texts = [text.replace("-inf", "-INFINITY").replace("inf", "INFINITY") for text in texts]
    return "\n".join(textwrap.wrap(", ".join(texts), 110, initial_indent="    ", subsequent_indent="    "))


def _table(name: str, meaning: str, numbers: np.ndarray[Any, Any]) -> str:
    kept = numbers if numbers.size else np.zeros(1)  # C knows no array without elements
    return f"{_comment(meaning)}\nstatic const double {name}[{kept.size}] = {{\n{numbers_of_c(kept)}\n}};"


def _comment(text: str) -> str:
    return f"/* {text.replace('*/', '* /')} */"


def _members(quantities: tuple[StepNumber, ...]) -> str:
    return "\n".join(f"    double {one.name}; {_comment(f'[{one.unit}] {one.meaning}')}" for one in quantities)


def _structures(law: StepLaw, name: str) -> str:
    state = "\n".join(
        f"    {ITEMS[part.begin.dtype.kind][1]} {part.name}[{part.begin.size}]; {_comment(part.meaning)}"
        for part in law.state
    )
    state = state or "    unsigned char nothing; /* it has no memory */"
    return "\n\n".join(
        [
            f"/* What one contact remembers; copy it to save it. */\ntypedef struct {{\n{state}\n}} {name}_state;",
            f"/* What goes into a step. */\ntypedef struct {{\n{_members(law.motion)}\n}} {name}_motion;",
            f"/* What comes out of it. */\ntypedef struct {{\n{_members(law.answer)}\n}} {name}_answer;",
        ]
    )


def _begin(law: StepLaw, name: str) -> str:
    lines = ["    memset(state, 0, sizeof(*state));"]
    for part in law.state:
        for place in np.flatnonzero(part.begin.ravel()):
            number = part.begin.ravel()[place]
            text = numbers_of_c(np.array([float(number)])).strip()
            kind = "" if part.begin.dtype.kind == "f" else f"({ITEMS[part.begin.dtype.kind][1]})"
            lines.append(f"    state->{part.name}[{place}] = {kind}{text};")
    head = f"static inline void {name}_begin({name}_state *state) {{"
    return "\n".join(["/* Set a contact apart, as before the first touch. */", head, *lines, "}"])


def _step(law: StepLaw, name: str, routine: Routine) -> str:
    inner = f"{name}_in_"

    def view(kind: TranslatedType, pointer: str, shape: tuple[int, ...]) -> str:
        item = ITEMS[{"real": "f", "int": "i", "bool": "b"}[kind.item.kind]][1]
        sizes = ", ".join(map(str, shape))
        return f"{inner}make_{kind.item.kind}{kind.axes}(({item} *){pointer}, {sizes})"

    kinds = [kind for _, kind in routine.arguments]
    pointers = [(f"{name}_{table.name}", table.numbers.shape) for table in law.tables]
    pointers += [(f"state->{part.name}", part.begin.shape) for part in law.state]
    before, after = "", ""
    if law.every_radius:
        before, after = _sized(law, name)
        falling = {f"{name}_{table.name}" for table in law.tables if table.falling}
        pointers = [(f"own_{pointer}" if pointer in falling else pointer, shape) for pointer, shape in pointers]
        pointers += [("own_motion", (len(law.motion) - 1,)), ("own_answer", (len(law.answer),))]
    else:
        pointers += [("motion", (len(law.motion),)), ("answer", (len(law.answer),))]
    arguments = ",\n        ".join(view(kind, *pair) for kind, pair in zip(kinds, pointers, strict=True))
    return (
        f"/* Move a contact by one step. */\nstatic inline void {name}_step(\n"
        f"    {name}_state *state, const {name}_motion *motion, {name}_answer *answer) {{\n"
        f"{'' if law.state else '    (void)state;' + chr(10)}{before}"
        f"    {inner}{routine.name}(\n        {arguments});\n{after}}}"
    )


def _sized(law: StepLaw, name: str) -> tuple[str, str]:
    """Return what stands before and after the kernel of a law of all radii: to a pair that is alike, and back."""
    motion = [f"motion->{one.name}{' / size' if one.unit == 'm' else ''}" for one in law.motion[:-1]]
    before = [
        f"const double size = motion->{law.motion[-1].name} / {law.curvature_radius!r};",
        f"double own_motion[] = {{{', '.join(motion)}}}, own_answer[{len(law.answer)}];",
    ]
    for table in law.tables:
        if table.falling:
            own = f"{name}_{table.name}"
            before += [f"double own_{own}[{table.numbers.size}];", f"memcpy(own_{own}, {own}, sizeof({own}));"]
            before += [f"own_{own}[{k}] /= size;" for k in table.falling]
    after = [
        f"answer->{one.name} = own_answer[{k}]{factor};"
        for k, (one, factor) in enumerate(zip(law.answer, factors_of_size(law), strict=True))
    ]
    return "".join(f"    {line}\n" for line in before), "".join(f"    {line}\n" for line in after)
