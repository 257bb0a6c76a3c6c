"""Kernels: plain loops over arrays, compiled when they are first called.

A kernel is written as ordinary Python and decorated with `compiled`.  numba is imported at the first call of a kernel,
never when winkler is imported.  Where there is no numba (in a browser, on a Python that it does not support yet) the
same source runs as it is, slower.
What is compiled is kept for the next process, where there is a place for it: see `winkler.numerics.cache_folders` and
`winkler.numerics.kernel_cache`.

A kernel may call others, also those of other files: numba's cache on disk, which goes by the file and the code of one
function alone, receives what they consist of.  Rules for whoever writes one: it divides by zero without an error, and
may count on infinities and on what comparisons with not-a-number give: only re-association, contraction and the sign of
zero are given away for speed.
Kernels let other threads run.
"""

from __future__ import annotations

import contextlib
import functools
import hashlib
import logging
import os
import sys
import types
from collections.abc import Callable
from pathlib import Path
from typing import Any, Generic, ParamSpec, TypeVar

import numpy as np

from winkler.numerics.cache_folders import with_kernels
from winkler.numerics.kernel_cache import KernelCache

P = ParamSpec("P")
R = TypeVar("R")

FAST_MATH_FLAGS = frozenset({"reassoc", "contract", "nsz"})
"""What the compiler may do to arithmetic; never to assume that there is no infinity and no not-a-number."""
OPTIONS: dict[str, Any] = {"nogil": True, "error_model": "numpy", "forceinline": True}
"""How kernels are compiled: each stands in full within those that call it.

A kernel that calls a copy of another one may reach the copy in any kernel that was compiled or loaded earlier; as
re-association depends on what is around, last digits then differ between a first run and later ones.
"""
GLOBAL_KINDS = int, float, np.ndarray
"""What a kernel may read from its module."""
COMPILED_NOW: list[bool] = []
"""Of kernels that are being compiled, each for the one before: whether references to arrays are counted in it."""
LOG = logging.getLogger(__name__)


class Instead:
    """Functions that kernels call instead of those of their modules.

    Parameters
    ----------
    functions : dict
        By the names of those.
    lists : tuple of str, optional
        Names of what asks for memory, or returns arrays: who refers to an array is counted within these only.
    """

    def __init__(self, functions: dict[str, Callable[..., Any]], lists: tuple[str, ...] = ()) -> None:
        self.functions, self.lists = functions, lists
        self._kernels: dict[Callable[..., Any], Kernel[Any, Any]] = {}

    def kernel(self, function: Callable[P, R]) -> Kernel[P, R]:
        """Return the kernel of a function that calls them."""
        return self._kernels.setdefault(function, Kernel(function, self))


