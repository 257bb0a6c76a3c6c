"""Translated kernels, compiled by the system's C compiler and called from Python."""

from __future__ import annotations

import ctypes
import functools
import math
import shutil
import subprocess
import sys
import types
from importlib.util import find_spec

import numpy as np
import pytest

from winkler.exporting.translation.c_writer import INCLUDES, c_source
from winkler.exporting.translation.translate import Translation
from winkler.exporting.translation.tree import BOOL, INT, REAL, VOID, array_of, tuple_of

PREFIX = "t_"
SCALARS = {"real": ctypes.c_double, "int": ctypes.c_int64, "bool": ctypes.c_bool}
STRICT = ("-O0", "-ffp-contract=off")
"""Options that leave arithmetic as it is written."""


def compiler() -> list[str]:
    """Return the command of a C compiler, or skip the test."""
    for name in ("gcc", "cc", "clang"):
        if shutil.which(name):
            return [name]
    if find_spec("ziglang"):
        return [sys.executable, "-m", "ziglang", "cc"]
    pytest.skip("no C compiler here: install gcc, or ziglang (pip install winkler[export])")


def type_of(argument):
    """Return the type of an argument."""
    if isinstance(argument, tuple):
        return tuple_of(*map(type_of, argument))
    if isinstance(argument, np.ndarray):
        return array_of(argument.ndim, {"f": REAL, "i": INT, "b": BOOL}[argument.dtype.kind])
    return BOOL if isinstance(argument, bool) else INT if isinstance(argument, int) else REAL


@functools.cache
def structure(kind):
    """Return the type in ctypes."""
    if kind.is_number:
        return SCALARS[kind.kind]
    if kind == VOID:
        return None
    if kind.kind == "tuple":
        fields = [(f"v{k}", structure(part)) for k, part in enumerate(kind.parts)]
    else:
        fields = [("data", ctypes.c_void_p), ("size", ctypes.c_int64 * kind.axes)]
        fields += [("stride", ctypes.c_int64 * (kind.axes - 1))] if kind.axes > 1 else []
    return type("Passed", (ctypes.Structure,), {"_fields_": fields})


def passed(argument, kind):
    """Return an argument as C takes it."""
    if kind.kind == "tuple":
        return structure(kind)(*(passed(*pair) for pair in zip(argument, kind.parts, strict=True)))
    if kind.kind != "array":
        return structure(kind)(argument)
    assert argument.flags.c_contiguous
    sizes = (ctypes.c_int64 * kind.axes)(*argument.shape)
    strides = [(ctypes.c_int64 * (kind.axes - 1))(*(s // argument.itemsize for s in argument.strides[:-1]))]
    return structure(kind)(argument.ctypes.data, sizes, *(strides if kind.axes > 1 else []))


def returned(result, kind):
    """Return a result as Python has it."""
    if kind.kind != "tuple":
        return result
    return tuple(getattr(result, f"v{k}") for k in range(len(kind.parts)))


class LibraryOfC:
    """numpy, with the functions of C's library in place of its own, which differ in the last digit."""

    def __getattr__(self, name):
        return getattr(math if name in ("exp", "expm1", "log", "log1p", "sqrt") else np, name)


def interpreted(kernel):
    """Return a kernel as plain Python, with all that it calls."""
    own = kernel.function
    known = {**own.__globals__, "np": LibraryOfC()}
    known |= {name: interpreted(part) for name, part in kernel._called.items()}
    return types.FunctionType(own.__code__, known, own.__name__, own.__defaults__)


def library(folder, kernels, options=STRICT):
    """Compile kernels; return kernel -> function of Python.

    `kernels` maps names to (kernel, arguments).
    """
    translation = Translation()
    routines = {
        name: translation.routine(kernel, tuple(map(type_of, arguments)))
        for name, (kernel, arguments) in kernels.items()
    }
    source, made = folder / "kernels.c", folder / "kernels.so"
    source.write_text(INCLUDES + c_source(translation.unit(), PREFIX), encoding="utf-8")
    warn = ("-Wall", "-Wextra", "-Wno-unused-function", "-Wno-unused-parameter", "-Werror=implicit")
    command = [*compiler(), "-std=c99", *options, *warn, "-Dstatic=", "-Dinline=", "-fPIC", "-shared"]
    subprocess.run([*command, str(source), "-o", str(made), "-lm"], check=True)
    loaded = ctypes.CDLL(str(made))

    def function(routine):
        own = getattr(loaded, PREFIX + routine.name)
        own.restype = structure(routine.result)
        own.argtypes = [structure(kind) for _, kind in routine.arguments]
        kinds = [kind for _, kind in routine.arguments]

        def call(*arguments):
            result = own(*(passed(*pair) for pair in zip(arguments, kinds, strict=True)))
            return returned(result, routine.result)

        return call

    return {name: function(routine) for name, routine in routines.items()}
