"""``winkler show nanoindentation``: what ``[indentation]``, ``[calibration]`` and ``[indenter]`` take."""

from __future__ import annotations

from winkler.cli.streams import until_closed

EXAMPLES = """\
[indentation]
curve = "steel/*.csv"
poisson = 0.3
indenter = "results/calibrate_indenter/indenter.toml"

and the study that calibrates the indenter:

[calibration]

[[calibration.reference]]
name = "fused silica"
curve = "silica/*.csv"
young = "72 GPa"
poisson = 0.17
young_error = "0.6 GPa"
"""


@until_closed()
def show_nanoindentation() -> None:
    """Print the keys of all sections."""
    from winkler.cli import terminal

    out = terminal.console()
    table = terminal.table("section", "key", "unit", "meaning")
    for section, rows in nanoindentation_json().items():
        for number, row in enumerate(rows):
            table.add_row("" if number else section, row["key"], row["unit"], row["meaning"])
        table.add_section()
    out.print(table)
    out.print("Examples:\n")
    out.print(EXAMPLES, soft_wrap=True, markup=False)
    out.print(
        "`winkler fit STUDY` evaluates them; docs/experiments/nanoindentation.md explains the rest.", markup=False
    )


def nanoindentation_json() -> dict[str, list[dict[str, str]]]:
    """Return the same as JSON."""
    from winkler.study.nanoindentation.keys import MEANINGS, UNITS

    return {
        section: [{"key": key, "unit": UNITS[section][key] or "", "meaning": line} for key, line in rows.items()]
        for section, rows in MEANINGS.items()
    }
