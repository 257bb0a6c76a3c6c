"""Where the source of a kernel leaves the subset that is translated: refused with its file and line."""

from __future__ import annotations

import ast
import inspect
import textwrap
import types
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from winkler.exporting.translation.tree import BOOL, INT, REAL, TranslatedType, tuple_of
from winkler.numerics.jit import Kernel
from winkler.values.errors import InvalidInput

Translatable = Kernel[Any, Any] | Callable[..., Any]
"""What can be translated."""


class KernelSource(NamedTuple):
    """The source of a kernel.

    Parameters
    ----------
    kernel : Kernel or function
    definition : FunctionDef
        Its lines are those of the file.
    file : str
    names : dict
        What its module defines.
    """

    kernel: Translatable
    definition: ast.FunctionDef
    file: str
    names: dict[str, Any]

    def refused(self, node: ast.AST, what: str) -> InvalidInput:
        """Return what is to be raised for a place in the source."""
        line = getattr(node, "lineno", self.definition.lineno)
        return InvalidInput(
            f"{self.file}:{line}: {what}; a kernel that is translated consists of loops, conditions and arithmetic "
            "with numbers, arrays and tuples of them."
        )

    @property
    def doc(self) -> str:
        """Its docstring."""
        return inspect.getdoc(self.kernel) or ""


def is_translatable(function: Any) -> bool:
    """Return whether a function is a kernel, or one of the package that is nothing but arithmetic."""
    if isinstance(function, types.FunctionType):
        return (function.__module__ or "").startswith(f"{__name__.partition('.')[0]}.")
    return isinstance(function, Kernel)


def source_of(kernel: Translatable) -> KernelSource:
    """Return the source of a kernel, or of a plain function.

    Raises
    ------
    InvalidInput
        If it has none, or it is no kernel.
    """
    if not isinstance(kernel, Kernel | types.FunctionType):
        raise InvalidInput(f"translate: a {type(kernel).__name__} is no kernel; give a function decorated by compiled.")
    function = kernel.function if isinstance(kernel, Kernel) else kernel
    assert isinstance(function, types.FunctionType)
    try:
        lines, first = inspect.getsourcelines(function)
    except OSError:
        raise InvalidInput(
            f"translate: the source of {function.__name__} was not found; a kernel must be defined in a file."
        ) from None
    tree = ast.parse(textwrap.dedent("".join(lines)))
    ast.increment_lineno(tree, first - 1)
    definition = tree.body[0]
    assert isinstance(definition, ast.FunctionDef)
    module = function.__module__  # no path of this machine: the folder of a checkout may have the name of the package
    file = module.replace(".", "/") + ".py" if module.startswith("winkler.") else f"{module.rpartition('.')[2]}.py"
    names = dict(function.__globals__)
    code = function.__code__
    for name, cell in zip(code.co_freevars, function.__closure__ or (), strict=True):
        names[name] = cell.cell_contents
    return KernelSource(kernel, definition, file, names)


def unified(one: TranslatedType, other: TranslatedType) -> TranslatedType | None:
    """Return the type that holds what both hold, or None."""
    if one == other:
        return one
    if one.is_number and other.is_number:
        return REAL if REAL in (one, other) else INT
    if one.kind == other.kind == "tuple" and len(one.parts) == len(other.parts):
        parts = [unified(*pair) for pair in zip(one.parts, other.parts, strict=True)]
        return None if None in parts else tuple_of(*parts)  # type: ignore[arg-type]
    return None


def of_type(number: Any) -> TranslatedType | None:
    """Return the type of a number of a module, or None for what is no number."""
    if isinstance(number, bool | np.bool_):
        return BOOL
    if isinstance(number, int | np.integer):
        return INT
    return REAL if isinstance(number, float | np.floating) else None
