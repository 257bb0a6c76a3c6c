"""The commands of the command line, and the options common to them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Annotated, Any

import typer

from winkler.cli import browser, cite, draw, export, fit, new, report, run, show, table, validate
from winkler.cli.streams import write_line

EXAMPLES = """Examples:

winkler new indentation --profile cone  (writes a commented study)

winkler run indentation.toml  (numbers, figures and a report in results/indentation)

winkler fit gel.toml  (the numbers of a model from measured force curves)

winkler show rounded_cone  (the keys of a kind, with units and an example)
"""

app = typer.Typer(
    name="winkler",
    help="Contact mechanics by the method of dimensionality reduction: from a study file to results and figures.",
    epilog=EXAMPLES,
    no_args_is_help=True,
    rich_markup_mode="rich",
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def _version(wanted: bool) -> None:
    if wanted:
        from importlib.metadata import version

        write_line(f"winkler {version('winkler')}")
        raise typer.Exit


@app.callback()
def common(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Show the version and exit.")
    ] = False,
    traceback: Annotated[
        bool, typer.Option("--traceback", help="Show where an unexpected error came from; works with every command.")
    ] = False,
) -> None:
    """Take the options that stand before a command."""


FUNCTIONS: dict[str, Callable[..., Any]] = {
    "run": run.run,
    "merge": run.merge,
    "fit": fit.fit,
    "show": show.show,
    "report": report.report,
    "draw": draw.draw,
    "table": table.table,
    "export": export.export,
    "new": new.new,
    "schema": new.schema,
    "cite": cite.cite,
    "validate": validate.validate,
    "app": browser.app,
}
"""The commands in the order of the help."""


class _Commands(Mapping[str, Any]):
    """The commands by their names, each made of its function when it is first needed."""

    def __init__(self) -> None:
        self._made: dict[str, Any] = {}

    def __getitem__(self, name: str) -> Any:
        if name not in self._made:
            alone = typer.Typer(rich_markup_mode="rich", pretty_exceptions_enable=False, add_completion=False)
            alone.command(name)(FUNCTIONS[name])
            self._made[name] = typer.main.get_command(alone)
        return self._made[name]

    def __iter__(self) -> Iterator[str]:
        return iter(FUNCTIONS)

    def __len__(self) -> int:
        return len(FUNCTIONS)


command: Any = typer.main.get_command(app)
"""All commands, built once: a program that calls `main` many times does not build them each time."""
command.commands = _Commands()
