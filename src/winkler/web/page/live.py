"""Text of the page that changes with every move of a slider."""

from __future__ import annotations

from nicegui import ui

__all__ = ["LiveHtml"]


class LiveHtml(ui.element, component="live.js"):
    """HTML that is replaced without a new look at the rest of the page."""

    content = ""
    around = (True, True)

    def set_content(self, content: str) -> None:
        """Replace the HTML, unless it is the same."""
        if content == self.content:
            return
        self.content = content
        with self.props.suspend_updates():
            self.props["first"] = content
        self.run_method("show", content)

    def show_state(self, word: str) -> None:
        """Set the state of the enclosing answer."""
        self.run_method("mark", word)

    def show_around(self, *, visible: bool, button: bool) -> None:
        """Show or hide the enclosing element, and the button in it."""
        if (visible, button) != self.around:
            self.around = (visible, button)
            self.run_method("showAround", visible, button)
