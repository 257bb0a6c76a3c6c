"""Put a run of the benchmarks into docs/benchmarks.md.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only --benchmark-json=run.json
and      python benchmarks/table.py run.json
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

from pages import machine, replace, spoken, table


def main(path: str) -> None:
    """Write the table of one run."""
    run = json.loads(Path(path).read_text(encoding="utf-8"))
    rows = []
    for item in sorted(run["benchmarks"], key=lambda item: item["fullname"]):
        target = item["extra_info"].get("target")
        rows.append(
            [
                item["extra_info"].get("what", item["name"]),
                spoken(item["stats"]["median"]),
                spoken(item["stats"]["min"]),
                f"< {spoken(target)}" if target else "",
            ]
        )
    text = table(["what", "median", "fastest", "target"], rows)
    print(text)
    replace("times", f"{text}\n\nMeasured on {machine()}.")


if __name__ == "__main__":
    main(sys.argv[1])
