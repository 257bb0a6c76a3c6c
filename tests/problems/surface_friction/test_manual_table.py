"""The manual's table of springs under friction is what the benchmark prints."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]
PAGE = ROOT / "docs" / "chapters" / "surfaces" / "surface-friction.md"


def script():
    spec = importlib.util.spec_from_file_location("reduced_friction", ROOT / "benchmarks" / "reduced_friction.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def stated():
    """Return name, Poisson's ratio, both ratios of stiffness and both errors of each row of the table."""
    text = PAGE.read_text(encoding="utf-8").split("| map | Poisson's ratio |")[1].split("\n\n")[0]
    for line in text.splitlines()[2:]:
        name, *numbers = (part.strip() for part in line.strip("|").split("|"))
        yield name, *(float(number.removesuffix(" %")) for number in numbers)


def test_the_table_has_all_maps():
    module, rows = script(), list(stated())
    assert [row[:2] for row in rows] == [(name, poisson) for name in module.maps() for poisson in module.POISSON]


@pytest.mark.few(0, slow=3)
@pytest.mark.parametrize("row", range(12))
def test_the_table_is_what_is_measured(row):
    name, poisson, *numbers = list(stated())[row]
    along, across, shift, loss = script().errors(name, poisson)
    assert numbers[:2] == pytest.approx([along, across], abs=6e-4)
    assert numbers[2:] == pytest.approx([100.0 * shift, 100.0 * loss], rel=0.05, abs=0.006)
