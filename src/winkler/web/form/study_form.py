"""What is asked: the table of a study, and everything that a person may change in it; nothing here knows a browser."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from winkler.study.language.explain import completed
from winkler.study.language.fit_reading import FITTED
from winkler.web.form import fit_form, form, sweep_form
from winkler.web.form.typed import typed

__all__ = ["FIRST", "TASKS", "StudyForm"]

FIRST = "indentation"
TASKS = {"solve": "Solve a problem", "fit": "Fit a curve"}
"""What can be done, in words."""


class StudyForm:
    """The study of one page.

    Parameters
    ----------
    changed
        Called when the form must be made anew.
    solve
        Called when only a number is another one.
    """

    def __init__(self, changed: Callable[[], None], solve: Callable[[], None]) -> None:
        self.changed, self.solve = changed, solve
        self.table: dict[str, Any] = form.begun(FIRST)
        self.aside: dict[str, Any] = fit_form.begun(FITTED[0])
        self.target = ""
        """Where the next upload belongs."""

    @property
    def task(self) -> str:
        """One of `TASKS`."""
        return "fit" if "fit" in self.table else "solve"

    def turn(self, task: str) -> None:
        """Turn to the other task; the study of this one is kept aside."""
        if task in TASKS and task != self.task:
            self.table, self.aside = self.aside, self.table
            self.changed()

    def take(self, table: dict[str, Any]) -> None:
        """Take a whole study."""
        if ("fit" in table) != ("fit" in self.table):
            self.aside = self.table
        self.table = table
        self.changed()

    def choose(self, path: str, kind: str) -> None:
        """Put a kind at a place; an empty one leaves it out."""
        if kind == str((form.at(self.table, path) or {}).get("kind", "")):
            return
        if path == "problem" and self.task == "fit":
            curve = form.at(self.table, "fit.curve")
            self.table = fit_form.begun(kind)
            form.put(self.table, "fit.curve", curve)
        elif kind:
            form.chosen(self.table, path, kind)
        else:
            form.drop(self.table, path)
        if path == "problem":
            self.table = {name: self.table[name] for name in ("title", "problem", "fit") if name in self.table}
        self._only_there()
        self.changed()

    def _only_there(self) -> None:
        """Take what is no longer in the problem out of what is free, and of what varies."""
        for held in (form.at(self.table, "fit.free"), self.table.get("sweep")):
            if not isinstance(held, dict):
                continue
            for key in [*held]:
                plain = re.sub(r"\[(\d+)\]", r".\1", key)
                if plain.startswith("problem.") and form.at(self.table, plain) is None:
                    del held[key]
        if set(self.table.get("sweep", ())) == {"design"} or self.table.get("sweep") == {}:
            del self.table["sweep"]

    def change(self, path: str, text: str, takes: str) -> None:
        """Put what was typed at a key; nothing leaves it out."""
        content = typed(text, takes) if text.strip() else None
        if content == form.at(self.table, path):
            return
        if content is None:
            form.drop(self.table, path)
        else:
            form.put(self.table, path, content)
        self.solve()

    def pin(self, path: str, word: str) -> None:
        """Choose one of a few words for a key of the measurement, which changes what else may be said."""
        if word != form.at(self.table, path):
            form.put(self.table, path, word)
            self.changed()

    def add(self, path: str, kind: str) -> None:
        """Add a kind to a list."""
        form.put(self.table, path, [*(form.at(self.table, path) or []), completed({"kind": kind})])
        self.changed()

    def pick(self, path: str) -> None:
        """Say that the next upload belongs to a place."""
        self.target = path

    def read(self, path: str, name: str) -> None:
        """Take a file in place of numbers; an empty name goes back to numbers."""
        if path == "fit.curve":
            form.put(self.table, path, name)
        else:
            kind = str(form.at(self.table, path)["kind"])
            form.put(self.table, path, {"kind": kind, "file": name} if name else completed({"kind": kind}))
        self.changed()

    # ------------------------------------------------------------------------------------------------- of a fit

    def free(self, key: str) -> None:
        """Let the curve tell one more number."""
        self.table["fit"].setdefault("free", {})[key] = True
        self.changed()

    def fix(self, key: str) -> None:
        """Leave a number as the model says."""
        del self.table["fit"]["free"][key]
        self.changed()

    def bound(self, key: str, low: str, high: str, unit: str) -> None:
        """Say between what a free number lies."""
        content = fit_form.bounds(low, high, unit)
        if content != self.table["fit"]["free"][key]:
            self.table["fit"]["free"][key] = content
            self.solve()

    # ----------------------------------------------------------------------------------------------- of a sweep

    def vary(self, key: str) -> None:
        """Let one more number vary."""
        sweep_form.add(self.table, key)
        self.changed()

    def still(self, key: str) -> None:
        """Let a number vary no longer."""
        sweep_form.take_out(self.table, key)
        self.changed()

    def vary_over(self, key: str, way: str, texts: dict[str, str], *, anew: bool) -> None:
        """Say over what a number varies; `anew` where this needs other boxes."""
        before = self.table["sweep"][key]
        sweep_form.put_row(self.table, key, way, texts)
        if self.table["sweep"][key] != before:
            (self.changed if anew else self.solve)()

    def redesign(self, kind: str) -> None:
        """Say which points are solved."""
        if kind != sweep_form.plan(self.table):
            sweep_form.redesigned(self.table, kind)
            self.changed()
