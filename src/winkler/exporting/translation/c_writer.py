"""Routines in C99, which is also C++: static functions behind one prefix, with no other library than C's own."""

from __future__ import annotations

import textwrap

from winkler.exporting.translation.c_helpers import FUNCTIONS, RESERVED, c_type, helper, type_name, view_helper
from winkler.exporting.translation.subset import source_of
from winkler.exporting.translation.tree import (
    INT,
    REAL,
    SLICE,
    VOID,
    Constant,
    Routine,
    Statement,
    TranslatedType,
    TranslationUnit,
    Typed,
    array_of,
)

LEVELS = {"*": 4, "/": 4, "+": 3, "-": 3, "<": 1, "<=": 1, ">": 1, ">=": 1, "==": 1, "!=": 1}
"""How closely operators bind, as far as everybody knows."""
UNARY_LEVEL = 6
LITERALS = {"nan": "NAN", "inf": "INFINITY", "-inf": "(-INFINITY)", "True": "true", "False": "false"}


class CRoutines:
    """Writes routines with their expressions, and notes which helpers they need.

    Parameters
    ----------
    prefix : str
        With which every name of the file begins.
    """

    def __init__(self, prefix: str) -> None:
        self.prefix = prefix
        self.types: dict[TranslatedType, None] = {}
        self.functions: dict[str, None] = {}
        self.views: dict[tuple[TranslatedType, str], None] = {}
        self.rooms: dict[int, str] = {}
        self.loops = 0
        self.made = 0
        self.result = VOID

    def type(self, kind: TranslatedType) -> str:
        """Return a type in C."""
        self.note(kind)
        return c_type(kind, self.prefix)

    def note(self, kind: TranslatedType) -> None:
        """Note a type, those of its parts before it."""
        if kind.kind == "tuple":
            for part in kind.parts:
                self.note(part)
        if kind.kind in ("tuple", "array", "slice"):
            self.types.setdefault(kind)

    def variable(self, name: str) -> str:
        """Return the name of a variable."""
        return f"{name}_" if name in RESERVED else name

    def of(self, part: Typed) -> str:
        """Return an expression in C."""
        text: str = getattr(self, f"of_{part.form}")(part)
        return text

    def of_number(self, part: Typed) -> str:
        """Return a literal."""
        return LITERALS.get(part.text, part.text)

    def of_name(self, part: Typed) -> str:
        """Return a variable."""
        return self.variable(part.text)

    def of_constant(self, part: Typed) -> str:
        """Return a constant, or a row of them."""
        name = f"{self.prefix}{part.text}"
        if part.type.kind != "array":
            return name
        self.note(part.type)
        item = c_type(part.type.item, self.prefix)
        return f"{self.prefix}make_{type_name(part.type)}(({item} *){name}, {part.detail})"

    def of_unary(self, part: Typed) -> str:
        """Return - x or not x."""
        return part.text + self._inner_text(part.parts[0], UNARY_LEVEL)

    def of_binary(self, part: Typed) -> str:
        """Return x o y; with brackets where C, or a reader, would take it for something else."""
        level = LEVELS.get(part.text)
        first, second = (level, level + 1) if level else (1, 1) if part.text in ("&&", "||") else (5, 5)
        return f"{self._inner_text(part.parts[0], first)} {part.text} {self._inner_text(part.parts[1], second)}"

    of_compare = of_binary

    def of_choose(self, part: Typed) -> str:
        """Return one of two."""
        test, one, other = (self._inner_text(inner, 1) for inner in part.parts)
        return f"{test} ? {one} : {other}"

    def _inner_text(self, part: Typed, level: int) -> str:
        """Return an expression, in brackets unless it binds as closely as a level."""
        text = self.of(part)
        if part.form in ("binary", "compare"):
            own = LEVELS.get(part.text, 0)
        elif part.form == "choose" or (part.form == "number" and text[0] == "-"):
            own = 0
        else:
            own = UNARY_LEVEL
        return text if own >= level and own > 0 else f"({text})"

    def of_cast(self, part: Typed) -> str:
        """Return another type of number."""
        if part.type.kind == "tuple":
            held = part.parts[0]
            entries = [
                Typed(kind, "cast", parts=(Typed(held.type.parts[k], "part", parts=(held,), detail=k),))
                for k, kind in enumerate(part.type.parts)
            ]
            return self.of(Typed(part.type, "tuple", parts=tuple(entries)))
        if part.parts[0].type == part.type:
            return self.of(part.parts[0])
        return f"({self.type(part.type)})({self.of(part.parts[0])})"

    def of_call(self, part: Typed) -> str:
        """Return a call of a routine."""
        return f"{self.prefix}{part.text}({', '.join(map(self.of, part.parts))})"

    def of_function(self, part: Typed) -> str:
        """Return a call of a function of C or of a helper."""
        name = part.text
        if name in FUNCTIONS:
            self.functions.setdefault(name)
            if name.startswith("row_"):
                self.note(array_of(1))
            name = self.prefix + name
        return f"{name}({', '.join(map(self.of, part.parts))})"

    def of_item(self, part: Typed) -> str:
        """Return an entry of an array."""
        held, *indices = part.parts
        if held.form == "constant":
            return f"{self.prefix}{held.text}[{self.of(indices[0])}]"
        array = self.of(held)
        axes = held.type.axes
        places = [f"{self._inner_text(index, 4)} * {array}.stride[{k}]" for k, index in enumerate(indices[:-1])]
        assert len(indices) == axes
        return f"{array}.data[{' + '.join([*places, self._inner_text(indices[-1], 3)])}]"

    def of_view(self, part: Typed) -> str:
        """Return a part of an array."""
        held, *indices = part.parts
        self.note(part.type)
        self.note(held.type)
        if "s" in part.text:
            self.note(SLICE)
        self.views.setdefault((held.type, part.text))
        name = f"{self.prefix}view_{part.text}_{held.type.item.kind}"
        return f"{name}({', '.join([self.of(held), *map(self.of, indices)])})"

    def of_size(self, part: Typed) -> str:
        """Return how long an axis is."""
        held = part.parts[0]
        if held.form == "constant":
            return str(held.detail)
        return f"{self.of(held)}.size[{part.detail}]"

    def of_slice(self, part: Typed) -> str:
        """Return from where to where."""
        self.note(SLICE)
        return f"{self.prefix}make_slice({', '.join(map(self.of, part.parts))})"

    def of_tuple(self, part: Typed) -> str:
        """Return a tuple."""
        self.note(part.type)
        return f"{self.prefix}make_{type_name(part.type)}({', '.join(map(self.of, part.parts))})"

    def of_part(self, part: Typed) -> str:
        """Return an entry of a tuple."""
        return f"{self.of(part.parts[0])}.v{part.detail}"

    def of_room(self, part: Typed) -> str:
        """Return an array of known size, which stands on the stack."""
        self.note(part.type)
        index, count = part.detail
        item = c_type(part.type.item, self.prefix)
        self.rooms[index] = f"{item} room_{index}[{count}]{' = {0}' if part.text else ''};"
        sizes = ", ".join(map(self.of, part.parts))
        return f"{self.prefix}make_{type_name(part.type)}(room_{index}, {sizes})"

    def of_new(self, part: Typed) -> str:
        """Return an array that is made, and freed at the end of the routine."""
        self.note(part.type)
        self.functions.setdefault("new")
        sizes = [self.of(size) for size in part.parts]
        item = c_type(part.type.item, self.prefix)
        count = " * ".join(self._inner_text(size, 5) for size in part.parts)
        made = f"({item} *)(made[{part.detail}] = {self.prefix}new({count}, sizeof({item})))"
        return f"{self.prefix}make_{type_name(part.type)}({', '.join([made, *sizes])})"

    def routine(self, routine: Routine) -> str:
        """Return a routine."""
        self.loops, self.made, self.result = 0, routine.arrays_made, routine.result
        self.rooms = {}
        takes = ", ".join(f"{self.type(kind)} {self.variable(name)}" for name, kind in routine.arguments)
        lines = [f"static inline {self.type(routine.result)} {self.prefix}{routine.name}({takes or 'void'}) {{"]
        for name, kind in sorted(routine.variables.items()):
            zero = " = 0" if kind.is_number else ""
            lines.append(f"    {self.type(kind)} {self.variable(name)}{zero};")
        if self.made:
            lines.append(f"    void *made[{self.made}] = {{0}};")
        body = self._block(routine.body, 1)
        lines += [f"    {self.rooms[index]}" for index in sorted(self.rooms)] + body
        if self.made and (not routine.body or routine.body[-1].form != "return"):
            lines += [f"    {line}" for line in self._released()]
        if routine.result != VOID and routine.body[-1].form not in ("return",):
            lines.append("    abort();")
        source = source_of(routine.kernel)
        comment = "\n".join(f" * {line}".rstrip() for line in source.doc.replace("*/", "* /").splitlines())
        place = f" * From {source.file}, line {source.definition.lineno}."
        return "\n".join([f"/*\n{comment}\n{place}\n */", *lines, "}"])

    def _block(self, statements: tuple[Statement, ...], depth: int) -> list[str]:
        lines: list[str] = []
        for statement in statements:
            lines += [f"{'    ' * depth}{line}" for line in getattr(self, f"do_{statement.form}")(statement)]
        return lines

    def _inner(self, statements: tuple[Statement, ...]) -> list[str]:
        return self._block(statements, 1)

    def do_assign(self, done: Statement) -> list[str]:
        """Assign to a variable."""
        return [f"{self.variable(done.name)} = {self.of(done.parts[0])};"]

    def do_store(self, done: Statement) -> list[str]:
        """Assign to an entry."""
        return [f"{self.of(done.parts[0])} = {self.of(done.parts[1])};"]

    def do_do(self, done: Statement) -> list[str]:
        """Call a routine."""
        return [f"{self.of(done.parts[0])};"]

    def do_fill(self, done: Statement) -> list[str]:
        """Assign to all entries of a part of an array."""
        place, held = done.parts
        self.loops += 1
        k, own = self.loops, self.type(place.type)
        lines = [f"{own} part_{k} = {self.of(place)};"]
        row = held.type.kind == "array"
        value = f"from_{k}.data[k0]" if row else f"value_{k}"
        lines.append(f"{self.type(held.type)} {'from' if row else 'value'}_{k} = {self.of(held)};")
        axes = place.type.axes
        for axis in range(axes):
            lines.append(f"for (int64_t k{axis} = 0; k{axis} < part_{k}.size[{axis}]; ++k{axis})")
        index = " + ".join([*(f"k{axis} * part_{k}.stride[{axis}]" for axis in range(axes - 1)), f"k{axes - 1}"])
        lines.append(f"    part_{k}.data[{index}] = {value};")
        return ["{", *(f"    {line}" for line in lines), "}"]

    def do_if(self, done: Statement) -> list[str]:
        """Do one or the other."""
        lines = [f"if ({self.of(done.parts[0])}) {{", *self._inner(done.bodies[0])]
        other = done.bodies[1]
        if len(other) == 1 and other[0].form == "if":
            first, *rest = self.do_if(other[0])
            return [*lines, f"}} else {first}", *rest]
        return [*lines, *(["} else {", *self._inner(other)] if other else []), "}"]

    def do_while(self, done: Statement) -> list[str]:
        """Repeat while a condition holds."""
        return [f"while ({self.of(done.parts[0])}) {{", *self._inner(done.bodies[0]), "}"]

    def do_range(self, done: Statement) -> list[str]:
        """Count."""
        self.loops += 1
        k = self.loops
        start, stop, step = map(self.of, done.parts)
        sign, size = (">", step) if step[0] == "-" else ("<", f"+{step}")
        change = {"+1": f"++at_{k}", "-1": f"--at_{k}"}.get(size, f"at_{k} += {step}")
        first = [f"    {self.variable(done.name)} = at_{k};"] if done.name else []
        return [
            f"for (int64_t at_{k} = {start}, stop_{k} = {stop}; at_{k} {sign} stop_{k}; {change}) {{",
            *first,
            *self._inner(done.bodies[0]),
            "}",
        ]

    def do_items(self, done: Statement) -> list[str]:
        """Go through numbers."""
        self.loops += 1
        k = self.loops
        name = self.variable(done.name)
        if done.comment == "numbers":
            kind = c_type(done.parts[0].type, self.prefix)
            numbers, count = ", ".join(map(self.of, done.parts)), str(len(done.parts))
            lines = [f"const {kind} row_{k}[{count}] = {{{numbers}}};"]
            entry = f"row_{k}[at_{k}]"
        else:
            lines = [f"const {self.type(done.parts[0].type)} row_{k} = {self.of(done.parts[0])};"]
            count, entry = f"row_{k}.size[0]", f"row_{k}.data[at_{k}]"
        lines.append(f"for (int64_t at_{k} = 0; at_{k} < {count}; ++at_{k}) {{")
        lines += [f"    {name} = {entry};", *self._inner(done.bodies[0]), "}"]
        return ["{", *(f"    {line}" for line in lines), "}"]

    def do_break(self, done: Statement) -> list[str]:
        """Leave a loop."""
        return ["break;"]

    def do_continue(self, done: Statement) -> list[str]:
        """Go on with a loop."""
        return ["continue;"]

    def do_return(self, done: Statement) -> list[str]:
        """Return, what was made being freed."""
        if not self.made:
            return [f"return {self.of(done.parts[0])};" if done.parts else "return;"]
        released = self._released()
        if not done.parts:
            return ["{", *(f"    {line}" for line in released), "    return;", "}"]
        kept = f"    {self.type(self.result)} result_ = {self.of(done.parts[0])};"
        return ["{", kept, *(f"    {line}" for line in released), "    return result_;", "}"]

    def _released(self) -> list[str]:
        return [f"for (int k = 0; k < {self.made}; ++k) free(made[k]);"]


