"""Fields whose content the page changes without a new look at its other parts: a number and the slider beside it."""

from __future__ import annotations

import json
from typing import Any

from nicegui import ui
from nicegui.elements.mixins.disableable_element import DisableableElement
from nicegui.elements.mixins.value_element import ValueElement

__all__ = ["LiveInput", "PlaceSlider"]

PUT = """
const field = getElement({id});
if (field && field.inputValue !== {text}) {{
  field.emitting = false;
  field.inputValue = {text};
  field.$nextTick(() => (field.emitting = true));
}}
"""
"""Writes into a field as its own script does; nothing is sent back."""


class PlaceSlider(ValueElement[float], DisableableElement, component="slide.js"):
    """A slider for the places from ``-most`` to ``most`` in steps of one."""

    VALUE_PROP = "value"
    LOOPBACK = None  # it moves by itself

    def __init__(self, most: int) -> None:
        super().__init__(value=0, throttle=0.05)
        self.props.update({"min": -most, "max": most, "step": 1})

    def _handle_value_change(self, value: Any) -> None:
        is_mine, self._send_update_on_value_change = self._send_update_on_value_change, False
        super()._handle_value_change(value)
        self._send_update_on_value_change = is_mine
        if is_mine:
            self.run_method("put", value)


class LiveInput(ui.input):
    """A text field."""

    def _handle_value_change(self, value: Any) -> None:
        is_mine, self._send_update_on_value_change = self._send_update_on_value_change, False
        super()._handle_value_change(value)
        self._send_update_on_value_change = is_mine
        if is_mine:
            self.client.run_javascript(PUT.format(id=self.id, text=json.dumps(value or "")))
