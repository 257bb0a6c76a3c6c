"""Made exports of Nanosurf, FemtoTools by point and JPK with a way back written backwards: the curve comes back."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.io.curves import read_curve, read_curves
from winkler.values.errors import InvalidInput

SPRING, SENSITIVITY = 0.125, 6.4e-8
PLACE = np.linspace(-4e-6, 1e-6, 101)
FORCE = 2e-9 * np.clip(PLACE / 1e-6, 0.0, None) ** 1.5


def nanosurf(numbers, unit, back=slice(None, None, -1)):
    head = [
        r"#Filename=C:\curve.nid",
        f"#Spring-Constant={SPRING}N/m",
        f"#Deflection-Sensitivity={SENSITIVITY}m/V",
        "#SpecMap-CurIndex=3",
    ]
    lines = [*head, ""]
    for number, (name, way) in enumerate((("Spec forward", slice(None)), ("Spec backward", back))):
        lines += [f"#Spec-Phase={number}", f"#Spec-Name={name}", f"#Spec-Points={PLACE.size}"]
        lines.append(f"#Spec-Data=Z-Axis Sensor [m];Deflection [{unit}];Z-Axis-Out [m]")
        lines += [f"{z:.10g};{d:.10g};{2.0 * z:.10g}" for z, d in zip(PLACE[way], numbers[way], strict=True)]
        lines.append("")
    return "\n".join(lines)


@pytest.mark.parametrize("back", [slice(None, None, -1), slice(None)], ids=["in time", "from its end"])
@pytest.mark.parametrize(("factor", "unit"), [(1.0, "N"), (1.0 / SPRING, "m"), (1.0 / (SPRING * SENSITIVITY), "V")])
def test_nanosurf(tmp_path, factor, unit, back):
    """Programs write the way back in the order of time, or from its end: the tip goes back from where it was."""
    file = tmp_path / "curve.txt"
    file.write_text(nanosurf(FORCE * factor, unit, back), encoding="utf-8")
    curve = read_curve(file)
    assert ("1 of 2 phases, written backwards, are turned round" in curve.reading) == (back.step is None)
    np.testing.assert_allclose(curve.position, np.append(PLACE, PLACE[::-1]), rtol=1e-9)
    np.testing.assert_allclose(curve.force, np.append(FORCE, FORCE[::-1]), rtol=1e-8, atol=1e-20)
    assert curve.machine_stiffness == SPRING
    assert np.sign(curve.direction[[50, -50]]).tolist() == [1.0, -1.0]
    assert "point 3 of a map" in curve.reading


def test_volts_that_are_called_newtons(tmp_path):
    """A force that would bend the cantilever by many times its travel is refused, and read with the sensitivity."""
    file = tmp_path / "curve.txt"
    file.write_text(nanosurf(FORCE / (SPRING * SENSITIVITY), "N"), encoding="utf-8")
    with pytest.raises(InvalidInput, match="give sensitivity in m/V"):
        read_curve(file)
    curve = read_curve(file, sensitivity=SENSITIVITY)
    np.testing.assert_allclose(curve.force, np.append(FORCE, FORCE[::-1]), rtol=1e-8, atol=1e-20)
    assert "stated in N, are taken as V" in curve.reading


def test_points_of_femtotools(tmp_path):
    """Names behind a comment mark, spaces between them, and one test for each whole number of the index."""
    names = ("Index", "Time [s]", "Displacement [um]", "Pos X [um]", "Pos Z [um]", "Force A [uN]", "Force B [uN]")
    head = ["", "// ====", "// 2024-11-06", "//" + " ".join(f"{name:>17}" for name in names), "// ===="]
    depth = np.linspace(0.0, 30.0, 40)
    rows = [
        f"{point}.001 {0.1 * k + 100 * point:.3f} {d:.5f} 5.0 {-d:.5f} {point * d**1.5:.6f} 0.01"
        for point in (1, 2, 3)
        for k, d in enumerate(depth)
    ]
    file = tmp_path / "points.dat"
    file.write_text("\n".join([*head, *rows]) + "\n", encoding="utf-8")
    curves = [placed.curve for placed in read_curves(file)]
    assert len(curves) == 3
    for point, curve in enumerate(curves, start=1):
        np.testing.assert_allclose(curve.position, depth * 1e-6, atol=6e-12)
        np.testing.assert_allclose(curve.force, point * depth**1.5 * 1e-6, atol=1e-12)
        assert "Force A" in curve.reading


def test_way_back_written_backwards(tmp_path):
    """JPK's older programs wrote the way back from its end: time says so, and the points come in the order of time."""
    lines = []
    times = np.arange(2 * PLACE.size) * 1e-3
    ways = (slice(None), slice(None))  # both in the order of falling heights
    for number, way in enumerate(ways):
        clock = times[: PLACE.size] if number == 0 else times[: PLACE.size - 1 : -1]
        lines += ["# springConstant: 0.125", "# columns: height vDeflection time", "# units: m N s", "#"]
        lines += [f"{-z:.10g} {f:.10g} {t:.10g}" for z, f, t in zip(PLACE[way], FORCE[way], clock, strict=True)]
        lines.append("")
    file = tmp_path / "curve.out"
    file.write_text("\n".join(lines), encoding="utf-8")
    curve = read_curve(file)
    np.testing.assert_allclose(curve.time, times, atol=1e-12)
    np.testing.assert_allclose(curve.position, np.append(PLACE, PLACE[::-1]), rtol=1e-9)
    assert "1 of 2 segments, written backwards, are turned round" in curve.reading


