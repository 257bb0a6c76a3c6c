"""Statements of a kernel: built again and again until the types of its variables no longer change."""

from __future__ import annotations

import ast

from winkler.exporting.translation.expressions import Expressions, Library
from winkler.exporting.translation.functions import cast
from winkler.exporting.translation.subset import KernelSource, unified
from winkler.exporting.translation.tree import BOOL, INT, VOID, Statement, TranslatedType, Typed

NOWHERE = "_"
"""The name of what is not needed."""


class Statements(Expressions):
    """Builds the statements of one kernel.

    Parameters
    ----------
    source, library, types
        As in `Expressions`.
    """

    def __init__(self, source: KernelSource, library: Library, types: dict[str, TranslatedType]) -> None:
        super().__init__(source, library, types)
        self.result: TranslatedType | None = None
        self.temporary = 0

    def block(self, nodes: list[ast.stmt]) -> tuple[Statement, ...]:
        """Return the statements of nodes."""
        done: list[Statement] = []
        for node in nodes:
            build = getattr(self, f"do_{type(node).__name__.lower()}", None)
            if build is None:
                raise self.source.refused(node, f"{type(node).__name__} is not translated")
            done += build(node)
        return tuple(done)

    def assigned(self, node: ast.AST, name: str, kind: TranslatedType) -> TranslatedType:
        """Note that a variable holds a type; return what it holds altogether."""
        if kind == VOID:
            raise self.source.refused(node, f"{name} is what returns nothing")
        found = unified(self.types.get(name, kind), kind)
        if found is None:
            raise self.source.refused(node, f"{name} is {self.types[name]} here and {kind} there")
        self.types[name] = found
        return found

    def do_pass(self, node: ast.Pass) -> list[Statement]:
        """Do nothing."""
        return []

    def do_break(self, node: ast.Break) -> list[Statement]:
        """Leave a loop."""
        return [Statement("break")]

    def do_continue(self, node: ast.Continue) -> list[Statement]:
        """Go on with a loop."""
        return [Statement("continue")]

    def do_expr(self, node: ast.Expr) -> list[Statement]:
        """Call a kernel for what it does."""
        if isinstance(node.value, ast.Constant) and isinstance(node.value.value, str):
            return []
        called = self.of(node.value)
        if called.form != "call":
            raise self.source.refused(node, "this does nothing")
        return [Statement("do", parts=(called,))]

    def do_return(self, node: ast.Return) -> list[Statement]:
        """Return from the kernel."""
        held = None if node.value is None else self.of(node.value)
        kind = VOID if held is None else held.type
        if any(part.kind in ("array", "slice") for part in (kind, *(kind.parts if kind.kind == "tuple" else ()))):
            raise self.source.refused(node, "an array is returned")
        found = unified(self.result or kind, kind)
        if found is None:
            raise self.source.refused(node, f"{self.result} is returned there and {kind} here")
        self.result = found
        return [Statement("return", parts=() if held is None else (cast(held, found),))]

    def do_annassign(self, node: ast.AnnAssign) -> list[Statement]:
        """Assign."""
        if node.value is None:
            return []
        return self._assign(node.target, self.of(node.value))

    def do_assign(self, node: ast.Assign) -> list[Statement]:
        """Assign to one or more targets."""
        held = self.of(node.value)
        if len(node.targets) > 1 and held.form not in ("number", "name", "constant"):
            held, first = self._kept(node, held)
        else:
            first = []
        return first + [done for target in node.targets for done in self._assign(target, held)]

    def do_augassign(self, node: ast.AugAssign) -> list[Statement]:
        """Change a variable or an entry."""
        before = ast.copy_location(_loaded(node.target), node)
        changed = ast.copy_location(ast.BinOp(before, node.op, node.value), node)
        return self._assign(node.target, self.of(ast.fix_missing_locations(changed)))

    def _kept(self, node: ast.AST, held: Typed) -> tuple[Typed, list[Statement]]:
        """Return a variable that keeps an expression."""
        self.temporary += 1
        name = f"kept_{self.temporary}"
        kind = self.assigned(node, name, held.type)
        return Typed(kind, "name", name), [Statement("assign", name, (cast(held, kind),))]

    def _assign(self, target: ast.expr, held: Typed) -> list[Statement]:
        if isinstance(target, ast.Name):
            if target.id == NOWHERE:
                return [Statement("do", parts=(held,))] if held.form == "call" else []
            kind = self.assigned(target, target.id, held.type)
            return [Statement("assign", target.id, (cast(held, kind),))]
        if isinstance(target, ast.Subscript):
            return self._store(target, held)
        if isinstance(target, ast.Tuple):
            return self._unpack(target, held)
        raise self.source.refused(target, f"an assignment to {type(target).__name__}")

    def _store(self, target: ast.Subscript, held: Typed) -> list[Statement]:
        place = self.of(target)
        self.writes = True
        if place.form == "item":
            if not held.type.is_number:
                raise self.source.refused(target, f"an entry that becomes {held.type}")
            return [Statement("store", parts=(place, cast(held, place.type)))]
        if place.form != "view" or not (held.type.is_number or (held.type == place.type and place.type.axes == 1)):
            raise self.source.refused(target, f"{place.type} that becomes {held.type}")
        return [Statement("fill", parts=(place, cast(held, place.type.item) if held.type.is_number else held))]

    def _unpack(self, target: ast.Tuple, held: Typed) -> list[Statement]:
        if held.type.kind != "tuple" or len(held.type.parts) != len(target.elts):
            raise self.source.refused(target, f"{len(target.elts)} targets of {held.type}")
        done: list[Statement] = []
        if held.form == "tuple":
            parts = list(held.parts)
            if _depends(target, parts):
                for k, part in enumerate(parts):
                    if part.form != "number":
                        parts[k], keep = self._kept(target, part)
                        done += keep
        else:
            if held.form != "name":
                held, keep = self._kept(target, held)
                done += keep
            parts = [Typed(kind, "part", parts=(held,), detail=k) for k, kind in enumerate(held.type.parts)]
        for element, part in zip(target.elts, parts, strict=True):
            done += self._assign(element, part)
        return done

    def do_if(self, node: ast.If) -> list[Statement]:
        """Do one or the other."""
        test = self.truth(node.test)
        return [Statement("if", parts=(test,), bodies=(self.block(node.body), self.block(node.orelse)))]

    def do_while(self, node: ast.While) -> list[Statement]:
        """Repeat while a condition holds."""
        self._refuse_else(node)
        always = isinstance(node.test, ast.Constant) and node.test.value is True
        test = Typed(BOOL, "number", "True") if always else self.truth(node.test)
        return [Statement("while", parts=(test,), bodies=(self._looped(node.body),))]

    def do_for(self, node: ast.For) -> list[Statement]:
        """Count, or go through a row."""
        self._refuse_else(node)
        if not isinstance(node.target, ast.Name):
            raise self.source.refused(node, "a loop over more than one variable at once")
        name, over = node.target.id, node.iter
        if isinstance(over, ast.Call) and self.function_of(over.func) is range:
            return [self._range(node, name, over)]
        row = self.of(over)
        if row.form == "tuple" and row.parts and all(part.type.is_number for part in row.parts):
            self.assigned(node, name, row.parts[0].type)
            for part in row.parts:
                self.assigned(node, name, part.type)
            parts = tuple(cast(part, self.types[name]) for part in row.parts)
            return [Statement("items", name, parts, (self._looped(node.body),), "numbers")]
        if row.type.kind != "array" or row.type.axes != 1:
            raise self.source.refused(node, f"a loop over {row.type}")
        self.assigned(node, name, row.type.item)
        return [Statement("items", name, (row,), (self._looped(node.body),), "row")]

    def _range(self, node: ast.For, name: str, over: ast.Call) -> Statement:
        ends = [self.of(part) for part in over.args]
        if any(end.type != INT for end in ends):
            raise self.source.refused(node, "a range of other than whole numbers")
        step = self._whole(over.args[2]) if len(ends) == 3 else 1
        if step == 0:
            raise self.source.refused(node, "a range with a step that is not known beforehand")
        start = ends[0] if len(ends) > 1 else Typed(INT, "number", "0")
        stop = ends[1] if len(ends) > 1 else ends[0]
        if name == NOWHERE:
            name = ""
        else:
            self.assigned(node, name, INT)
        parts = start, stop, Typed(INT, "number", str(step))
        return Statement("range", name, parts, (self._looped(node.body),))

    def _whole(self, node: ast.expr) -> int:
        """Return a whole number that is written down, or one of the module; zero if it is neither."""
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
            return -self._whole(node.operand)
        if isinstance(node, ast.Name) and node.id not in self.types:
            found = self.source.names.get(node.id)
        else:
            found = node.value if isinstance(node, ast.Constant) else None
        return found if isinstance(found, int) else 0

    def _looped(self, nodes: list[ast.stmt]) -> tuple[Statement, ...]:
        self.loops += 1
        body = self.block(nodes)
        self.loops -= 1
        return body

    def _refuse_else(self, node: ast.For | ast.While) -> None:
        if node.orelse:
            raise self.source.refused(node, "else of a loop is not translated")


def _loaded(target: ast.expr) -> ast.expr:
    """Return a target as what it holds."""
    copy = ast.parse(ast.unparse(target), mode="eval").body
    for part in ast.walk(copy):
        for name in ("lineno", "end_lineno"):
            if hasattr(part, name):
                setattr(part, name, getattr(target, name))
    return copy


def _depends(target: ast.Tuple, parts: list[Typed]) -> bool:
    """Return whether what is assigned first may change what is assigned later."""
    names = {node.id for node in ast.walk(target) if isinstance(node, ast.Name)}
    stores = any(isinstance(node, ast.Subscript) for node in ast.walk(target))

    def read(part: Typed) -> bool:
        if part.form == "name" and part.text in names and part.type.is_number:
            return True
        if part.form in ("call",) or (stores and part.form in ("item", "function")):
            return True
        return any(read(inner) for inner in part.parts)

    return len(parts) > 1 and any(read(part) for part in parts)
