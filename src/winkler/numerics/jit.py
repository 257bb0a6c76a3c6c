"""Kernels: plain loops over arrays, compiled when they are first called.

A kernel is written as ordinary Python and decorated with `compiled`.  numba is imported at the first call of a kernel,
never when winkler is imported.  In a browser (emscripten), where there is no numba, the same source runs as it is.
What is compiled is kept for the next process, where there is a place for it: see `winkler.caches`.

Rules for whoever writes a kernel: it calls only kernels of its own file, because numba's cache on disk does not notice
when one in another file was edited.  It divides by zero without an error, and may count on infinities and on what
comparisons with not-a-number give: only re-association, contraction and the sign of zero are given away for speed.
Kernels let other threads run.
"""

from __future__ import annotations

import contextlib
import functools
import os
import sys
import types
from collections.abc import Callable
from pathlib import Path
from typing import Any, Generic, ParamSpec, TypeVar

import numpy as np

from winkler.caches import with_kernels

__all__ = ["Kernel", "compiled"]

P = ParamSpec("P")
R = TypeVar("R")

FREEDOMS = frozenset({"reassoc", "contract", "nsz"})
"""What the compiler may do to arithmetic; never to assume that there is no infinity and no not-a-number."""
INTERPRETED = sys.platform == "emscripten"
"""Whether kernels run as plain Python, where numba does not exist."""


class Kernel(Generic[P, R]):
    """A function over arrays that is compiled at its first call.

    Parameters
    ----------
    function : callable
        Takes arrays and numbers, writes into the arrays it is given or returns numbers.
    """

    def __init__(self, function: Callable[P, R]) -> None:
        functools.update_wrapper(self, function)
        self.function = function

    @functools.cached_property
    def machine(self) -> Callable[P, R]:
        """The compiled function; that of the kernels it calls is put in their place."""
        if INTERPRETED:
            # compiled arithmetic does not complain either: what comes of it is never chosen
            return np.errstate(divide="ignore", invalid="ignore", over="ignore")(self.function)
        source = self.function
        assert isinstance(source, types.FunctionType)
        cached = with_kernels(Path(source.__code__.co_filename))
        import numba

        if "NUMBA_CACHE_DIR" in os.environ:  # numba may have been imported before there was a place
            numba.config.CACHE_DIR = os.environ["NUMBA_CACHE_DIR"]  # type: ignore[attr-defined]
        known: dict[str, Any] = dict(source.__globals__)
        for name in source.__code__.co_names:
            if isinstance(known.get(name), Kernel):
                known[name] = known[name].machine
        copy = types.FunctionType(source.__code__, known, source.__name__, source.__defaults__, source.__closure__)
        copy.__module__, copy.__qualname__ = source.__module__, source.__qualname__
        machine: Callable[P, R] = numba.njit(nogil=True, fastmath=set(FREEDOMS), error_model="numpy")(copy)
        if cached:
            with contextlib.suppress(RuntimeError):  # it finds no place after all: nothing is kept
                machine.enable_caching()  # type: ignore[attr-defined]
        return machine

    def __call__(self, *args: P.args, **kwargs: P.kwargs) -> R:
        """Run the kernel."""
        return self.machine(*args, **kwargs)


def compiled(function: Callable[P, R]) -> Kernel[P, R]:
    """Make a kernel of a function; a decorator, for functions in files."""
    return Kernel(function)
