"""Kernels as plain Python in one file: their own source, without decorators, under names that do not meet."""

from __future__ import annotations

import ast
import copy
from typing import Any

from winkler.exporting.translation.subset import is_translatable, source_of
from winkler.exporting.translation.tree import Routine, TranslationUnit


def python_source(unit: TranslationUnit) -> str:
    """Return the functions of a unit; they need `math` and numpy as `np`."""
    names: dict[int, str] = {}
    kept: list[Routine] = []
    variables = set[str]().union(*(_variables(source_of(routine.kernel).definition) for routine in unit.routines))
    entries = {id(routine.kernel) for routine in unit.entries}
    for routine in unit.routines:
        if id(routine.kernel) not in names:  # one function does for all types
            hidden = routine.name in variables and id(routine.kernel) not in entries
            names[id(routine.kernel)] = f"{routine.name}_of" if hidden else routine.name
            kept.append(routine)
    constants = {constant.place: constant.name for constant in unit.constants}
    lines = []
    for constant in unit.constants:
        numbers = repr(constant.numbers) if constant.type.kind == "array" else repr(constant.numbers[0])
        lines.append(f"{constant.name} = {numbers}".replace("inf", "math.inf").replace("nan", "math.nan"))
    functions = [_function(routine.kernel, names, constants) for routine in kept]
    return "\n\n\n".join(["\n".join(lines), *functions]) if lines else "\n\n\n".join(functions)


class _Renamed(ast.NodeTransformer):
    """Gives functions and constants the names of the file, and takes annotations away."""

    def __init__(self, names: dict[str, str]) -> None:
        self.names = names

    def visit_Name(self, node: ast.Name) -> ast.Name:
        """Rename."""
        return ast.copy_location(ast.Name(self.names.get(node.id, node.id), node.ctx), node)

    def visit_AnnAssign(self, node: ast.AnnAssign) -> Any:
        """Assign without an annotation."""
        self.generic_visit(node)
        return None if node.value is None else ast.copy_location(ast.Assign([node.target], node.value), node)

    def visit_arg(self, node: ast.arg) -> ast.arg:
        """Take the annotation away."""
        return ast.arg(node.arg)


def _variables(definition: ast.FunctionDef) -> set[str]:
    """Return the names of arguments and variables, behind which a function of the same name could not be called."""
    stored = (one for one in ast.walk(definition) if isinstance(one, ast.Name) and isinstance(one.ctx, ast.Store))
    return {one.arg for one in ast.walk(definition) if isinstance(one, ast.arg)} | {one.id for one in stored}


def _function(kernel: Any, names: dict[int, str], constants: dict[tuple[str, str], str]) -> str:
    source = source_of(kernel)
    definition = copy.deepcopy(source.definition)
    definition.decorator_list, definition.returns = [], None
    local = _variables(definition)
    renamed: dict[str, str] = {}
    for node in ast.walk(definition):
        if not isinstance(node, ast.Name) or node.id in local:
            continue
        found = source.names.get(node.id)
        if is_translatable(found):
            renamed[node.id] = names[id(found)]
        elif (kernel.__module__, node.id) in constants:
            renamed[node.id] = constants[kernel.__module__, node.id]
    definition.name = names[id(kernel)]
    text = ast.unparse(ast.fix_missing_locations(_Renamed(renamed).visit(definition)))
    return f"# from {source.file}, line {source.definition.lineno}\n{text}"
