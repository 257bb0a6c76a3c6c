"""Expressions of a kernel with their types."""

from __future__ import annotations

import ast
import builtins
import math
from typing import Any, Protocol

import numpy as np

from winkler.exporting.translation.functions import SPECIAL, cast
from winkler.exporting.translation.subset import KernelSource, Translatable, is_translatable, of_type, unified
from winkler.exporting.translation.tree import (
    BOOL,
    INT,
    REAL,
    SLICE,
    Constant,
    Routine,
    TranslatedType,
    Typed,
    array_of,
    tuple_of,
)

ARITHMETIC: dict[type[ast.operator], str] = {
    ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.FloorDiv: "//", ast.Mod: "%", ast.Pow: "**",
    ast.BitAnd: "&", ast.BitOr: "|",
}  # fmt: skip
COMPARISONS: dict[type[ast.cmpop], str] = {
    ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "!=",
}  # fmt: skip
MODULES = (math, np)
LARGEST_ROOM = 4096
"""Numbers of an array of known size that stands on the stack."""
ITEM_TYPES = {"float64": REAL, "int64": INT, "bool_": BOOL}


class Library(Protocol):
    """What a routine needs of others."""

    def routine(self, kernel: Translatable, types: tuple[TranslatedType, ...], source: KernelSource) -> Routine:
        """Return the routine of another kernel."""

    def constant(self, name: str, module: str, type_: TranslatedType, numbers: tuple[float | int, ...]) -> Constant:
        """Return a constant of a module."""


