"""What a long march has reached, kept beside its results while it runs: one that was killed goes on where it was.

The file is hidden, belongs to one question (its name holds the hash of the problem), is replaced whole after every
state, and is removed when the results are written.
"""

from __future__ import annotations

import contextlib
import glob
from importlib.metadata import version
from pathlib import Path
from typing import Any

from winkler.errors import InvalidInput
from winkler.io.array_file import version_of
from winkler.study.chapters.kind import path_of
from winkler.study.language.canonical import digest_of
from winkler.values import value

__all__ = ["Keep", "refuse_other_version"]

KEPT = ("winkler.problems.wear.fretting:FrettingWear", "winkler.problems.wear.sliding:SlidingWear")
"""Paths of problems whose march goes on from a state."""
ENDING = ".states.npz"


def refuse_other_version(owner: str, made: object) -> None:
    """Refuse what another version of winkler has kept of a run that was stopped.

    Parameters
    ----------
    owner
        What it is, as the sentence begins.
    made
        The version that it tells; nothing if it tells none.

    Raises
    ------
    InvalidInput
    """
    mine = version("winkler")
    if made != mine:
        which = f"version {made}" if made else "an unknown version"
        raise InvalidInput(
            f"{owner} was begun by {which} of winkler, and this is {mine}: their numbers may differ; add --anew to "
            "begin again without it, or go on with that version."
        )


@value
class Keep:
    """Where states are kept.

    Parameters
    ----------
    folder : str
        An existing folder.
    stem : str
        How the names of the files begin: that of the folder of results.
    """

    folder: str
    stem: str

    @classmethod
    def beside(cls, results: Path) -> Keep:
        """Return the place beside a folder of results."""
        return cls(str(results.parent), results.name)

    def path(self, problem: Any) -> Path:
        """Return the file of a problem."""
        return Path(self.folder) / f".{self.stem}.{digest_of(problem)[:16]}{ENDING}"

    @staticmethod
    def takes(problem: Any) -> bool:
        """Return whether the march of a problem goes on from a state."""
        return path_of(type(problem)) in KEPT

    def reached(self, problem: Any) -> list[Any]:
        """Return the states that an earlier run has reached; none if there was none, or its file is spoilt.

        Raises
        ------
        InvalidInput
            If another version of winkler has written them: its numbers may be others.
        """
        path = self.path(problem)
        if not self.takes(problem) or not path.exists():
            return []
        from winkler.io.wear_states import read_wear

        try:
            states = list(read_wear(problem.bed, path))
        except InvalidInput:  # it begins anew
            return []
        refuse_other_version(f"states: '{path}'", version_of(path))
        return states

    def write(self, problem: Any, states: list[Any]) -> None:
        """Keep the states of a march so far, where it can go on from them."""
        if self.takes(problem) and Path(self.folder).is_dir():
            from winkler.io.wear_states import write_wear

            write_wear(states, self.path(problem))

    def forget(self) -> None:
        """Remove the files of all problems with this stem: their results are written, or nobody wants them."""
        for path in Path(self.folder).glob(f".{glob.escape(self.stem)}.{'[0-9a-f]' * 16}{ENDING}"):
            with contextlib.suppress(OSError):
                path.unlink()