class Kernel(Generic[P, R]):
    """A function over arrays that is compiled at its first call.

    Parameters
    ----------
    function : callable
        Takes arrays and numbers, writes into the arrays it is given or returns numbers.
    instead : Instead, optional
    """

    def __init__(self, function: Callable[P, R], instead: Instead | None = None) -> None:
        functools.update_wrapper(self, function)
        self.function, self.instead = function, instead

    @property
    def _called(self) -> dict[str, Kernel[Any, Any]]:
        """Name -> every kernel that this one calls, and every function of winkler that is plain arithmetic."""
        source = self.function
        assert isinstance(source, types.FunctionType)
        names, instead = source.__code__.co_names, self.instead
        own = {} if instead is None else instead.functions
        kernels = {name: _kernel_of(own.get(name, source.__globals__.get(name))) for name in names}
        found = {name: kernel for name, kernel in kernels.items() if kernel is not None}
        return found if instead is None else {name: instead.kernel(each.function) for name, each in found.items()}

    @functools.cached_property
    def content(self) -> str:
        """A digest of this kernel and of all that it calls, numbers of their modules and the freedoms included."""
        source = self.function
        assert isinstance(source, types.FunctionType)
        code = source.__code__
        numbers = [(name, source.__globals__.get(name)) for name in code.co_names]
        own = [(name, np.asarray(number).tolist()) for name, number in numbers if isinstance(number, GLOBAL_KINDS)]
        own += [(name, repr(row)) for name, row in numbers if isinstance(row, tuple)]
        parts = [code.co_code, code.co_consts, code.co_names, own, sorted(FAST_MATH_FLAGS), OPTIONS]
        called = [kernel.content for kernel in self._called.values()]
        if self.instead is not None:
            called += [name for name in self._called if name in self.instead.lists]
        return hashlib.sha256(repr((parts, called)).encode()).hexdigest()

    @functools.cached_property
    def machine(self) -> Callable[P, R]:
        """The compiled function; that of the kernels it calls is put in their place."""
        return self._made(counted=True)

    @functools.cached_property
    def uncounted(self) -> Callable[P, R]:
        """The same for kernels that ask for no memory: who refers to an array is not counted.

        Counting takes most of the time of a loop that hands a few numbers of each of many arrays to another kernel.
        """
        return self._made(counted=False)

    def _made(self, *, counted: bool) -> Callable[P, R]:
        numba = _numba()
        if numba is None:
            # compiled arithmetic does not complain either: what comes of it is never chosen
            written = self.function
            if self.instead is not None:
                assert isinstance(written, types.FunctionType)
                called = {name: kernel.machine for name, kernel in self._called.items()}
                written = types.FunctionType(written.__code__, {**written.__globals__, **called}, written.__name__)
            return np.errstate(divide="ignore", invalid="ignore", over="ignore")(written)
        source = self.function
        assert isinstance(source, types.FunctionType)
        cached = with_kernels(Path(source.__code__.co_filename))
        if "NUMBA_CACHE_DIR" in os.environ:  # numba may have been imported before there was a place
            numba.config.CACHE_DIR = os.environ["NUMBA_CACHE_DIR"]
        referenced: dict[str, Any] = dict(source.__globals__)
        code, cells = source.__code__, source.__closure__ or ()
        for name, kernel in self._called.items():
            plain = self.instead is not None and name not in self.instead.lists
            referenced[name] = kernel.uncounted if plain or not counted else kernel.machine
        # numba's cache goes by the code of a function and by what its closure holds
        code = code.replace(co_freevars=(*code.co_freevars, "content"))
        cells = (*cells, types.CellType(self.content if counted else f"{self.content} uncounted"))
        copy = types.FunctionType(code, referenced, source.__name__, source.__defaults__, cells)
        copy.__module__, copy.__qualname__ = source.__module__, source.__qualname__
        options = OPTIONS if counted else OPTIONS | {"_nrt": False}
        machine: Callable[P, R] = numba.njit(fastmath=set(FAST_MATH_FLAGS), **options)(copy)
        _watch(machine, counted)
        if cached:
            with contextlib.suppress(RuntimeError, OSError):  # it finds no place after all: nothing is kept
                machine.enable_caching()  # type: ignore[attr-defined]
                machine._cache = KernelCache(machine._cache)  # type: ignore[attr-defined]
        return machine

    def __call__(self, *args: P.args, **kwargs: P.kwargs) -> R:
        """Run the kernel."""
        return self.machine(*args, **kwargs)


def _watch(machine: Any, counted: bool) -> None:
    """Let a kernel that counts who refers to an array call no other that does not count and returns one.

    Nor is one compiled again for a constant that it is called with: constants reach what stands in full anyway.
    """
    from numba.core import types as numba_types

    plain: Callable[[Any], Any] = numba_types.unliteral
    compile_plainly, called_plainly = machine.compile, machine.get_call_template

    def compile_watched(signature: Any) -> Any:
        COMPILED_NOW.append(counted)
        try:
            return compile_plainly(signature)
        finally:
            COMPILED_NOW.pop()

    def called(args: Any, kws: Any) -> Any:
        template = called_plainly(tuple(map(plain, args)), {name: plain(kind) for name, kind in kws.items()})
        if not counted and COMPILED_NOW and COMPILED_NOW[-1]:
            for found in machine.overloads.values():
                kind = found.signature.return_type
                if found.target_context.data_model_manager[kind].contains_nrt_meminfo():
                    raise TypeError(
                        f"the kernel {machine.__name__} returns {kind}, which holds an array, but is not among the "
                        "`lists` of its `Instead`; name it there, or let it write into an array that it is given."
                    )
        return template

    machine.compile, machine.get_call_template = compile_watched, called


@functools.cache
def _numba() -> Any:
    """Return numba; None where there is none, or it cannot be loaded: a process says so once."""
    if sys.platform == "emscripten":
        return None
    try:
        import numba
    except (ImportError, OSError) as error:
        import multiprocessing

        if multiprocessing.parent_process() is None:
            missing = isinstance(error, ModuleNotFoundError) and error.name == "numba"
            why = "is not installed" if missing else f"cannot be loaded ({' '.join(str(error).split()).rstrip('.')})"
            LOG.warning("winkler: numba %s; loops run as plain Python, more slowly; install it to run faster.", why)
        return None
    return numba


def _kernel_of(content: Any) -> Kernel[Any, Any] | None:
    """Return a kernel, that of a plain function of winkler, or nothing for anything else."""
    if isinstance(content, Kernel):
        return content
    if isinstance(content, types.FunctionType) and content.__module__.startswith("winkler."):
        return _kernel_of_function(content)
    return None


@functools.cache
def _kernel_of_function(function: types.FunctionType) -> Kernel[Any, Any]:
    return Kernel(function)


def compiled(function: Callable[P, R]) -> Kernel[P, R]:
    """Make a kernel of a function; a decorator, for functions in files."""
    return Kernel(function)
