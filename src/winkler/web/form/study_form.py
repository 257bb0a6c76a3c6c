"""The edited study: its table and all changes that the form can make to it, independent of the browser."""

from __future__ import annotations

import copy
import re
from collections.abc import Callable, Collection
from pathlib import Path
from typing import Any

from winkler.study.language.explain import completed
from winkler.study.language.fit_study import FITTED
from winkler.web.form import fit_form, form, measurement_form, sweep_form
from winkler.web.form.carry import PutAside, carried, content_at, content_leaves, is_sound, leaves, named_numbers
from winkler.web.form.form import FormEntry
from winkler.web.form.front_examples import first_table
from winkler.web.form.materials_menu import NAMED, material_numbers
from winkler.web.form.ranges import is_range, range_content
from winkler.web.form.sample_curve import SAMPLE, sample_of
from winkler.web.form.typed import typed

NOTHING = PutAside({}, {})
UNITS = "fit.units."
"""Beginning of the keys of units of columns."""
TASKS = {"solve": "Solve a problem", "fit": "Fit a curve"}
"""Tasks with their labels."""


class StudyForm:
    """The study of one page.

    Parameters
    ----------
    changed
        Called when the form must be rebuilt.
    solve
        Called when only a value has changed.
    folder
        Where the files of the study are.
    """

    def __init__(self, changed: Callable[[], None], solve: Callable[[], None], folder: Path | None = None) -> None:
        self.changed, self.solve, self.folder = changed, solve, folder or Path()
        self.carried_remark = ""
        """What stayed when the question changed, and what did not."""
        self._aside: dict[str, PutAside] = {}
        self._came: frozenset[str] = frozenset()
        self._parts: dict[tuple[str, str], PutAside] = {}
        """Path and kind -> the part of that kind that another one has replaced."""
        self.table: dict[str, Any] = first_table()
        self.assumed: dict[str, Any] = leaves(self.table["problem"])
        """Path -> content of what nobody has given: what an example says."""
        self.other_table: dict[str, Any] = fit_form.initial_table(FITTED[0])
        self._of_other = (leaves(self.other_table["problem"]), *self._put_aside())
        self.target = ""
        """Path for which the next upload is meant."""

    @property
    def task(self) -> str:
        """One of `TASKS`."""
        return "fit" if "fit" in self.table else "solve"

    def switch_task(self, task: str) -> None:
        """Switch to the other task, and keep the study of this one."""
        if task in TASKS and task != self.task:
            self._switch()
            self.carried_remark = ""
            self.changed()

    def _switch(self) -> None:
        """Exchange the studies of both tasks, with what was assumed and put aside."""
        self.table, self.other_table = self.other_table, self.table
        before = (self.assumed, self._aside, self._came, self._parts)
        (self.assumed, self._aside, self._came, self._parts), self._of_other = self._of_other, before

    @staticmethod
    def _put_aside() -> tuple[dict[str, PutAside], frozenset[str], dict[tuple[str, str], PutAside]]:
        """Return what is put aside of a study that nobody has changed."""
        return {}, frozenset(), {}

    def load(self, table: dict[str, Any], assumed: Collection[str] = ()) -> None:
        """Replace the whole study; `assumed` are the paths of what nobody has given."""
        if ("fit" in table) != ("fit" in self.table):
            self._switch()
        self.table, self.carried_remark = table, ""
        self.assumed = {path: content for path, content in content_leaves(table).items() if path in assumed}
        self.changed()

    def load_edited(self, table: dict[str, Any]) -> None:
        """Replace the study by an edited one: what nobody has given, and is as before, is still nobody's."""
        before = self.still_assumed if ("fit" in table) == ("fit" in self.table) else {}
        self.load(table, [path for path, content in before.items() if content_at(table, path) == content])

    def take_example(self) -> None:
        """Replace the study by the example of its problem."""
        self.begin_with(self._example(str(self.table["problem"]["kind"])))

    def begin_with(self, example: dict[str, Any]) -> None:
        """Replace the study by an example, of which nobody has given a number."""
        self._aside, self._came, self._parts = self._put_aside()
        self.load(example, leaves(example["problem"]))

    def is_assumed(self, path: str) -> bool:
        """Return whether a key holds what an example says, and nobody has given."""
        return path in self.assumed and self.assumed[path] == content_at(self.table, path)

    @property
    def still_assumed(self) -> dict[str, Any]:
        """Path -> content of what nobody has given until now."""
        return {path: content for path, content in self.assumed.items() if self.is_assumed(path)}

    @property
    def assumed_sentence(self) -> str:
        """Which numbers are an example's, in a sentence; empty if none is."""
        started = form.at(self.table, "fit.free") or {}  # of which the curve decides
        named = named_numbers({path: one for path, one in self.still_assumed.items() if path not in started})
        return f"Not yours, but an example's: {named}." if named else ""

    def _of_an_example(self, path: str, before: dict[str, Any], known: PutAside = NOTHING) -> None:
        """Remember what came with a kind that was chosen: its numbers, not itself, nor what was known of them."""
        given = {one: content for one, content in leaves(known.content, path).items() if one not in known.assumed}
        came = leaves(form.at(self.table, path), path)
        self.assumed |= {one: item for one, item in came.items() if item not in (before.get(one), given.get(one))}
        self.assumed.pop(f"{path}.kind", None)

    def _example(self, kind: str) -> dict[str, Any]:
        if self.task == "solve":
            return form.initial_table(kind)
        table = fit_form.initial_table(kind)
        table["fit"] |= measurement_form.kept(self.table)
        table["fit"]["curve"] = sample_of(table["fit"]["curve"], fit_form.OWN_SAMPLES.get(kind, SAMPLE))
        return table

    def _ask(self, kind: str) -> None:
        """Ask another question: what fits stays, of examples, too, so that no question changes a body."""
        before, after = self.table, self._example(kind)
        checked = is_sound(after, self.folder)  # not without a curve
        sound = lambda table: not checked or is_sound(table, self.folder)  # noqa: E731
        carry = carried(before, after, self._aside, sound, self.assumed, self._came)
        self.table, self._aside, self.assumed, self._came = carry.table, carry.aside, carry.assumed, carry.came
        sentence = carry.sentence
        usual = self._example(str(before["problem"]["kind"]))["title"]
        if before.get("title", usual) != usual:  # one's own
            self.table["title"] = before["title"]
        if "sweep" in before:
            before = before | {"sweep": {carry.moved(key): one for key, one in before["sweep"].items()}}
        sections = [name for name in before if name not in ("title", "problem", "fit")]
        lost = [name for name in sections if not self._keep_section(name, before)]
        self.carried_remark = f"{sentence} Left out: [{'], ['.join(lost)}].".strip() if lost else sentence

    def _keep_section(self, name: str, before: dict[str, Any]) -> bool:
        """Keep a section of the study before, if the new one is sound with it; return whether it is."""
        self.table[name] = copy.deepcopy(before[name])
        self._drop_missing_keys()
        if name in self.table and not is_sound(self.table, self.folder):
            del self.table[name]
        return name in self.table

    def content(self, path: str) -> Any:
        """Return the content of a key."""
        return form.at(self.table, path)

    def choose(self, path: str, kind: str) -> None:
        """Set a kind at a path; an empty one removes it."""
        if kind == str((form.at(self.table, path) or {}).get("kind", "")):
            return
        self.carried_remark = ""
        if path == "problem":
            self._ask(kind)
        else:
            self._choose_part(path, kind)
        self._drop_missing_keys()
        self.changed()

    def _choose_part(self, path: str, kind: str) -> None:
        """Put the former part of a kind to a path, or that of an example; an empty kind removes the part."""
        before, part = leaves(self.table["problem"]), form.at(self.table, path)
        known = self._known(path, kind, part) if kind else NOTHING
        if isinstance(part, dict):
            not_given = {one: item for one, item in leaves(part, path).items() if self.is_assumed(one)}
            self._parts[path, str(part.get("kind"))] = PutAside(copy.deepcopy(part), not_given)
        if not kind:
            form.drop(self.table, path)
            return
        form.choose_kind(self.table, path, kind, copy.deepcopy(known.content))
        self._of_an_example(path, before, known)

    def _known(self, path: str, kind: str, part: Any) -> PutAside:
        """Return the numbers of a part that are not an example's: those of a named material, or of its last time."""
        is_named = isinstance(part, dict) and part.get("kind") == f"{NAMED}{kind}"
        if is_named and not (self.is_assumed(f"{path}.name") and (path, kind) in self._parts):
            return PutAside(material_numbers(kind, str(part.get("name"))), {})
        return self._parts.get((path, kind), NOTHING)

    def _drop_missing_keys(self) -> None:
        """Remove free and varied keys that are no longer in the problem."""
        for section in (form.at(self.table, "fit.free"), self.table.get("sweep")):
            if not isinstance(section, dict):
                continue
            for key in [*section]:
                plain = re.sub(r"\[(\d+)\]", r".\1", key)
                if plain.startswith("problem.") and form.at(self.table, plain) is None:
                    del section[key]
        if set(self.table.get("sweep", ())) == {"design"} or self.table.get("sweep") == {}:
            del self.table["sweep"]

    def change(self, path: str, text: str, takes: str) -> None:
        """Set the typed content of a key; an empty text removes it."""
        content = typed(text, takes) if text.strip() else None
        if content == form.at(self.table, path):
            return
        self.assumed.pop(path, None)
        if path.startswith(UNITS):
            self.table["fit"].setdefault("units", {})
        if content is None:
            form.drop(self.table, path)
        else:
            form.put(self.table, path, content)
        if self.task == "fit" and self.table["fit"].get("units") == {}:
            del self.table["fit"]["units"]
        self.solve()

    def give_range(self, entry: FormEntry, spacing: str, texts: dict[str, str], *, anew: bool) -> None:
        """Set the range of a key that may hold several numbers; `anew` if this needs other fields."""
        content, before = range_content(entry, spacing, texts), form.at(self.table, entry.path)
        if content != before:
            form.put(self.table, entry.path, content)
            if not is_range(before) and is_range(content):
                self.assumed |= leaves(content, entry.path)  # twice and half of the number
            (self.changed if anew else self.solve)()

    def give_one(self, path: str) -> None:
        """Replace the range of a key by its upper end."""
        form.put(self.table, path, (form.at(self.table, path) or {}).get("to", ""))
        self.changed()

    def choose_option(self, path: str, word: str) -> None:
        """Choose an option of the measurement, which may change other fields."""
        if word == str(form.at(self.table, path) or ""):
            return
        if word:
            form.put(self.table, path, word)
        else:
            form.drop(self.table, path)
        self.changed()

    def add(self, path: str, kind: str) -> None:
        """Add a kind to a list."""
        before = leaves(self.table["problem"])
        parts = [*(form.at(self.table, path) or []), completed({"kind": kind})]
        form.put(self.table, path, parts)
        self._of_an_example(f"{path}.{len(parts) - 1}", before)
        self.changed()

    def pick(self, path: str) -> None:
        """Set the path for which the next upload is meant."""
        self.target = path

    def read(self, path: str, name: str) -> None:
        """Replace numbers by a file; an empty name restores numbers."""
        kind, before = str(form.at(self.table, path)["kind"]), leaves(self.table["problem"])
        form.put(self.table, path, {"kind": kind, "file": name} if name else completed({"kind": kind}))
        if not name:
            self._of_an_example(path, before)
        self.changed()

    def read_curve(self, name: str) -> None:
        """Fit another curve.

        No field depends on it: a form that were rebuilt when an upload arrives would lose what is being typed.
        """
        form.put(self.table, fit_form.CURVE, name)
        self.solve()

    # ------------------------------------------------------------------------------------------------- of a fit

    def free(self, key: str) -> None:
        """Free one more parameter."""
        self.table["fit"].setdefault("free", {})[key] = True
        self.changed()

    def fix(self, key: str) -> None:
        """Fix a parameter at the value of the model."""
        del self.table["fit"]["free"][key]
        self.changed()

    def bound(self, key: str, low: str, high: str, unit: str) -> None:
        """Set the bounds of a free parameter."""
        content = fit_form.bounds(low, high, unit)
        if content != self.table["fit"]["free"][key]:
            self.table["fit"]["free"][key] = content
            self.solve()

    # ----------------------------------------------------------------------------------------------- of a sweep

    def vary(self, key: str) -> None:
        """Vary one more number."""
        sweep_form.add(self.table, key)
        self.assumed[f"sweep.{key}"] = copy.deepcopy(self.table["sweep"][key])
        self.changed()

    def hold_constant(self, key: str) -> None:
        """Stop varying a number."""
        sweep_form.remove_key(self.table, key)
        self.changed()

    def vary_over(self, key: str, spacing: str, texts: dict[str, str], *, anew: bool) -> None:
        """Set the range of a varied number; `anew` if this needs other fields."""
        before = self.table["sweep"][key]
        sweep_form.set_range(self.table, key, spacing, texts)
        if self.table["sweep"][key] != before:
            (self.changed if anew else self.solve)()

    def choose_design(self, kind: str) -> None:
        """Choose the design of the sweep."""
        if kind != sweep_form.design_kind(self.table):
            sweep_form.change_design(self.table, kind)
            self.changed()
