"""What is asked: the task and the kind of problem, what it means, and what stayed when it changed."""

from __future__ import annotations

import functools
import json

from nicegui import ui

from winkler.study.chapters.contents import CHAPTERS, answers
from winkler.study.finding.finding import find
from winkler.study.language.catalogue import kinds
from winkler.study.language.explain import summary
from winkler.study.language.fit_study import FITTED
from winkler.study.report.markup import safe
from winkler.web.form.study_form import TASKS, StudyForm

OPTION = """
<q-item v-bind="props.itemProps" :aria-label="props.opt.label">
  <q-item-section><q-item-label v-text="props.opt.label"></q-item-label></q-item-section>
  <q-item-section side class="chapter" v-text="({})[props.opt.label]"></q-item-section>
</q-item>
"""
"""A kind in the list, with its chapter."""


@functools.cache
def _chapters() -> dict[str, str]:
    """Return kind -> name of its chapter, chapter by chapter."""
    pairs = [(kind, chapter.physics) for chapter in CHAPTERS for kind in chapter.answers]
    order = list(dict.fromkeys(physics for _, physics in pairs))
    return dict(sorted(pairs, key=lambda pair: order.index(pair[1])))


def _in_words(kind: str) -> str:
    return kind.replace("_", " ")


class FindField(ui.element, component="find.js"):
    """The search among the options of an open list, by their letters and by what people call them."""

    def __init__(self, label: str) -> None:
        super().__init__()
        self.props["label"] = label
        self.on("sought", lambda event: self._answer(str(event.args)))

    def _answer(self, text: str) -> None:
        found = find(text)
        others = [
            f"{_in_words(hit.name)} (a {hit.group})" for hit in found.hits if hit.group not in ("problem", "python")
        ]
        also = f"No problem, but meant as well: {', '.join(others)}." if others else ""
        labels = [_in_words(hit.name) for hit in found.hits]
        self.run_method("found", text, labels, found.remark, also, found.beyond is not None)


class Question:
    """The choice of task and problem.

    Parameters
    ----------
    entered
        The study.
    """

    def __init__(self, entered: StudyForm) -> None:
        self.entered = entered
        self.task = ui.toggle(TASKS, value=entered.task).props("no-caps unelevated spread").classes("task")
        self.task.props["aria-label"] = "what to do"
        self.task.on_value_change(lambda event: entered.switch_task(event.value))
        # all kinds stand in the list at once: one that is far away can be found and read aloud, too
        drawn = "outlined options-dense virtual-scroll-slice-size=500"
        self.choice = ui.select({}, label="problem").props(drawn).classes("problem")
        labels = json.dumps({_in_words(kind): chapter for kind, chapter in _chapters().items()})
        self.choice.add_slot("option", OPTION.format(safe(labels)))
        self.choice.props["data-choice"] = "problem"
        with self.choice.add_slot("before-options"):
            FindField("Find by name, chapter, word or question")
        self.meaning = ui.label().classes("meaning")
        self.choice.on_value_change(lambda event: entered.choose("problem", event.value) if event.value else None)
        with ui.element("div").classes("carried") as self.carried:
            self.said = ui.label().props('role="status"')
            ui.button("Take the example instead", on_click=lambda: entered.take_example()).props("flat dense no-caps")

    def show(self, kind: str) -> None:
        """Show the task and the kind of the study."""
        fits = self.entered.task == "fit"
        self.task.set_value(self.entered.task)
        self.choice.set_options({name: _in_words(name) for name in (FITTED if fits else _chapters())}, value=kind)
        self.choice.props["label"] = "model of the curve" if fits else "problem"
        self.meaning.text = summary(kinds()[kind].cls) if fits else answers()[kind].question
        self.said.text = self.entered.carried_remark
        self.carried.set_visibility(bool(self.entered.carried_remark))
