"""The end of a running request: by hand, at the limit of time, or of a batch of fits after the present curve."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

from winkler.web.session.solver import no_process

if TYPE_CHECKING:
    from winkler.web.page.page import Page

__all__ = ["Stopping"]


class Stopping:
    """Stops the requests of a page.

    Parameters
    ----------
    page
        The page.
    """

    def __init__(self, page: Page) -> None:
        self.page = page
        self.progress = 0.0

    def progressed(self) -> None:
        """Note that a curve of a batch was fitted, or points were solved."""
        self.progress = time.monotonic()

    def tick(self) -> None:
        """Update the elapsed time, and stop at the limit; of a batch each curve may take so long."""
        page = self.page
        page.result.show_elapsed(page.solver.seconds, ready=not page.solver.starting)
        alone = page.solver.seconds
        if page.result.batch:
            alone = min(alone, time.monotonic() - self.progress)
        if alone > page.limit:
            late = f"The study took longer than {page.limit:g} s and was stopped"
            self.stop(f"{late}; ask for less, or run it on the command line.")

    def by_hand(self) -> None:
        """Stop the running request; of a batch what was fitted stays, unless this is the second time."""
        result = self.page.result
        if result.batch and not result.halting:
            result.halting = True
            self.page.solver.halt()
        else:
            self.stop()

    def stop(self, why: str = "Stopped.") -> None:
        """Stop the running request, and say why."""
        page = self.page
        page.requests.clear()
        try:
            page.solver.stop()
        except OSError as error:
            why = f"{why} {no_process(error)}"
        page.result.refuse([why], beside=False)