def numbers_text(kind: TranslatedType, numbers: tuple[float | int, ...]) -> str:
    """Return literals of numbers, the last digit included."""
    number = REAL if kind in (REAL, array_of(1)) else INT
    texts = [repr(float(x)) if number == REAL else repr(int(x)) for x in numbers]
    return ", ".join(LITERALS.get(text, text) for text in texts)


INCLUDES = "#include <math.h>\n#include <stdbool.h>\n#include <stdint.h>\n#include <stdlib.h>\n"


def c_source(unit: TranslationUnit, prefix: str = "") -> str:
    """Return the definitions of a unit, without includes.

    Parameters
    ----------
    unit : TranslationUnit
    prefix : str, optional
        With which every name of the file begins.
    """
    writer = CRoutines(prefix)
    routines = [writer.routine(routine) for routine in unit.routines]
    helpers = [helper(kind, prefix) for kind in writer.types]
    helpers += [view_helper(kind, pattern, prefix) for kind, pattern in writer.views]
    row = f"{prefix}real1"
    helpers += [FUNCTIONS[name].format(p=prefix, row=row) for name in writer.functions]
    constants = [_constant(constant, prefix) for constant in unit.constants]
    return "\n\n".join([*helpers, "\n".join(constants), *routines]).replace("\n\n\n\n", "\n\n") + "\n"


def _constant(constant: Constant, prefix: str) -> str:
    item = "double" if "real" in (constant.type.kind, *(part.kind for part in constant.type.parts)) else "int64_t"
    numbers = numbers_text(constant.type, constant.numbers)
    if constant.type.kind != "array":
        return f"static const {item} {prefix}{constant.name} = {numbers};"
    rows = "\n".join(textwrap.wrap(numbers, 110, initial_indent="    ", subsequent_indent="    "))
    return f"static const {item} {prefix}{constant.name}[{len(constant.numbers)}] = {{\n{rows}\n}};"
