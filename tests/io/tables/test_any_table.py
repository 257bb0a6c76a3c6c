"""A good table is renamed, transposed, given other units, interleaved, blanked and cut: the numbers stay, or a refusal.

Each drawn text holds one and the same table of a force curve, a nanoindentation, moduli or a scan.  A reader may
refuse it by name; what it returns are the numbers of the table, of a text that was cut those of its first rows.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from winkler.io.curves import UnreadCurve, try_curves
from winkler.io.tables.relaxation_table import read_dynamic
from winkler.io.tables.scan_table import read_scan
from winkler.values.errors import InvalidInput

ROWS = 60
ALONG, BACK = np.linspace(0.0, 1.0, ROWS + 1)[1:], np.linspace(1.0, 0.0, 30)[1:]
DEPTH = np.r_[300e-9 * ALONG, 200e-9 + 100e-9 * BACK ** (2.0 / 3.0)]
FORCE = np.r_[9e-3 * ALONG**2, 9e-3 * BACK]
TIME = 0.25 * np.arange(1.0, DEPTH.size + 1)
OMEGA = np.geomspace(0.1, 100.0, ROWS)
STORAGE, LOSS = 2e6 * OMEGA**0.2, 4e5 * OMEGA**0.1
PLACE = np.linspace(0.0, 480e-6, 100)
HEIGHT = 1e-6 * np.sin(PLACE / 3e-5) + 2e-7 * np.cos(PLACE / 7e-6)


class Quantity(NamedTuple):
    """A column: its numbers in SI, names that instruments give it, and units with their factors."""

    numbers: np.ndarray
    names: tuple[str, ...]
    units: dict[str, float]


LENGTHS = {"nm": 1e-9, "um": 1e-6, "µm": 1e-6, "mm": 1e-3, "m": 1.0}
FORCES = {"mN": 1e-3, "uN": 1e-6, "N": 1.0, "µN": 1e-6}
SECONDS = {"s": 1.0, "ms": 1e-3}
PASCALS = {"Pa": 1.0, "kPa": 1e3, "MPa": 1e6}
KINDS = {
    "curve": (
        Quantity(DEPTH, ("depth", "Indentation", "Pd", "h", "Displacement Into Surface", "Eindringtiefe"), LENGTHS),
        Quantity(FORCE, ("force", "Load", "Fn", "Load On Sample", "Kraft"), FORCES),
        Quantity(TIME, ("time", "t", "Time On Sample", "Zeit"), SECONDS),
    ),
    "nanoindentation": (
        Quantity(DEPTH, ("Displacement", "Weg", "Position", "Depth"), LENGTHS),
        Quantity(FORCE, ("Load", "P", "Normal force"), FORCES),
        Quantity(TIME, ("Time", "Test time"), SECONDS),
    ),
    "moduli": (
        Quantity(OMEGA, ("omega", "Angular frequency", "w", "Ang. freq."), {"rad/s": 1.0}),
        Quantity(STORAGE, ("G'", "Storage modulus", "G_stor", "Speichermodul"), PASCALS),
        Quantity(LOSS, ("G''", "Loss modulus", "G_loss", "Verlustmodul"), PASCALS),
    ),
    "scan": (
        Quantity(PLACE, ("x", "Lateral", "Distance"), LENGTHS),
        Quantity(HEIGHT, ("z", "height", "raw", "Profile"), LENGTHS),
    ),
}
OTHER = ("Remark", "Kommentar", "Index", "Aux 3", "Sensor", "", "Temperature")


@st.composite
def texts(draw, kind):
    """Draw a text of a table, its encoding, and whether it was cut or transposed."""
    quantities = KINDS[kind]
    separator = draw(st.sampled_from([",", ";", "\t"]))
    comma = separator != "," and draw(st.booleans())
    digits = draw(st.sampled_from(["{:.8g}", "{:.9e}", "{:.12f}"]))
    columns = []
    for one in quantities:
        unit = draw(st.sampled_from(sorted(one.units)))
        scaled = one.numbers / one.units[unit]
        style = "{:.9e}" if digits == "{:.12f}" and np.abs(scaled).max() < 1.0 else digits
        columns.append((draw(st.sampled_from(one.names)), unit, [style.format(x) for x in scaled]))
    for _ in range(draw(st.integers(0, 2))):
        filler = draw(st.sampled_from(["{:d}", "", "n/a", "ok"]))
        cells = [filler.format(row) if filler == "{:d}" else filler for row in range(quantities[0].numbers.size)]
        columns.append((draw(st.sampled_from(OTHER)), draw(st.sampled_from(["", "V", "-"])), cells))
    columns = draw(st.permutations(columns))
    where = draw(st.sampled_from(["brackets", "parentheses", "below", "blank and below"]))
    names = [name for name, _, _ in columns]
    if where in ("brackets", "parentheses"):
        left, right = "[]" if where == "brackets" else "()"
        names = [f"{name} {left}{unit}{right}" if unit else name for name, unit, _ in columns]
    head = [separator.join(names)]
    if "below" in where:
        head += [""] * ("blank" in where) + [separator.join(unit for _, unit, _ in columns)]
    rows = [separator.join(cells) for cells in zip(*(cells for _, _, cells in columns), strict=True)]
    if comma:
        rows = [row.replace(".", ",") for row in rows]
    for place in sorted(draw(st.lists(st.integers(1, len(rows) - 1), max_size=2)), reverse=True):
        rows.insert(place, draw(st.sampled_from(["", separator * (len(columns) - 1)])))
    above = draw(st.lists(st.sampled_from(["Sample A", "Date: 3.4.2024", "# made by hand", ""]), max_size=3))
    lines = [*above, *head, *rows]
    change = draw(st.sampled_from(["none", "none", "none", "cut", "transposed"]))
    if change == "transposed":
        lines = [separator.join([name, *cells]) for name, (_, _, cells) in zip(names, columns, strict=True)]
        lines = [line.replace(".", ",") if comma else line for line in lines]
    text = draw(st.sampled_from(["\n", "\r\n"])).join(lines) + "\n"
    if change == "cut":
        text = text[: draw(st.integers(1, len(text) - 1))]
    return text, draw(st.sampled_from(["utf-8", "utf-8-sig", "utf-16", "cp1252"])), change


def _curve(path, *, rigid):
    (one,) = try_curves(path, rigid=rigid)
    if isinstance(one, UnreadCurve):
        raise InvalidInput(one.reason)
    return one.curve.position, one.curve.force, one.curve.time


def _moduli(path):
    found = read_dynamic(path)
    return found.angular_frequency, found.storage_shear, found.loss_shear


def _scan(path):
    found = read_scan(path)
    return found.position, found.heights


READERS = {
    "curve": lambda path: _curve(path, rigid=False),
    "nanoindentation": lambda path: _curve(path, rigid=True),
    "moduli": _moduli,
    "scan": _scan,
}


def _stays_or_is_refused(kind, drawn, folder, counts):
    text, encoding, change = drawn
    path = folder / "table.txt"
    path.write_bytes(text.encode(encoding, "replace"))
    try:
        found = READERS[kind](path)
    except InvalidInput as error:
        counts["refused"] += 1
        counts["unnamed"] += path.name not in str(error)
        return
    counts["read"] += 1
    for got, quantity in zip(found, KINDS[kind], strict=True):
        count = got.size if change == "cut" else quantity.numbers.size
        if change == "cut" and count:  # the last row may lack digits of its last number
            got, count = got[: count - 1], count - 1
        expected = quantity.numbers[:count]
        assert got.size == count, (text[:300], got.size)
        scale = float(np.abs(quantity.numbers).max())
        assert got == pytest.approx(expected, rel=1e-6, abs=1e-7 * scale), text[:300]


@pytest.mark.few(2, slow=4)
@pytest.mark.parametrize("texts_drawn", [8, pytest.param(50, marks=pytest.mark.slow)])
@pytest.mark.parametrize("kind", ["curve", "moduli", "scan", "nanoindentation"])
def test_the_numbers_stay_or_the_table_is_refused(kind, texts_drawn, tmp_path_factory):
    folder, counts = tmp_path_factory.mktemp(kind), {"read": 0, "refused": 0, "unnamed": 0}

    @settings(max_examples=texts_drawn, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
    @given(texts(kind))
    def drawn(one):
        _stays_or_is_refused(kind, one, folder, counts)

    drawn()
    assert counts["read"] >= 0.3 * texts_drawn, counts
    assert counts["unnamed"] == 0


def test_decimal_commas_beside_a_column_of_remarks_part_no_cells(tmp_path):
    """By commas each of its rows has three cells, as its header has by semicolons."""
    path = tmp_path / "scan.txt"
    rows = [f"{n},5;{n};1,{n}25e-7" for n in range(10, 90)]
    path.write_text("\n".join(["x [nm];Remark;z [m]", *rows]), encoding="utf-8")
    position, heights = READERS["scan"](path)
    assert position == pytest.approx(1e-9 * (np.arange(10, 90) + 0.5), rel=1e-12)
    assert heights == pytest.approx([float(f"1.{n}25e-7") for n in range(10, 90)], rel=1e-12)