def _nid(order=1, bits=32, lines=2, cut=0, mode="Binary"):
    """A file of Nanosurf with two curves: each whole number spans the range of its channel."""
    bend = FORCE / SPRING
    groups = []
    for group, (way, turned) in enumerate((("Spec forward", 1), ("Spec backward", -order))):
        for channel, (name, unit, numbers) in enumerate(
            (("Deflection", "m", bend), ("Z-Axis Sensor", "m", PLACE), ("Other", "V", PLACE))
        ):
            groups.append((group, channel, way, name, unit, numbers[::turned]))
    head = ["[DataSet]", "Version=2", "GroupCount=2", "Gr0-Count=3", "Gr1-Count=3"]
    head += [f"Gr{group}-Ch{channel}=DataSet-{group}:{channel}" for group, channel, *_ in groups]
    head += ["", "[DataSet\\Calibration\\Cantilever]", "Prop0=D[30000]*[Hz]", f"Prop1=D[{SPRING}]*[N/m]"]
    body = b""
    for group, channel, way, name, unit, numbers in groups:
        low, span = float(numbers.min()) - 1e-9, 1.1 * float(np.ptp(numbers)) + 2e-9
        head += ["", f"[DataSet-{group}:{channel}]", f"Points={numbers.size}", f"Lines={lines}", f"Frame={way}"]
        head += [f"Dim2Name={name}", f"Dim2Unit={unit}", f"Dim2Range={span!r}", f"Dim2Min={low!r}"]
        head += [f"SaveMode={mode}", f"SaveBits={bits}", "SaveSign=Signed", "SaveOrder=Intel"]
        whole = np.round((numbers - low) / span * 2.0**bits - 2.0 ** (bits - 1)).astype(f"<i{bits // 8}")
        body += lines * whole.tobytes()
    content = "\r\n".join(head).encode() + b"\r\n#!" + body
    return content[: len(content) - cut]


@pytest.mark.parametrize("order", [1, -1])
def test_both_ways_of_a_nid_follow_each_other(tmp_path, order):
    """The way back may be written from its end."""
    (tmp_path / "map.nid").write_bytes(_nid(order))
    curves = [placed.curve for placed in read_curves(tmp_path / "map.nid")]
    assert len(curves) == 2
    for curve in curves:
        np.testing.assert_allclose(curve.position, np.append(PLACE, PLACE[::-1]), atol=1e-9 * np.ptp(PLACE))
        np.testing.assert_allclose(curve.force, np.append(FORCE, FORCE[::-1]), atol=1e-8 * np.ptp(FORCE))
        assert curve.machine_stiffness == SPRING
        assert "Z-Axis Sensor" in curve.reading


