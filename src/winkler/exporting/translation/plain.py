"""Kernels as plain Python, with all that they call: for a few steps faster than to compile them."""

from __future__ import annotations

import functools
import types
from collections.abc import Callable
from typing import Any

import numpy as np

from winkler.exporting.translation.subset import Translatable
from winkler.numerics.jit import Kernel


@functools.cache
def plain(kernel: Translatable) -> Callable[..., Any]:
    """Return a function that does what a kernel does, without being compiled.

    Parameters
    ----------
    kernel : Kernel or function
    """
    return np.errstate(divide="ignore", invalid="ignore", over="ignore")(_uncompiled(kernel))


@functools.cache
def _uncompiled(kernel: Translatable) -> Callable[..., Any]:
    function = kernel.function if isinstance(kernel, Kernel) else kernel
    assert isinstance(function, types.FunctionType)
    known = dict(function.__globals__)
    for name in function.__code__.co_names:
        if isinstance(known.get(name), Kernel):
            known[name] = _uncompiled(known[name])
    return types.FunctionType(function.__code__, known, function.__name__, function.__defaults__, function.__closure__)
