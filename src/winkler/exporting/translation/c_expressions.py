"""Expressions in C."""

from __future__ import annotations

from winkler.exporting.translation.c_helpers import FUNCTIONS, RESERVED, c_type, type_name
from winkler.exporting.translation.tree import INT, REAL, SLICE, TranslatedType, Typed, array_of

__all__ = ["CExpressions"]

LEVELS = {"*": 4, "/": 4, "+": 3, "-": 3, "<": 1, "<=": 1, ">": 1, ">=": 1, "==": 1, "!=": 1}
"""How closely operators bind, as far as everybody knows."""
UNARY_LEVEL = 6
LITERALS = {"nan": "NAN", "inf": "INFINITY", "-inf": "(-INFINITY)", "True": "true", "False": "false"}


class CExpressions:
    """Writes expressions, and notes which helpers they need.

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


def numbers_text(kind: TranslatedType, numbers: tuple[float | int, ...]) -> str:
    """Return literals of numbers, the last digit included."""
    number = REAL if kind in (REAL, array_of(1)) else INT
    texts = [repr(float(x)) if number == REAL else repr(int(x)) for x in numbers]
    return ", ".join(LITERALS.get(text, text) for text in texts)
