"""From kernels to routines: each for the types of its arguments, with all that it calls."""

from __future__ import annotations

import ast
from collections.abc import Mapping, Sequence, Set

from winkler.exporting.translation.functions import cast
from winkler.exporting.translation.statements import Statements
from winkler.exporting.translation.subset import KernelSource, Translatable, source_of, unified
from winkler.exporting.translation.tree import (
    BOOL,
    INT,
    REAL,
    VOID,
    Constant,
    Routine,
    Statement,
    TranslatedType,
    TranslationUnit,
    array_of,
)
from winkler.values.errors import InvalidInput

MOST_PASSES = 12
"""Until the types of variables settle; each may change from whole to real numbers once."""
ANNOTATED = {"float": REAL, "int": INT, "bool": BOOL}


class Translation:
    """Collects routines and what they need.

    Parameters
    ----------
    reserved : set of str, optional
        Names that no routine may have.
    """

    def __init__(self, reserved: Set[str] = frozenset()) -> None:
        self.reserved = reserved
        self.routines: dict[tuple[Translatable, tuple[TranslatedType, ...]], Routine] = {}
        self.constants: dict[tuple[str, str], Constant] = {}

    def constant(self, name: str, module: str, type_: TranslatedType, numbers: tuple[float | int, ...]) -> Constant:
        """Return a constant of a module."""
        key = module, name
        if key not in self.constants:
            taken = {known.name for known in self.constants.values()}
            self.constants[key] = Constant(_free(name.lstrip("_"), taken), type_, numbers, key)
        return self.constants[key]

    def routine(
        self, kernel: Translatable, types: tuple[TranslatedType, ...], source: KernelSource | None = None
    ) -> Routine:
        """Return the routine of a kernel for given types."""
        own = source_of(kernel)
        names = [argument.arg for argument in own.definition.args.args]
        plain = own.definition.args
        if plain.kwonlyargs or plain.vararg or plain.kwarg or plain.defaults or len(names) != len(types):
            raise (source or own).refused(
                own.definition, f"{own.definition.name} takes {len(names)} arguments, given {len(types)}"
            )
        wanted = []
        for argument, kind in zip(plain.args, types, strict=True):
            stated = ANNOTATED.get(ast.unparse(argument.annotation)) if argument.annotation is not None else None
            wanted.append(stated if stated is not None and kind.is_number and unified(stated, kind) == stated else kind)
        key = kernel, tuple(wanted)
        if key not in self.routines:
            self.routines[key] = self._built(own, dict(zip(names, wanted, strict=True)))
        return self.routines[key]

    def _built(self, source: KernelSource, arguments: dict[str, TranslatedType]) -> Routine:
        types, result = dict(arguments), None
        for _ in range(MOST_PASSES):
            before = dict(types), result
            builder = Statements(source, self, types)
            builder.result = result
            body = builder.block(source.definition.body)
            result = builder.result
            if (types, result) == before:
                break
        else:
            raise source.refused(source.definition, "the types of its variables do not settle")
        final = result or VOID
        body = _returning(body, final)
        taken = {known.name for known in self.routines.values()} | self.reserved
        name = _free(source.definition.name.lstrip("_"), taken)
        kept = {name: kind for name, kind in types.items() if name not in arguments}
        passed = tuple((name, types[name]) for name in arguments)
        return Routine(name, source.kernel, passed, final, kept, body, builder.writes, builder.arrays_made)

    def unit(self, *entries: Routine) -> TranslationUnit:
        """Return everything in the order in which it is written: what is called stands before."""
        return TranslationUnit(tuple(self.constants.values()), tuple(self.routines.values()), entries)


def translate(
    kernel: Translatable, axes: Mapping[str, int] | Sequence[TranslatedType] | None = None
) -> TranslationUnit:
    """Translate a kernel and all that it calls.

    Parameters
    ----------
    kernel : Kernel
    axes : mapping or sequence of TranslatedType, optional
        How many axes arguments have that are arrays, where not one; or the types of all arguments.

    Raises
    ------
    InvalidInput
        If a line leaves the subset that is translated; the message names file and line.
    """
    if axes is None or isinstance(axes, Mapping):
        source = source_of(kernel)
        types: list[TranslatedType] = []
        for argument in source.definition.args.args:
            stated = ast.unparse(argument.annotation) if argument.annotation is not None else ""
            if stated == "Array":
                types.append(array_of((axes or {}).get(argument.arg, 1)))
            elif stated in ANNOTATED:
                types.append(ANNOTATED[stated])
            else:
                raise InvalidInput(
                    f"translate: {source.definition.name} does not state whether {argument.arg} is a number or an "
                    "array; give the types of all arguments."
                )
    else:
        types = list(axes)
    translation = Translation()
    return translation.unit(translation.routine(kernel, tuple(types)))


def _free(name: str, taken: set[str]) -> str:
    """Return a name that is not taken yet."""
    found, count = name, 1
    while found in taken:
        count += 1
        found = f"{name}_{count}"
    return found


def _returning(body: tuple[Statement, ...], result: TranslatedType) -> tuple[Statement, ...]:
    """Return statements whose every return gives the same type."""
    done = []
    for statement in body:
        if statement.form == "return" and statement.parts:
            statement = statement._replace(parts=(cast(statement.parts[0], result),))
        bodies = tuple(_returning(inner, result) for inner in statement.bodies)
        done.append(statement._replace(bodies=bodies))
    return tuple(done)
