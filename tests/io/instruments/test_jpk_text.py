"""Curves that JPK exports as text: columns, units, segments and spring constant stand in the head of each segment."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.fitting.curves.directions import IN, OUT
from winkler.io.curves import read_curve, read_curves
from winkler.values.errors import InvalidInput

SPRING, SENSITIVITY = 0.05, 6e-8
HEIGHT = np.linspace(2e-6, 0.0, 101)
FORCE = np.maximum(1e-6 - HEIGHT, 0.0) * SPRING


def _text(column="vDeflection", unit="N", deflection=FORCE, spring="# springConstant: 0.05\n", more=""):
    """A curve of two segments, extension and retraction."""
    lines = ["# exportTime: 2020", "# xPosition: 1.5e-6", "# yPosition: -2e-6", spring + more]
    ways = (("extend", HEIGHT, deflection, 0.0), ("retract", HEIGHT[::-1], deflection[::-1], 1.0))
    for number, (segment, height, signal, start) in enumerate(ways):
        lines += [
            f"# segmentIndex: {number}",
            f"# segment: {segment}",
            f"# columns: {column} measuredHeight seriesTime",
            '# fancyNames: "Vertical deflection" "Height (measured)" "Series Time"',
            f"# units: {unit} m s",
        ]
        lines += [
            f"{s:.6e} {h:.6e} {start + t:.4f}" for s, h, t in zip(signal, height, 0.01 * np.arange(101), strict=True)
        ]
        lines.append("")
    return "\n".join(lines)


def _read(tmp_path, text, **given):
    file = tmp_path / "jpk.txt"
    file.write_text(text)
    return read_curve(file, **given)


def test_columns_and_segments_are_those_of_the_file(tmp_path):
    """It was "a file of NT-MDT" with a force of 6.3e-18 N, and the spring constant was asked for."""
    curve = _read(tmp_path, _text())
    assert curve.force == pytest.approx(np.r_[FORCE, FORCE[::-1]], abs=1e-15)
    assert curve.position == pytest.approx(-np.r_[HEIGHT, HEIGHT[::-1]], abs=1e-12)
    assert curve.machine_stiffness == SPRING
    assert np.array_equal(curve.direction, np.repeat([IN, OUT], 101))
    assert curve.time[-1] == pytest.approx(2.0)
    assert "NT-MDT" not in curve.reading
    assert "JPK" in curve.reading
    assert "spring constant 0.05 N/m from the file" in curve.reading


@pytest.mark.parametrize(("unit", "divisor"), [("m", SPRING), ("V", SPRING * SENSITIVITY)])
def test_a_deflection_becomes_a_force_by_what_the_head_states(tmp_path, unit, divisor):
    text = _text(unit=unit, deflection=FORCE / divisor, more="# sensitivity: 6e-8\n")
    assert _read(tmp_path, text).force.max() == pytest.approx(FORCE.max(), rel=1e-5)


def test_a_place_of_the_tip_needs_no_bending(tmp_path):
    """Where the program has subtracted the bending, nothing bends any more, whatever spring made the force."""
    curve = _read(tmp_path, _text().replace("measuredHeight", "tipSampleSeparation"), spring_constant=2.0)
    assert np.isinf(curve.machine_stiffness)
    assert curve.position == pytest.approx(-np.r_[HEIGHT, HEIGHT[::-1]], abs=1e-12)


def test_what_the_head_does_not_state_is_asked_for(tmp_path):
    with pytest.raises(InvalidInput, match="give spring_constant"):
        _read(tmp_path, _text(spring=""))
    volts = _text(unit="V", deflection=FORCE / SPRING / SENSITIVITY)
    with pytest.raises(InvalidInput, match="give sensitivity"):
        _read(tmp_path, volts)
    assert _read(tmp_path, volts, sensitivity=SENSITIVITY).force.max() == pytest.approx(FORCE.max(), rel=1e-5)
    with pytest.raises(InvalidInput, match="is a height"):
        _read(tmp_path, _text().replace("measuredHeight", "hDeflection"))


def test_curves_of_a_map_below_each_other_are_told_by_their_numbers(tmp_path):
    """The time of the second curve fell, and the map was refused as one curve."""
    texts = []
    for number in range(3):
        for part in _text().split("# segmentIndex")[1:]:
            head = f"# index: {number}\n# xPosition: {number}e-6\n# yPosition: 0\n# springConstant: 0.05\n"
            texts.append(f"{head}# segmentIndex{part}")
    (tmp_path / "map.txt").write_text("\n".join(texts))
    curves = list(read_curves(tmp_path / "map.txt"))
    assert [placed.x for placed in curves] == pytest.approx([0.0, 1e-6, 2e-6])
    assert all(placed.curve.force == pytest.approx(np.r_[FORCE, FORCE[::-1]], abs=1e-15) for placed in curves)
