"""Curves of FischerScope, Micro Materials, FemtoTools and Anton Paar indenters, as their texts hold them."""

import zipfile

import numpy as np
import pytest

import winkler as wk
from winkler.io.curves import read_curve, read_curves, try_curves


def fischerscope(tests):
    lines = ["glass.hap\tName of the application", "F = ESP n 50.000mN/20s/5s", "1\tNumber of block"]
    for number, (x, rows) in enumerate(tests, 1):
        lines += [
            "glass.hap   26.05.2020  15:17:54",
            "Indenter shape correction: Hardness",
            f"Block : 1   Value : {number}",
            f"x=    {x:.2f}  y=     6.01",
            "hmax\t[µm]\t    0.50",
            " ",
            "F\th\tt",
            *("\t".join(f"{cell:g}".replace(".", ",") for cell in row) for row in rows),
            "",
        ]
    return "\n".join(lines).encode("latin-1")


def test_fischerscope(tmp_path):
    """Decimal commas, no units in the file, one curve for each value, places in mm."""
    path = tmp_path / "glass.txt"
    path.write_bytes(
        fischerscope([(44.65, [(0.5, 0.03, 0.1), (1.25, 0.06, 0.2)]), (44.54, [(0.4, 0.02, 0.1), (2, 0.07, 1)])])
    )
    first, second = read_curves(path)
    np.testing.assert_allclose(first.curve.force, [0.5e-3, 1.25e-3])
    np.testing.assert_allclose(first.curve.position, [30e-9, 60e-9])
    np.testing.assert_allclose(second.curve.time, [0.1, 1.0])
    assert (first.x, first.y, second.x) == pytest.approx((44.65e-3, 6.01e-3, 44.54e-3))
    assert second.curve.name == "glass.txt, block 1, value 2"
    assert "the file states no units: mN, um and s are those of the instrument" in first.curve.reading
    assert "hmax [µm] 0.50" in first.curve.reading
    with pytest.raises(wk.InvalidInput, match="the file holds 2 curves; use read_curves"):
        read_curve(path)
    given = next(iter(read_curves(path, units={"force": "N"})))
    np.testing.assert_allclose(given.curve.force, [0.5, 1.25])


def test_micro_materials(tmp_path):
    """Three columns without a header are read because of the name, alone or in an archive."""
    text = "0.000000\t-3.5\t-0.01\r\n0.000000\t0.0\t0.0\r\n1.5\t400.0\t12.5\r\n2.5\t300.0\t0.5\r\n"
    path = tmp_path / "steel 3 6958 -4555.txt"
    path.write_text(text, encoding="utf-8")
    (placed,) = read_curves(path)
    np.testing.assert_allclose(placed.curve.position, [-3.5e-9, 0.0, 400e-9, 300e-9])
    np.testing.assert_allclose(placed.curve.force, [-1e-5, 0.0, 12.5e-3, 0.5e-3])
    np.testing.assert_allclose(placed.curve.time, [0.0, 0.0, 1.5, 2.5])
    assert (placed.x, placed.y) == pytest.approx((6958e-6, -4555e-6))
    assert "no header: time, depth and load, in s, nm and mN, are the order of this instrument" in placed.curve.reading
    with zipfile.ZipFile(tmp_path / "steel.zip", "w") as archive:
        archive.writestr("steel 1 0 0.txt", text)
        archive.writestr("steel 2 25 0.txt", text.replace("12.5", "13.5").encode("utf-16"))
    both = list(read_curves(tmp_path / "steel.zip"))
    assert [one.curve.force.max() for one in both] == pytest.approx([12.5e-3, 13.5e-3])
    nameless = tmp_path / "steel.txt"
    nameless.write_text(text, encoding="utf-8")
    with pytest.raises(wk.InvalidInput, match="write a header such as 'depth"):
        read_curve(nameless)
    path.write_text(text.replace("0.000000\t0.0", "-1.0\t0.0"), encoding="utf-8")
    with pytest.raises(wk.InvalidInput, match="its first column falls, so that it is no time"):
        read_curve(path)


def test_femtotools(tmp_path):
    """Two tests follow each other in one table; the depth of the sample precedes the travel of the stage."""
    lines = [
        "// FemtoTools",
        "// Index [#]\tPhase [#]\tDisplacement [um]\tTime [s]\tForce A [uN]\tSample Displace [um]",
    ]
    for index in range(2):
        for phase, depth, time in [(1, 0.0, 0.0), (2, 0.1, 1.0), (2, 0.2, 2.0), (4, 0.1, 3.0)]:
            lines.append(f"{index}\t{phase}\t{depth + 5.0}\t{time + 10 * index}\t{100 * depth * (index + 1)}\t{depth}")
    path = tmp_path / "pillars.txt"
    path.write_text("\n".join(lines), encoding="utf-8")
    one, two = read_curves(path)
    np.testing.assert_allclose(one.curve.position, [0.0, 1e-7, 2e-7, 1e-7])
    np.testing.assert_allclose(two.curve.force, 1e-6 * np.array([0.0, 20.0, 40.0, 20.0]))
    assert "depth from 'Sample Displace' [um], force from 'Force A' [uN]" in two.curve.reading
    path.write_text("\n".join(lines).replace("\tSample Displace [um]", "\tTemperature [C]"), encoding="utf-8")
    (bent, _) = read_curves(path)
    assert "the displacement may contain the bending of the sensor" in bent.curve.reading


def test_anton_paar(tmp_path):
    path = tmp_path / "test.txt"
    path.write_text(
        "Anton Paar TriTec SA\nSample: steel\n\nTime [s]\tPd [nm]\tFn [mN]\n"
        "0,0\t0,0\t0,0\n0,5\t10,25\t0,125\n1,0\t20,5\t0,5\n",
        encoding="utf-8",
    )
    curve = read_curve(path)
    np.testing.assert_allclose(curve.position, [0.0, 10.25e-9, 20.5e-9])
    np.testing.assert_allclose(curve.force, [0.0, 0.125e-3, 0.5e-3])
    assert curve.reading.startswith("Anton Paar, text export: depth from 'Pd [nm]', force from 'Fn [mN]'")


def test_a_method_of_nanosuite_holds_no_curve(tmp_path, shared_data):
    path = tmp_path / "method.txt"
    path.write_text("Method Name : C:\\Methods\\Hardness.msm\nOwner : User\nChannels\n\tdPdt\n", encoding="utf-8")
    for method, name in ((path, "Hardness.msm"), (shared_data / "nanoindentation" / "ISO.txt", "_Soler.msm")):
        with pytest.raises(
            wk.InvalidInput, match=rf"is the method '.*{name}' of NanoSuite .* in the workbook"
        ) as error:
            read_curve(method)
        assert "\n" not in str(error.value)


def test_one_bad_test_among_many(tmp_path):
    """A test without numbers gives a reason, and the others are read."""
    path = tmp_path / "glass.txt"
    whole = fischerscope([(1.0, [(0.5, 0.03, 0.1), (1.25, 0.06, 0.2)]), (2.0, [(0.4, 0.02, 0.1)])])
    path.write_bytes(whole)
    good, bad = try_curves(path)
    assert good.curve.count == 2
    assert "1 rows hold depth and force; it needs at least 2" in bad.reason


def test_an_archive_that_unpacks_to_too_much(tmp_path):
    path = tmp_path / "steel.zip"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("steel 1 0 0.txt", b"1\t2\t3\n" * 4_000_000)
    with pytest.raises(wk.InvalidInput, match="steel 1 0 0.txt: 24 MB are too much; at most 20 MB are read"):
        read_curve(path)
