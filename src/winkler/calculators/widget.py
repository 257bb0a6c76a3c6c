"""A calculator in a Jupyter notebook: the sliders of the page, with the study as the value."""

from __future__ import annotations

import functools
from typing import Any

from winkler.calculators.calculator import Calculator
from winkler.calculators.catalogue import CALCULATORS, calculator
from winkler.calculators.evaluate import answer_of, study_text_of, values_of
from winkler.calculators.single_page import HERE, described, joined_script, module_text
from winkler.values.errors import InvalidInput, suggest

__all__ = ["widget"]

RENDER = """
export default {
  async render({ model, el }) {
    const run = await kernelsOf(fromBase64(model.get("module")));
    const holder = document.createElement("div");
    holder.className = "holder";
    el.classList.add("calculators");
    el.append(holder);
    const one = model.get("calculator");
    let own = false;
    const panel = new Panel(holder, one, run, (values) => {
      own = true;
      model.set("values", Object.fromEntries(one.sliders.map(({ name }, k) => [name, values[k]])));
      model.save_changes();
      own = false;
    }, model.get("values"));
    const follow = () => {
      if (own) return;
      const given = model.get("values");
      one.sliders.forEach(({ name }, k) => (panel.values[k] = given[name] ?? panel.values[k]));
      panel.later();
    };
    model.on("change:values", follow);
    return () => model.off("change:values", follow);
  },
};
"""


def widget(name: str = "normal", **values: float) -> Any:
    """Return a calculator for a Jupyter notebook: sliders, numbers and a curve, with the study as its value.

    Its `value` is the text of the study file for the current sliders, `answer` the results in SI units. `values` are
    the slider values in their units; you can assign them. Needs: ``pip install winkler[widget]``.

    Parameters
    ----------
    name : str, optional
        One of normal, graded, viscoelastic, adhesion, roughness, tangential, torsion, damping, rolling, heating,
        conduction, wear.
    **values : float
        Initial values of sliders in their units: ``winkler.widget("adhesion", work=80.0)`` for 80 mJ/m^2.

    Returns
    -------
    anywidget.AnyWidget

    Raises
    ------
    InvalidInput
        If there is no such calculator or slider, a number is outside its range, or anywidget is not installed.
    """
    known = [one.name for one in CALCULATORS]
    if name not in known:
        raise InvalidInput(f"widget: '{name}' is not known{suggest(name, known)}; give one of {', '.join(known)}.")
    one = calculator(name)
    return _class()(one, values_of(one, values))


@functools.cache
def _class() -> type[Any]:
    """Return the class, made when the first widget is: anywidget is an extra."""
    try:
        import anywidget
        import traitlets
    except ImportError:
        raise InvalidInput("widget: this needs anywidget; pip install winkler[widget].") from None

    class CalculatorWidget(anywidget.AnyWidget):  # type: ignore[misc]
        """Sliders of one calculator."""

        _esm = joined_script(("reading", "chart", "calculators")) + RENDER
        _css = (HERE / "calculators.css").read_text(encoding="utf-8")
        module = traitlets.Unicode().tag(sync=True)
        calculator = traitlets.Dict().tag(sync=True)
        values = traitlets.Dict().tag(sync=True)
        value = traitlets.Unicode(read_only=True)
        answer = traitlets.Dict(read_only=True)

        def __init__(self, one: Calculator, values: dict[str, float]) -> None:
            self.one = one
            super().__init__(module=module_text(), calculator=described(one), values=values)
            self._solve()

        @traitlets.validate("values")  # type: ignore[untyped-decorator]
        def _within(self, proposal: Any) -> dict[str, float]:
            return values_of(self.one, proposal["value"])

        @traitlets.observe("values")  # type: ignore[untyped-decorator]
        def _changed(self, change: Any) -> None:
            self._solve()

        def _solve(self) -> None:
            self.set_trait("answer", answer_of(self.one, self.values))
            self.set_trait("value", study_text_of(self.one, self.values))

    return CalculatorWidget
