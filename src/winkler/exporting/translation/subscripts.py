"""Entries and parts of arrays and tuples, `x[i]`, `x[a:b]`, `x[i, a:b]`, with their types."""

from __future__ import annotations

import ast

from winkler.exporting.translation.functions import cast
from winkler.exporting.translation.subset import KernelSource
from winkler.exporting.translation.tree import INT, SLICE, Typed, array_of

__all__ = ["Subscripts"]


class Subscripts:
    """Builds expressions of subscripts.

    Parameters
    ----------
    source : KernelSource
    """

    def __init__(self, source: KernelSource) -> None:
        self.source = source

    def of(self, node: ast.expr) -> Typed:
        """Return the expression of a node."""
        raise NotImplementedError

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
