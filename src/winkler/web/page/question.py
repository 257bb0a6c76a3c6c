"""What is asked: the task and the kind of problem, what it means, and what stayed when it changed."""

from __future__ import annotations

from nicegui import ui

from winkler.study.language.catalogue import CATALOGUE, kinds
from winkler.study.language.explain import summary
from winkler.study.language.fit_reading import FITTED
from winkler.web.form.study_form import TASKS, StudyForm

__all__ = ["Question"]


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
        self.choice = ui.select({}, label="problem").props("outlined options-dense").classes("problem")
        self.choice.props["data-choice"] = "problem"
        self.meaning = ui.label().classes("meaning")
        self.choice.on_value_change(lambda event: entered.choose("problem", event.value) if event.value else None)
        with ui.element("div").classes("carried") as self.carried:
            self.said = ui.label().props('role="status"')
            ui.button("Take the example instead", on_click=lambda: entered.take_example()).props("flat dense no-caps")

    def show(self, kind: str) -> None:
        """Show the task and the kind of the study."""
        fits = self.entered.task == "fit"
        self.task.set_value(self.entered.task)
        names = {name: name.replace("_", " ") for name in (FITTED if fits else CATALOGUE["problem"])}
        self.choice.set_options(names, value=kind)
        self.choice.props["label"] = "model of the curve" if fits else "problem"
        self.meaning.text = summary(kinds()[kind].cls)
        self.said.text = self.entered.carried_remark
        self.carried.set_visibility(bool(self.entered.carried_remark))
