"""A worker that is started before a page asks for it, so that the page does not wait for its imports."""

from __future__ import annotations

import contextlib

from winkler.web.session import solver
from winkler.web.session.solver import Worker


class Standby:
    """At most one worker that waits for a page."""

    def __init__(self) -> None:
        self._waiting: Worker | None = None

    def prepare(self) -> None:
        """Start a worker, if none waits; where none can be started, the next page says so."""
        if self._waiting is None:
            with contextlib.suppress(OSError):
                self._waiting = solver.started()

    def take(self) -> Worker:
        """Return the waiting worker, or a new one.

        Raises
        ------
        OSError
            If none can be started.
        """
        worker, self._waiting = self._waiting, None
        if worker is None:
            return solver.started()
        if not worker.process.is_alive():
            worker.pipe.close()
            return solver.started()
        return worker

    def close(self) -> None:
        """End the waiting worker."""
        worker, self._waiting = self._waiting, None
        if worker is not None:
            worker.process.kill()
            worker.process.join(1.0)
            worker.pipe.close()
