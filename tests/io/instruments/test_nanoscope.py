"""Files of NanoScope, made here after their head: both ways from the deepest point outwards."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.fitting.curves.directions import IN, OUT
from winkler.io.curves import read_curve, read_curves
from winkler.study.inspection.inspect import inspect_file
from winkler.values.errors import InvalidInput

SPRING, PIEZO, SENSITIVITY, SENSOR, LEAST = 0.12, 13.2e-9, 27.39e-9, 906e-9, 0.000375
RAMP, SPEED = 75.0, 150.0  # V, V/s
THERE, BACK = 200, 100
TRAVEL = RAMP * PIEZO


def _curve(count, touch=0.6):
    """Travel [m] and deflection [V] of a way inwards."""
    travel = TRAVEL * np.arange(1, count + 1) / count
    return travel, 0.5 * np.maximum(travel - touch * TRAVEL, 0.0) / SENSITIVITY


def _channel(name, offset, length, least, soft, ways=f"{BACK} {THERE}"):
    return [
        r"\*Ciao force image list",
        rf"\Data offset: {offset}",
        rf"\Data length: {length}",
        r"\Bytes/pixel: 2",
        rf"\Samps/line: {ways}",
        rf"\Spring Constant: {SPRING}",
        rf'\@4:Image Data: S [{name}] "{name}"',
        rf"\@4:Z scale: V [{soft}] ({least} V/LSB) 2.500000 V",
        rf"\@4:Ramp size: V [Sens. Zsens] (0.0067 V/LSB) {RAMP} V",
    ]


def _file(
    tmp_path,
    *,
    size=2,
    grid=(),
    sensor=False,
    unit=" nm/V",
    start=r"\*Force file list",
    cut=0,
    shift=0,
    more=(),
    padded=False,
    beside=False,
    parts=1,
):
    """A curve, or a volume whose curves touch later and later; with a sensor of the height."""
    count = int(np.prod(grid)) if grid else 1
    blocks, sensed = [], []
    for number in range(count):
        for points in (THERE, BACK):  # each way from the deepest point outwards
            travel, deflection = _curve(points, 0.6 + 0.01 * number)
            room = np.full(max(THERE, BACK) - points if padded else 0, -1.0)
            blocks.append(np.r_[np.round(deflection[::-1] / LEAST), room])
            sensed.append(np.r_[np.round(travel[::-1] / SENSOR / LEAST), room])
    offset, length = 8192, sum(map(len, blocks)) * size
    lines = [
        start, r"\Version: 0x09200000", r"\*Scanner list", rf"\@Sens. Zsens: V {PIEZO * 1e9:.4f} nm/V",
        r"\*Ciao scan list",
        r"\Operating mode: " + ("Force Volume" if grid else "Force"), r"\Scan Size: 2000 nm", r"\X Offset: 100 nm",
        r"\Y Offset: 0 nm", rf"\@Sens. DeflSens: V {SENSITIVITY * 1e9:.4f}{unit}",
        rf"\@Sens. ZsensSens: V {SENSOR * 1e9} nm/V",
        r"\*Ciao force list", rf"\Forward vel.: {SPEED}", rf"\Reverse vel.: {2 * SPEED}",
        *more,
        *_channel("Deflection Error", offset, length, LEAST, "Sens. DeflSens"),
        *(_channel("Height Sensor", offset + length, length, LEAST, "Sens. ZsensSens") if sensor else []),
        *([r"\*Ciao image list", r"\Samps/line: 64", r"\Number of lines: 64"] if beside else []),
        *([r"\*Ciao image list", rf"\Samps/line: {grid[0]}", rf"\Number of lines: {grid[1]}"] if grid else []),
        r"\*File list end",
    ]  # fmt: skip
    head = "\r\n".join(lines).encode("latin-1") + b"\r\n\x1a"
    blocks = [parts * block for block in blocks]
    numbers = np.concatenate([*blocks, *(sensed if sensor else [])]).astype(f"<i{size}").tobytes()
    content = head + b"\0" * (offset - len(head) + shift) + numbers
    file = tmp_path / "curve.spm"
    file.write_bytes(content[: len(content) - cut])
    return file


@pytest.mark.parametrize("size", [2, 4])
def test_a_curve_is_read_from_its_head(tmp_path, size):
    """No reader knew the commonest microscope: "files that end in '.spm' are not known"."""
    curve = read_curve(_file(tmp_path, size=size))
    travel, deflection = _curve(THERE)
    back, deflection_back = _curve(BACK)
    resolution = LEAST * SENSITIVITY * SPRING
    expected = np.r_[deflection, deflection_back[::-1]] * SENSITIVITY * SPRING
    assert curve.force == pytest.approx(expected, abs=0.51 * resolution)
    assert curve.position == pytest.approx(np.r_[travel, back[::-1]], rel=1e-9)
    assert np.array_equal(curve.direction, np.r_[np.full(THERE, IN), np.full(BACK, OUT)])
    assert curve.machine_stiffness == SPRING
    assert curve.time[[THERE - 1, -1]] == pytest.approx([RAMP / SPEED, 1.5 * RAMP / SPEED])
    assert "sensitivity 27.39 nm/V from the file" in curve.reading
    assert "position from the ramp" in curve.reading


@pytest.mark.parametrize(("met", "mode"), [(1.0, "Relative"), (0.7, "Relative"), (1.0, "Absolute")])
def test_256ths_of_the_least_bit_are_those_that_meet_the_trigger(tmp_path, met, mode):
    """A volume of version 9 states volts for the least bit, and stores 256ths of them; others are damaged."""
    volts = met * float(_curve(THERE)[1].max())
    more = (
        rf"\Trigger mode: {mode}",
        rf"\@4:Trig Threshold Deflection: V [Sens. DeflSens] ({LEAST} V/LSB) {volts:.6f} V",
    )
    file = _file(tmp_path, size=4, grid=(2, 2), parts=256, more=more)
    if (met, mode) != (1.0, "Relative"):
        with pytest.raises(InvalidInput, match="they do not stand where the head says"):
            list(read_curves(file))
        return
    whole = [placed.curve for placed in read_curves(_file(tmp_path, size=4, grid=(2, 2)))]
    file = _file(tmp_path, size=4, grid=(2, 2), parts=256, more=more)
    for curve, expected in zip((placed.curve for placed in read_curves(file)), whole, strict=True):
        np.testing.assert_allclose(curve.force, expected.force, rtol=1e-12, atol=1e-24)
        assert "256ths of the least bit" in curve.reading


def test_a_trigger_ends_the_extension_early(tmp_path):
    """The program's own text of such a file has one step of the ramp in both ways; extension was stretched to it."""
    file = _file(tmp_path)
    head = rf"\Samps/line: {BACK} {THERE}".encode()
    early, whole = THERE - 40, THERE
    kept = file.read_bytes().replace(head, rf"\Samps/line: {whole} {early}".encode())
    kept = kept.replace(b"Reverse vel.: 300.0", b"Reverse vel.: 150.0")
    kept = kept.replace(b"Data length: 600", f"Data length: {2 * (early + whole)}".encode())
    file.write_bytes(kept + bytes(2 * (early + whole - THERE - BACK)))
    curve = read_curve(file)
    assert np.diff(curve.position[:early]) == pytest.approx(TRAVEL / whole, rel=1e-9)
    assert np.diff(curve.position[early:]) == pytest.approx(-TRAVEL / whole, rel=1e-9)
    assert curve.position[early - 1] == pytest.approx(curve.position[early], rel=1e-12) == pytest.approx(TRAVEL)
    assert np.diff(curve.time[:early]) == pytest.approx(RAMP / SPEED / whole, rel=1e-9)