class Expressions:
    """Builds expressions of one kernel.

    Parameters
    ----------
    source : KernelSource
    library : Library
    types : dict
        Name -> type of every variable so far.
    """

    def __init__(self, source: KernelSource, library: Library, types: dict[str, TranslatedType]) -> None:
        self.source, self.library, self.types = source, library, types
        self.loops = 0
        self.arrays_made = self.rooms = 0
        self.writes = False

    def of(self, node: ast.expr) -> Typed:
        """Return the expression of a node."""
        build = getattr(self, f"of_{type(node).__name__.lower()}", None)
        if build is None:
            raise self.source.refused(node, f"{type(node).__name__} is not translated")
        built: Typed = build(node)
        return built

    def of_constant(self, node: ast.Constant) -> Typed:
        """Return a literal."""
        kind = of_type(node.value)
        if kind is None:
            raise self.source.refused(node, f"{node.value!r} is no number")
        return Typed(kind, "number", repr(node.value))

    def of_name(self, node: ast.Name) -> Typed:
        """Return a variable, or what the module defines."""
        if node.id in self.types:
            return Typed(self.types[node.id], "name", node.id)
        if node.id not in self.source.names:
            raise self.source.refused(node, f"{node.id} is not defined")
        return self._global(node, node.id, self.source.names[node.id])

    def _global(self, node: ast.expr, name: str, found: Any) -> Typed:
        kind = of_type(found)
        module = self.source.kernel.__module__
        if kind is not None:
            if not math.isfinite(found) or name in dir(math):
                return Typed(REAL, "number", repr(float(found)))
            return Typed(kind, "constant", self.library.constant(name, module, kind, (found,)).name, (), found)
        if isinstance(found, np.ndarray | tuple) and np.ndim(found) == 1:
            numbers = np.asarray(found).tolist()
            kinds = {of_type(number) for number in numbers}
            if None not in kinds:
                item = REAL if REAL in kinds else INT
                constant = self.library.constant(name, module, array_of(1, item), tuple(numbers))
                return Typed(constant.type, "constant", constant.name, detail=len(numbers))
        raise self.source.refused(node, f"{name} is a {type(found).__name__}")

    def function_of(self, node: ast.expr) -> Any:
        """Return the Python function that a node names, or None."""
        if isinstance(node, ast.Name) and node.id not in self.types:
            return self.source.names.get(node.id, getattr(builtins, node.id, None))
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            module = self.source.names.get(node.value.id)
            if any(module is known for known in MODULES):
                return getattr(module, node.attr, None)
        return None

    def of_attribute(self, node: ast.Attribute) -> Typed:
        """Return a number of a module, or the size or shape of an array."""
        found = self.function_of(node)
        if found is not None and of_type(found) is not None:
            return Typed(REAL, "number", repr(float(found)))
        held = self.of(node.value)
        if held.type.kind == "array":
            axes = range(held.type.axes)
            sizes = tuple(Typed(INT, "size", parts=(held,), detail=axis) for axis in axes)
            if node.attr == "shape":
                return Typed(tuple_of(*(INT for _ in axes)), "tuple", parts=sizes)
            if node.attr == "size":
                product = sizes[0]
                for other in sizes[1:]:
                    product = Typed(INT, "binary", "*", (product, other))
                return product
        raise self.source.refused(node, f".{node.attr} of {held.type} is not translated")

    def of_tuple(self, node: ast.Tuple) -> Typed:
        """Return a tuple."""
        parts = tuple(self.of(part) for part in node.elts)
        return Typed(tuple_of(*(part.type for part in parts)), "tuple", parts=parts)

    def of_subscript(self, node: ast.Subscript) -> Typed:
        """Return an entry of an array or tuple, or a part of an array."""
        held = self.of(node.value)
        if held.type.kind == "tuple":
            return self._part(node, held)
        if held.type.kind != "array":
            raise self.source.refused(node, f"an entry of {held.type}")
        indices = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
        if len(indices) > held.type.axes:
            raise self.source.refused(node, f"{len(indices)} indices of {held.type}")
        parts: list[Typed] = []
        pattern = ""
        for axis, index in enumerate(indices):
            size = Typed(INT, "size", parts=(held,), detail=axis)
            if isinstance(index, ast.Slice):
                parts.append(self._slice(index, size))
                pattern += "s"
                continue
            place = self.of(index)
            if place.type == SLICE:
                parts.append(place)
                pattern += "s"
            elif place.type == INT:
                parts.append(self._from_end(index, place, size))
                pattern += "i"
            else:
                raise self.source.refused(node, f"an index that is {place.type}")
        missing = held.type.axes - len(indices)
        pattern += "a" * missing
        if pattern.count("i") == held.type.axes:
            return Typed(held.type.item, "item", parts=(held, *parts))
        if pattern[-1] == "i":
            raise self.source.refused(node, "a part of an array whose entries do not lie side by side")
        left = held.type.axes - pattern.count("i")
        return Typed(array_of(left, held.type.item), "view", pattern, (held, *parts))

    def _part(self, node: ast.Subscript, held: Typed) -> Typed:
        index = node.slice
        count = len(held.type.parts)
        if isinstance(index, ast.Constant) and isinstance(index.value, int) and 0 <= index.value < count:
            if held.form == "tuple":
                part: Typed = held.parts[index.value]
                return part
            return Typed(held.type.parts[index.value], "part", parts=(held,), detail=index.value)
        alike = all(part == held.type.parts[0] for part in held.type.parts) and held.type.parts[0].is_number
        place = self.of(index) if alike and not isinstance(index, ast.Slice) else None
        if place is None or place.type != INT:
            raise self.source.refused(node, f"an entry of {held.type} by something else than a literal")
        chosen = Typed(held.type.parts[0], "part", parts=(held,), detail=count - 1)
        for k in range(count - 2, -1, -1):
            here = Typed(INT, "compare", "==", (place, Typed(INT, "number", str(k))))
            part_k = Typed(held.type.parts[0], "part", parts=(held,), detail=k)
            chosen = Typed(chosen.type, "choose", parts=(here, part_k, chosen))
        return chosen

    def _slice(self, node: ast.Slice, size: Typed) -> Typed:
        if node.step is not None:
            raise self.source.refused(node, "a slice with a step is not translated")
        ends = []
        for end, default in ((node.lower, Typed(INT, "number", "0")), (node.upper, size)):
            if end is None:
                ends.append(default)
                continue
            place = self.of(end)
            if not place.type.is_number:
                raise self.source.refused(node, f"a slice that ends at {place.type}")
            ends.append(self._from_end(end, cast(place, INT), size))
        return Typed(SLICE, "slice", parts=tuple(ends))

    def _from_end(self, node: ast.expr, place: Typed, size: Typed) -> Typed:
        """Return an index, from the end where it is a negative literal."""
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub) and isinstance(node.operand, ast.Constant):
            return Typed(INT, "binary", "+", (size, place))
        return place

    def of_unaryop(self, node: ast.UnaryOp) -> Typed:
        """Return - x or not x."""
        held = self.of(node.operand)
        if not held.type.is_number:
            raise self.source.refused(node, f"an operation on {held.type}")
        if isinstance(node.op, ast.Not):
            return Typed(BOOL, "unary", "!", (held,))
        if isinstance(node.op, ast.USub):
            return Typed(REAL if held.type == REAL else INT, "unary", "-", (held,))
        raise self.source.refused(node, f"{type(node.op).__name__} is not translated")

    def of_binop(self, node: ast.BinOp) -> Typed:
        """Return arithmetic of two numbers."""
        one, other = self.of(node.left), self.of(node.right)
        sign = ARITHMETIC.get(type(node.op))
        if sign is None or not (one.type.is_number and other.type.is_number):
            raise self.source.refused(
                node, f"{type(node.op).__name__} of {one.type} and {other.type} is not translated"
            )
        if sign in ("&", "|"):
            if not (one.type == other.type == BOOL):
                raise self.source.refused(node, f"{sign} of {one.type} and {other.type} is not translated")
            return Typed(BOOL, "binary", sign, (one, other))
        real = REAL in (one.type, other.type) or sign == "/"
        if sign == "**":
            if other.form == "number" and other.text == "2" and real:
                return Typed(REAL, "function", "square", (one,))
            return Typed(REAL, "function", "pow", (cast(one, REAL), cast(other, REAL)))
        wanted = REAL if real else INT
        if sign in ("//", "%"):
            name = {"//": "floor_div", "%": "modulo"}[sign]
            return Typed(wanted, "function", f"{name}_{wanted.kind}", (cast(one, wanted), cast(other, wanted)))
        return Typed(wanted, "binary", sign, (cast(one, wanted), cast(other, wanted)))

    def truth(self, node: ast.expr) -> Typed:
        """Return a condition."""
        held = self.of(node)
        if held.type == BOOL:
            return held
        if not held.type.is_number:
            raise self.source.refused(node, f"a condition on {held.type}")
        nothing = Typed(held.type, "number", "0" if held.type == INT else "0.0")
        return Typed(BOOL, "compare", "!=", (held, nothing))

    def of_boolop(self, node: ast.BoolOp) -> Typed:
        """Return a condition of conditions."""
        sign = "&&" if isinstance(node.op, ast.And) else "||"
        found = self.truth(node.values[0])
        for part in node.values[1:]:
            found = Typed(BOOL, "binary", sign, (found, self.truth(part)))
        return found

    def of_compare(self, node: ast.Compare) -> Typed:
        """Return a comparison, or a chain of them."""
        found: Typed | None = None
        left = node.left
        for operator, right in zip(node.ops, node.comparators, strict=True):
            if isinstance(operator, ast.In) and isinstance(right, ast.Tuple):
                link = self._compared(node, "==", left, right.elts[0])
                for other in right.elts[1:]:
                    link = Typed(BOOL, "binary", "||", (link, self._compared(node, "==", left, other)))
            elif type(operator) in COMPARISONS:
                link = self._compared(node, COMPARISONS[type(operator)], left, right)
            else:
                raise self.source.refused(node, f"{type(operator).__name__} is not translated")
            found = link if found is None else Typed(BOOL, "binary", "&&", (found, link))
            left = right
        assert found is not None
        return found

    def _compared(self, node: ast.expr, sign: str, left: ast.expr, right: ast.expr) -> Typed:
        one, other = self.of(left), self.of(right)
        wanted = unified(one.type, other.type)
        if wanted is None or not wanted.is_number:
            raise self.source.refused(node, f"a comparison of {one.type} and {other.type}")
        return Typed(BOOL, "compare", sign, (cast(one, wanted), cast(other, wanted)))

    def of_ifexp(self, node: ast.IfExp) -> Typed:
        """Return one of two."""
        one, other = self.of(node.body), self.of(node.orelse)
        wanted = unified(one.type, other.type)
        if wanted is None:
            raise self.source.refused(node, f"either {one.type} or {other.type}")
        return Typed(wanted, "choose", parts=(self.truth(node.test), cast(one, wanted), cast(other, wanted)))

    def of_call(self, node: ast.Call) -> Typed:
        """Return a call of a function or of another kernel."""
        called = self.function_of(node.func)
        if node.keywords or any(isinstance(part, ast.Starred) for part in node.args):
            raise self.source.refused(node, "arguments by name are not translated")
        if called is None and isinstance(node.func, ast.Attribute) and node.func.attr in ("min", "max", "sum"):
            called, arguments = getattr(np, node.func.attr), [self.of(node.func.value)]
        elif called in (np.empty, np.zeros):
            return self._new(node)
        else:
            arguments = [self.of(part) for part in node.args]
        if is_translatable(called):
            routine = self.library.routine(called, tuple(part.type for part in arguments), self.source)
            self.writes = self.writes or routine.writes
            wanted = (kind for _, kind in routine.arguments)
            parts = tuple(cast(*pair) for pair in zip(arguments, wanted, strict=True))
            return Typed(routine.result, "call", routine.name, parts, routine)
        if called is slice and len(arguments) == 2:
            return Typed(SLICE, "slice", parts=tuple(cast(part, INT) for part in arguments))
        build = SPECIAL.get(called) if called is not None and called.__hash__ is not None else None
        found = build(arguments) if build is not None else None
        if found is None:
            types = ", ".join(str(part.type) for part in arguments)
            raise self.source.refused(node, f"{ast.unparse(node.func)} of ({types}) is not translated")
        return found

    def _new(self, node: ast.Call) -> Typed:
        if self.loops:
            raise self.source.refused(node, "an array is made within a loop")
        shape = self.of(node.args[0])
        sizes = shape.parts if shape.form == "tuple" else (shape,)
        item = REAL
        if len(node.args) > 1:
            kind = node.args[1]
            item = ITEM_TYPES.get(kind.attr if isinstance(kind, ast.Attribute) else "", SLICE)
            if item == SLICE:
                raise self.source.refused(node, "an array of this type is not translated")
        if any(size.type != INT for size in sizes):
            raise self.source.refused(node, "the size of an array is no whole number")
        zeros = "zeros" if self.function_of(node.func) is np.zeros else ""
        known = [_known(size) for size in sizes]
        if 0 < math.prod(known) <= LARGEST_ROOM:
            self.rooms += 1
            return Typed(array_of(len(sizes), item), "room", zeros, tuple(sizes), (self.rooms, math.prod(known)))
        self.arrays_made += 1
        return Typed(array_of(len(sizes), item), "new", zeros, tuple(sizes), self.arrays_made - 1)


def _known(size: Typed) -> int:
    """Return a size that is known beforehand, else zero."""
    if size.form == "number":
        return int(size.text)
    return int(size.detail) if size.form == "constant" else 0
