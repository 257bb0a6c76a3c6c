"""Compiled kernels on disk: each file is checked before it is used, and a disk that fails costs time, not the run.

numba trusts its cache: an index that a power cut emptied ends every later run, and a number of a file that it meant to
overwrite may name the code of another kernel.  Here each kernel and signature has a file with a name of its own and a
digest at its end.  A file that does not agree with its digest is removed, and the kernel is compiled.
"""

from __future__ import annotations

import contextlib
import hashlib
import logging
import os
from pathlib import Path
from typing import Any

LOG = logging.getLogger(__name__)
ENDING = ".nbc"
_said: set[str] = set()
DIGEST_BYTES = hashlib.sha256().digest_size


class KernelCache:
    """The cache of one kernel, in place of that of numba which it uses.

    Parameters
    ----------
    plain
        numba's ``FunctionCache``.
    """

    def __init__(self, plain: Any) -> None:
        self._plain = plain
        plain._cache_file = _KernelFiles(plain._cache_file)
        self.cache_path: str | None = plain.cache_path

    def load_overload(self, signature: Any, context: Any) -> Any:
        """Return the compiled kernel for a signature; None if there is none, or what is there cannot be used."""
        try:
            return self._plain.load_overload(signature, context)
        except Exception as error:  # what pickle and LLVM raise on foreign bytes is of any kind
            self._plain.flush()
            _say_once(
                "damaged", f"compiled kernels in {self.cache_path} were damaged ({_why(error)}) and are made anew."
            )
            return None

    def save_overload(self, signature: Any, kernel: Any) -> None:
        """Keep a compiled kernel; where the disk does not take it, go on without."""
        try:
            self._plain.save_overload(signature, kernel)
        except Exception as error:
            self._plain.disable()
            _say_once(
                "unsaved",
                f"compiled kernels cannot be kept in {self.cache_path} ({_why(error)}); free some space, or set "
                "NUMBA_CACHE_DIR to another folder.",
            )

    def flush(self) -> None:
        """Remove what is kept of this kernel."""
        self._plain.flush()


class _KernelFiles:
    """The files of one kernel; `plain` is numba's ``IndexDataCacheFile``, which names the folder and packs."""

    def __init__(self, plain: Any) -> None:
        self._plain = plain
        made_of = repr((plain._version, plain._source_stamp)).encode()
        self._made_of = hashlib.sha256(made_of).hexdigest()[:12]

    def load(self, key: Any) -> Any:
        path = self._path(key)
        try:
            content = path.read_bytes()
        except OSError:
            return None
        if hashlib.sha256(content[:-DIGEST_BYTES]).digest() != content[-DIGEST_BYTES:]:
            raise ValueError(f"{path.name} does not agree with its digest")
        return self._plain._load_data(path.name)  # it ends before the digest

    def save(self, key: Any, kernel: Any) -> None:
        for path in self._kept():
            if not path.name.startswith(self._begin):  # of another version of the source
                path.unlink(missing_ok=True)
        content = self._plain._dump(kernel)
        with self._plain._open_for_write(os.fspath(self._path(key))) as file:
            file.write(content + hashlib.sha256(content).digest())

    def flush(self) -> None:
        for path in self._kept():
            with contextlib.suppress(OSError):
                path.unlink(missing_ok=True)

    @property
    def _base(self) -> str:
        return str(self._plain._index_name).removesuffix(".nbi")

    @property
    def _begin(self) -> str:
        return f"{self._base}.{self._made_of}."

    def _path(self, key: Any) -> Path:
        mark = hashlib.sha256(repr(key).encode()).hexdigest()[:16]
        return Path(self._plain._cache_path, f"{self._begin}{mark}{ENDING}")

    def _kept(self) -> list[Path]:
        with contextlib.suppress(OSError), os.scandir(self._plain._cache_path) as entries:
            names = [one.name for one in entries if one.name.startswith(f"{self._base}.")]
            return [Path(self._plain._cache_path, name) for name in names if name.endswith(ENDING)]
        return []


def _why(error: Exception) -> str:
    return (getattr(error, "strerror", None) or " ".join(str(error).split()) or type(error).__name__).lower()


def _say_once(kind: str, sentence: str) -> None:
    """Log a warning, once in a process; the processes of a pool leave that to the one which started them."""
    import multiprocessing

    if kind not in _said and multiprocessing.parent_process() is None:
        LOG.warning("winkler: %s", sentence)
    _said.add(kind)