@pytest.mark.parametrize("sensor", [False, True])
def test_older_versions_keep_room_for_the_longer_way_in_both(tmp_path, sensor):
    """'Deflection' has 4096 bytes for 1 curve of 1972 points."""
    (tmp_path / "old").mkdir()
    new, old = (
        read_curve(_file(tmp_path, sensor=sensor)),
        read_curve(_file(tmp_path / "old", sensor=sensor, padded=True)),
    )
    assert np.array_equal(old.force, new.force)
    assert np.array_equal(old.position, new.position)


def test_a_measured_height_precedes_the_ramp(tmp_path):
    curve = read_curve(_file(tmp_path, sensor=True))
    assert "position from 'Height Sensor'" in curve.reading
    assert curve.position[THERE - 1] == pytest.approx(TRAVEL, abs=LEAST * SENSOR)


def test_curves_of_a_volume_have_their_places(tmp_path):
    curves = list(read_curves(_file(tmp_path, grid=(3, 2))))
    assert len(curves) == 6
    tops = [one.curve.force.max() for one in curves]
    assert tops == pytest.approx([0.5 * SPRING * TRAVEL * (0.4 - 0.01 * n) for n in range(6)], rel=1e-2)
    assert curves[4].x == pytest.approx(0.1e-6 + 1e-6)
    assert curves[4].y == pytest.approx(1.5e-6)


def test_a_picture_beside_a_volume_has_other_pixels(tmp_path):
    """The curves of a line stand in the head; the first picture is a scan of its own."""
    more = (r"\force/line: 3 0",)
    curves = list(read_curves(_file(tmp_path, grid=(3, 2), beside=True, more=more)))
    assert len(curves) == 6
    (tmp_path / "short").mkdir()
    cut = _file(tmp_path / "short", grid=(3, 2), more=more, cut=10)
    assert "read as force curve: the file ends before the numbers" in inspect_file(cut).reason


def test_given_numbers_replace_those_of_the_head(tmp_path):
    curve = read_curve(_file(tmp_path), spring_constant=2.0 * SPRING, sensitivity=2.0 * SENSITIVITY)
    assert curve.force.max() == pytest.approx(4.0 * 0.2 * TRAVEL * SPRING, rel=1e-2)
    assert "given" in curve.reading


def test_a_sensitivity_without_unit_is_named(tmp_path):
    assert "leaves out, taken as nm/V" in read_curve(_file(tmp_path, unit=" ")).reading


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"cut": 10}, "ends before the numbers"),
        ({"shift": 1, "size": 4}, "do not stand where the head says"),
        ({"grid": (3, 2), "size": 8}, "2 or 4 bytes a point"),
        ({"start": r"\*File list", "more": [r"\PeakForce Capture: Allow"]}, "PeakForce"),
    ],
)
def test_what_cannot_be_read_is_named(tmp_path, changed, said):
    with pytest.raises(InvalidInput, match=said):
        list(read_curves(_file(tmp_path, **changed)))


def test_images_are_no_curves(tmp_path):
    file = tmp_path / "image.spm"
    file.write_bytes(b"\\*File list\r\n\\Version: 0x0\r\n\\*Ciao image list\r\n\\*File list end\r\n\x1a")
    with pytest.raises(InvalidInput, match="read_topography reads it"):
        read_curve(file)
