"""Waves of Igor in pairs, as older microscopes of Asylum Research write a curve, and pauses of JPK of every kind."""

from __future__ import annotations

import contextlib
import struct
import zipfile

import numpy as np
import pytest

import winkler as wk

pytest.importorskip("igor2")

STEPS = 60
POSITION = np.concatenate([np.linspace(-1e-6, 2e-7, STEPS), np.linspace(2e-7, -1e-6, STEPS)])
DEFLECTION = 4e-8 * np.maximum(POSITION / 2e-7, 0.0) ** 1.5


def wave(numbers, *, unit=b"m", step=1e-3, note=b"", size=None):
    """An Igor binary wave of version 5 of single numbers (Technical Note 003 of WaveMetrics)."""
    data = np.asarray(numbers, dtype="<f4").tobytes()
    count = len(data) // 4 if size is None else size
    head = struct.pack("<hh15i", 5, 0, 320 + len(data), 0, len(note), *[0] * 12)
    body = struct.pack("<IIIi", 0, 0, 0, count) + struct.pack("<hh6sh32s", 2, 0, b"", 1, b"Defl")
    body += struct.pack("<iI4i", 0, 0, count, 0, 0, 0) + struct.pack("<8d", step, 1, 1, 1, 0, 0, 0, 0)
    body += struct.pack("<4s16s", unit, b"s") + struct.pack("<hhdd", 0, 0, 0.0, 0.0) + bytes(4 + 16 + 16 + 4 + 64)
    body += struct.pack("<hhhbbIihhII", 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)
    assert (len(head), len(body)) == (64, 320)
    total = -int(np.frombuffer(head + body, dtype="<i2").sum(dtype=np.int64)) & 0xFFFF
    return head[:2] + struct.pack("<H", total) + head[4:] + body + data + note


def columns(names, numbers, *, note=b"SpringConstant: 0.25\rInvOLS: 1e-07\r"):
    """A wave with named columns, whose names stand at the end of the file."""
    content = wave(np.asarray(numbers).T.ravel(), note=note)
    labels = b"".join(name.ljust(32, b"\0") for name in (b"", *names))
    head = bytearray(content[:384])
    head[2:4] = bytes(2)
    struct.pack_into("<i", head, 40, len(labels))  # of the second of four directions
    struct.pack_into("<2i", head, 64 + 68, len(numbers), len(names))
    total = -int(np.frombuffer(bytes(head), dtype="<i2").sum(dtype=np.int64)) & 0xFFFF
    struct.pack_into("<H", head, 2, total)
    return bytes(head) + content[384:] + labels


@pytest.mark.parametrize("place", [b"ZSnsr", b"LVDT", b"Raw", b"ZSensor"])
def test_position_and_deflection_are_columns_of_one_wave(tmp_path, place):
    """A file without a date was refused: afmformats cannot read this file (KeyError: 'Date')."""
    file = tmp_path / "curve.ibw"
    names = (b"Other", b"Defl", place)
    file.write_bytes(columns(names, np.c_[0.0 * POSITION, DEFLECTION, POSITION]))
    curve = wk.read_curve(file)
    assert curve.force == pytest.approx(0.25 * DEFLECTION, rel=1e-6, abs=1e-20)
    assert curve.position == pytest.approx(POSITION, rel=1e-6)
    assert curve.time == pytest.approx(1e-3 * np.arange(2 * STEPS))
    assert f"deflection from 'Defl', position from '{place.decode()}'" in curve.reading
    given = wk.read_curve(file, spring_constant=0.5, sensitivity=2e-7)
    assert given.force == pytest.approx(4.0 * curve.force, rel=1e-6)
    file.write_bytes(columns(names, np.c_[0.0 * POSITION, DEFLECTION, POSITION], note=b"SpringConstant: 0.25\r"))
    with pytest.raises(wk.InvalidInput, match="states no sensitivity by which its force could be turned"):
        wk.read_curve(file, sensitivity=2e-7)


@pytest.mark.parametrize("size", [2**31 - 1, -1])
def test_a_wave_that_lies_about_its_sizes_does_not_refuse_the_next_one(tmp_path, size):
    """Igor2 keeps the sizes of the last head that it has read."""
    content = columns((b"Other", b"Defl", b"ZSnsr"), np.c_[0.0 * POSITION, DEFLECTION, POSITION])
    for place in range(8, 64, 4):
        head = bytearray(content[:384])
        struct.pack_into("<i", head, place, size)
        head[2:4] = bytes(2)
        total = -int(np.frombuffer(bytes(head), dtype="<i2").sum(dtype=np.int64)) & 0xFFFF
        struct.pack_into("<H", head, 2, total)
        (tmp_path / "bad.ibw").write_bytes(bytes(head) + content[384:])
        with contextlib.suppress(wk.InvalidInput):
            wk.read_curve(tmp_path / "bad.ibw")
        (tmp_path / "good.ibw").write_bytes(content)
        assert wk.read_curve(tmp_path / "good.ibw").position == pytest.approx(POSITION, rel=1e-6)


def pair(folder, place="ZSnsr", **changes):
    (folder / f"Line0Point1{place}.ibw").write_bytes(wave(POSITION, **changes))
    file = folder / "Line0Point1Defl.ibw"
    file.write_bytes(wave(DEFLECTION, **changes))
    return file


