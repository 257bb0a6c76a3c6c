"""Checkpoints of a long march, stored beside its results: one that was killed is continued from there.

The file is hidden, belongs to one problem (its name contains the hash), is replaced atomically after every state, and
is removed when the results are written.
"""

from __future__ import annotations

import contextlib
import glob
from pathlib import Path
from typing import Any

from winkler.io.software import differences
from winkler.study.language.canonical import digest_of
from winkler.values.checks.contract import path_of
from winkler.values.errors import InvalidInput
from winkler.values.value import value

RESUMABLE_PROBLEMS = (
    "winkler.problems.surface_wear.wear:SurfaceWear",
    "winkler.problems.wear.fretting:FrettingWear",
    "winkler.problems.wear.line_fretting:LineFrettingWear",
    "winkler.problems.wear.line_sliding:LineSlidingWear",
    "winkler.problems.wear.sliding:SlidingWear",
)
"""Classes of problems whose march can be continued from a state."""
ENDING = ".states.npz"


def refuse_other_software(owner: str, made: object) -> None:
    """Refuse the records that other software left of a run that was stopped.

    Parameters
    ----------
    owner
        Subject of the sentence.
    made
        What wrote them, as `winkler.io.software.software` states it.

    Raises
    ------
    InvalidInput
    """
    other = differences(made)
    if other:
        raise InvalidInput(
            f"{owner} was begun with {other}, whose numbers may differ; add --anew to begin again without it, or go on "
            "with what it was begun with."
        )


@value
class CheckpointStore:
    """Folder and name of the files in which states are stored.

    Parameters
    ----------
    folder : str
        An existing folder.
    stem : str
        Beginning of the file names: that of the folder of results.
    """

    folder: str
    stem: str

    @classmethod
    def beside(cls, results: Path) -> CheckpointStore:
        """Return the store beside a folder of results."""
        return cls(str(results.parent), results.name)

    def path(self, problem: Any) -> Path:
        """Return the file of a problem."""
        return Path(self.folder) / f".{self.stem}.{digest_of(problem)[:16]}{ENDING}"

    @staticmethod
    def resumes(problem: Any) -> bool:
        """Return whether the march of a problem can be continued from a state."""
        return path_of(type(problem)) in RESUMABLE_PROBLEMS

    def stored_states(self, problem: Any) -> list[Any]:
        """Return the states that an earlier run has stored; none if there was none, or its file is damaged.

        Raises
        ------
        InvalidInput
            If other software has written them: its numbers may be others.
        """
        path = self.path(problem)
        if not self.resumes(problem) or not path.exists():
            return []
        from winkler.io.array_file import software_of
        from winkler.io.wear_states import read_wear

        made = software_of(path)
        try:
            states = list(read_wear(path, getattr(problem, "bed", None)))
        except InvalidInput:
            if not made:  # damaged: the march begins anew
                return []
            states = []
        refuse_other_software(f"states: '{path}'", made)  # its states may be of another format, too
        return states

    def write(self, problem: Any, states: list[Any]) -> None:
        """Store the states of a march so far, where it can be continued from them."""
        if self.resumes(problem) and Path(self.folder).is_dir():
            from winkler.io.wear_states import write_wear

            write_wear(states, self.path(problem))

    def remove(self) -> None:
        """Remove the files of all problems with this stem: their results are written, or the states are not wanted."""
        for path in Path(self.folder).glob(f".{glob.escape(self.stem)}.{'[0-9a-f]' * 16}{ENDING}"):
            with contextlib.suppress(OSError):
                path.unlink()