def test_lines_of_a_map_that_end_early_are_read_to_their_end(tmp_path):
    """Each line keeps room for the longest; the rest, zeros, was taken for a jump of the tip to zero."""
    content = _nid().replace(b"Lines=2", f"Lines=2\r\nLineDim1Points={PLACE.size - 3}".encode())
    (tmp_path / "map.nid").write_bytes(content)
    whole, ended = (placed.curve for placed in read_curves(tmp_path / "map.nid"))
    assert whole.position.size == 2 * PLACE.size
    np.testing.assert_allclose(ended.position[: PLACE.size - 3], whole.position[: PLACE.size - 3])
    assert ended.position.size == 2 * (PLACE.size - 3)


@pytest.mark.parametrize(
    ("content", "why"),
    [
        (_nid(cut=20), "ends within its numbers"),
        (_nid()[:300], "ends within its head"),
        (_nid(mode="Text"), "not stored as signed ones"),
        (_nid().replace(b"Points=", b"Points=x"), "states Points=x"),
        (_nid().replace(b"Dim2Min=", b"Dim2Min=x"), "states Dim2Min=x"),
        (_nid().replace(b"Deflection", b"Deviation"), "a curve needs Deflection"),
        (_nid().replace(b"GroupCount=2", b"GroupCount=0"), "hold no numbers"),
        (_nid().replace(b"*[N/m]", b"*[kg]"), "give spring_constant"),
        (_nid().replace(b"Dim2Unit=m", b"Dim2Unit=V"), "no sensitivity is stated|export the curve as text"),
    ],
)
def test_a_damaged_nid_is_one_sentence(tmp_path, content, why):
    head = content.partition(b"#!")[0]
    (tmp_path / "map.nid").write_bytes(content if b"Frame=Spec" in head else content[:200] + b"\r\nFrame=Spec forward")
    with pytest.raises(InvalidInput, match=why):
        list(read_curves(tmp_path / "map.nid"))


def _unified(unit="volt", code="RE", title="Deflection"):
    """Both ways from the deepest point on; an unstated unit of the second segment is that of the first."""
    lines = ["HE UFF_code:                        _1_2_3", 'HE Entry_date:   "21 APR 2022"']
    lines += [
        "HE Cantilever_springK_used(N/m):    1.332E-01",
        "HE Recording_inv_optical_lever_sens_used(m/V): 2.739E-08",
    ]
    for number, way in enumerate(("AP", code)):
        lines += [f"HE Recording_segment_{number}_col_0_title: {'?' if number else 'Displacement'}"]
        lines += [f"HE Recording_segment_{number}_col_0_unit:  {'?' if number else 'm'}"]
        lines += [f"HE Recording_segment_{number}_col_1_title: {'?' if number else title}"]
        lines += [f"HE Recording_segment_{number}_col_1_unit:  {'?' if number else unit}"]
        lines += [f"{way}     {number}    {3e-9 * n:.6E}    {max(1.6 - 0.04 * n, 0.0):.6E} " for n in range(80)]
    return "\n".join([*lines, "****", ""])


def test_the_unified_text_of_a_microscope(tmp_path):
    (tmp_path / "gel.uff").write_text(_unified())
    curve = read_curve(tmp_path / "gel.uff")
    bent = 0.1332 * 2.739e-8 * np.maximum(1.6 - 0.04 * np.arange(80), 0.0)
    np.testing.assert_allclose(curve.force, np.append(bent[::-1], bent), rtol=1e-6)
    np.testing.assert_allclose(curve.position[[0, 79, 80, -1]], [-237e-9, 0.0, 0.0, -237e-9], atol=1e-15)
    assert curve.machine_stiffness == 0.1332
    for wrong, why in (
        ({"code": "PA"}, "its segments are AP, PA"),
        ({"title": "Phase"}, "a displacement and a deflection"),
    ):
        (tmp_path / "gel.uff").write_text(_unified(**wrong))
        with pytest.raises(InvalidInput, match=why):
            read_curve(tmp_path / "gel.uff")
