"""Put a run of the benchmarks into docs/benchmarks.md: one table for each group of them.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only --benchmark-json=run.json
and      python benchmarks/table.py run.json

A group of which the run holds nothing keeps its table.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

from pages import in_words, machine, replace, table

GROUPS = {
    "times": ("bench_fields", "bench_indentation", "bench_measured"),
    "times-media": ("bench_coated", "bench_graded"),
    "times-films": ("bench_films",),
    "times-contacts": (
        "bench_adhesion",
        "bench_adhesive_cycle",
        "bench_contacts",
        "bench_fit",
        "bench_fit_models",
        "bench_friction",
        "bench_impact",
    ),
    "times-histories": (
        "bench_conduction",
        "bench_heating",
        "bench_rolling",
        "bench_viscoelastic",
        "bench_viscoelastic_fits",
        "bench_wear",
    ),
    "times-lines": ("bench_ellipse", "bench_roller"),
    "times-surfaces": (
        "bench_profile_pair",
        "bench_subsurface",
        "bench_surface_friction",
        "bench_surface_heating",
        "bench_surface_rolling",
    ),
}
"""Table of the page -> the files of its benchmarks."""
LINES, OTHERS = "times-lines", "times-tools"
"""Where the files are whose name begins with bench_line, and all others."""


def group_of(fullname: str) -> str:
    """Return the table that a benchmark belongs to, by its file."""
    file = Path(fullname.partition("::")[0]).stem
    fallback = LINES if file.startswith("bench_line") else OTHERS
    return next((group for group, files in GROUPS.items() if file in files), fallback)


def main(path: str) -> None:
    """Write the tables of one run."""
    run = json.loads(Path(path).read_text(encoding="utf-8"))
    rows: dict[str, list[list[str]]] = {}
    for item in sorted(run["benchmarks"], key=lambda item: item["fullname"]):
        target = item["extra_info"].get("target")
        rows.setdefault(group_of(item["fullname"]), []).append(
            [
                item["extra_info"].get("what", item["name"]),
                in_words(item["stats"]["median"]),
                in_words(item["stats"]["min"]),
                f"< {in_words(target)}" if target else "",
            ]
        )
    for group, lines in rows.items():
        text = table(["what", "median", "fastest", "target"], lines)
        print(text, end="\n\n")
        replace(group, f"{text}\n\nMeasured on {machine()}.")


if __name__ == "__main__":
    main(sys.argv[1])
