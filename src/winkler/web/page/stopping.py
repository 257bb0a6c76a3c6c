"""The end of a running request: by hand, at the limit of time, or of a batch of fits after the present curve."""

from __future__ import annotations

import time

from winkler.web.page.result import Result
from winkler.web.session.requests import RequestQueue
from winkler.web.session.solver import Solver, no_process


class Stopping:
    """Stops the requests of a page.

    Parameters
    ----------
    limit
        The longest that a study, or one curve of a batch, may take [s].
    solver, requests
        What runs, and what waits.
    """

    result: Result
    """What shows that something runs; set as soon as it is drawn."""

    def __init__(self, limit: float, solver: Solver, requests: RequestQueue) -> None:
        self.limit, self.solver, self.requests = limit, solver, requests
        self.progress = 0.0

    def progressed(self) -> None:
        """Note that a curve of a batch was fitted, or points were solved."""
        self.progress = time.monotonic()

    def tick(self) -> None:
        """Update the elapsed time, and stop at the limit; of a batch each curve may take so long."""
        alone = self.solver.seconds
        self.result.show_elapsed(alone, ready=not self.solver.starting)
        if self.result.batch:
            alone = min(alone, time.monotonic() - self.progress)
        if alone > self.limit:
            late = f"The study took longer than {self.limit:g} s and was stopped"
            self.stop(f"{late}; ask for less, or run it on the command line.")

    def by_hand(self) -> None:
        """Stop the running request; of a batch what was fitted stays, unless this is the second time."""
        if self.result.batch and not self.result.halting:
            self.result.halting = True
            self.solver.halt()
        else:
            self.stop()

    def stop(self, why: str = "Stopped.") -> None:
        """Stop the running request, and say why."""
        self.requests.clear()
        try:
            self.solver.stop()
        except OSError as error:
            why = f"{why} {no_process(error)}"
        self.result.refuse([why], beside=False)