@pytest.mark.parametrize("place", ["ZSnsr", "LVDT", "Raw"])
def test_the_position_lies_beside_the_deflection(tmp_path, place):
    curve = wk.read_curve(pair(tmp_path, place), spring_constant=0.5)
    assert curve.force == pytest.approx(0.5 * DEFLECTION, rel=1e-6, abs=1e-20)
    assert curve.position == pytest.approx(POSITION, rel=1e-6)
    assert curve.time == pytest.approx(1e-3 * np.arange(2 * STEPS))
    assert f"position from 'Line0Point1{place}.ibw'" in curve.reading


def test_the_note_states_the_spring_constant_and_the_place(tmp_path):
    note = b"ScanRate: 1\rSpringConstant: 0.25\rXLVDT:-3e-05\rYLVDT:2e-05\r"
    (placed,) = wk.read_curves(pair(tmp_path, note=note))
    assert placed.curve.force == pytest.approx(0.25 * DEFLECTION, rel=1e-6, abs=1e-20)
    assert (placed.x, placed.y) == (-3e-5, 2e-5)


def test_what_is_missing_is_named(tmp_path):
    file = pair(tmp_path)
    with pytest.raises(wk.InvalidInput, match="give spring_constant in N/m"):
        wk.read_curve(file)
    with pytest.raises(wk.InvalidInput, match=r"give its deflections, 'Line0Point1Defl\.ibw'"):
        wk.read_curve(tmp_path / "Line0Point1ZSnsr.ibw", spring_constant=1.0)
    (tmp_path / "Line0Point1ZSnsr.ibw").write_bytes(wave(POSITION[:-1]))
    with pytest.raises(wk.InvalidInput, match="120 deflections, and 'Line0Point1ZSnsr.ibw' 119 positions"):
        wk.read_curve(file, spring_constant=1.0)
    (tmp_path / "Line0Point1ZSnsr.ibw").unlink()
    with pytest.raises(wk.InvalidInput, match=r"put 'Line0Point1ZSnsr\.ibw' beside it"):
        wk.read_curve(file, spring_constant=1.0)


def test_units_that_the_waves_lack_are_given(tmp_path):
    file = pair(tmp_path, unit=b"")
    with pytest.raises(wk.InvalidInput, match="units = { position ="):
        wk.read_curve(file, spring_constant=1.0)
    curve = wk.read_curve(file, spring_constant=1.0, units={"position": "nm", "deflection": "um"})
    assert curve.position == pytest.approx(1e-9 * POSITION, rel=1e-6)
    assert curve.force == pytest.approx(1e-6 * DEFLECTION, rel=1e-6, abs=1e-25)
    volts = pair(tmp_path, unit=b"V")
    with pytest.raises(wk.InvalidInput, match="the wave has the unit 'V', no length"):
        wk.read_curve(volts, spring_constant=1.0)


@pytest.mark.parametrize("cut", [0, 3, 64, 200, 383])
def test_a_wave_that_is_cut_or_lies_is_one_sentence(tmp_path, cut):
    file = pair(tmp_path)
    whole = file.read_bytes()
    for content in (whole[:cut], whole[:cut] + bytes([255]) * (len(whole) - cut), wave(DEFLECTION, size=2**31 - 1)):
        file.write_bytes(content)
        with pytest.raises(wk.InvalidInput, match=r"Line0Point1Defl\.ibw"):
            wk.read_curve(file, spring_constant=1.0)


def test_a_damaged_head_gives_a_curve_or_one_sentence(tmp_path, caplog):
    file = pair(tmp_path)
    whole, rng, refused = file.read_bytes(), np.random.default_rng(0), 0
    for _ in range(60):
        content = bytearray(whole)
        for place in rng.integers(0, 384, 3):
            content[place] = rng.integers(0, 256)
        file.write_bytes(bytes(content))
        try:
            wk.read_curve(file, spring_constant=1.0)
        except wk.InvalidInput:
            refused += 1
        with contextlib.suppress(wk.InvalidInput):
            wk.read_topography(file)
    assert refused > 20
    assert not caplog.records  # igor2 logs what it cannot read, byte for byte


def test_a_pause_at_constant_height_is_read_as_any_other(tmp_path, shared_data):
    """The kind of the pause, which afmformats expects in some orders alone, changes no number of the curve."""
    source = shared_data / "force_curves" / "fmt-jpk-cc_pr14-polymergel-2021.06.30.jpk-force"
    other = tmp_path / "paused.jpk-force"
    changed = 0
    with zipfile.ZipFile(source) as given, zipfile.ZipFile(other, "w") as made:
        for name in given.namelist():
            content = given.read(name)
            changed += content.count(b"constant-force-pause")
            made.writestr(name, content.replace(b"constant-force-pause", b"constant-height-pause"))
    assert changed
    expected, found = wk.read_curve(source), wk.read_curve(other)
    assert found.force == pytest.approx(expected.force, rel=1e-15)
    assert found.position == pytest.approx(expected.position, rel=1e-15)
    assert found.machine_stiffness == expected.machine_stiffness
    oscillating = tmp_path / "oscillating.jpk-force"
    with zipfile.ZipFile(other) as given, zipfile.ZipFile(oscillating, "w") as made:
        contents = {name: given.read(name) for name in given.namelist()}
        assert any(b"style=pause" in content for content in contents.values())
        for name, content in contents.items():
            made.writestr(name, content.replace(b"style=pause", b"style=modulation"))
    assert wk.read_curve(oscillating).force == pytest.approx(expected.force, rel=1e-15)
    softer = wk.read_curve(other, spring_constant=2.0 * expected.machine_stiffness)
    assert softer.force == pytest.approx(2.0 * expected.force, rel=1e-12)
