"""Force curves from tables and from the files of real instruments."""

import math
import zipfile

import numpy as np
import pytest

import winkler as wk
from winkler.io.curves import read_curve, read_curves, try_curves


def write(folder, text, name="curve.csv"):
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


def test_depth_and_force(tmp_path):
    path = write(tmp_path, "time [s],depth [nm],force [uN]\n0,0,0\n0.5,10,1\n1,20,4\n1.5,15,2\n")
    curve = read_curve(path)
    np.testing.assert_allclose(curve.position, [0.0, 1e-8, 2e-8, 1.5e-8], rtol=1e-15)
    np.testing.assert_allclose(curve.force, [0.0, 1e-6, 4e-6, 2e-6], rtol=1e-15)
    np.testing.assert_allclose(curve.time, [0.0, 0.5, 1.0, 1.5])
    assert curve.machine_stiffness == math.inf
    np.testing.assert_array_equal(curve.direction, [1, 1, 1, -1])
    assert curve.name == "curve.csv"


def test_piezo_and_deflection(tmp_path):
    """The force is the spring constant times the deflection, and the depth what the bending leaves of the travel."""
    path = write(tmp_path, "piezo [nm]\tdeflection [nm]\n0\t0\n100\t0\n200\t40\n")
    curve = read_curve(path, spring_constant=0.2)
    np.testing.assert_allclose(curve.force, [0.0, 0.0, 8e-9], rtol=1e-15)
    np.testing.assert_allclose(curve.depth(1e-7), [-1e-7, 0.0, 6e-8], rtol=1e-13, atol=1e-22)
    volts = write(tmp_path, "piezo [nm]\tdeflection [V]\n0\t0\n100\t0\n200\t0.5\n", "volts.txt")
    curve = read_curve(volts, spring_constant=0.2, sensitivity=80e-9)
    np.testing.assert_allclose(curve.force, [0.0, 0.0, 8e-9], rtol=1e-15)


def test_the_cantilever_that_stands_above_the_table(tmp_path):
    path = write(
        tmp_path, "k (N/m)\t0.019\n\nTime (s)\tLoad (uN)\tIndentation (nm)\tPiezo (nm)\n0\t0\t0\t5\n1\t1\t0\t9\n"
    )
    curve = read_curve(path)
    assert curve.machine_stiffness == 0.019
    np.testing.assert_allclose(curve.position, [5e-9, 9e-9])
    assert read_curve(path, spring_constant=0.03).machine_stiffness == 0.03


def test_columns_repeated_in_volts(tmp_path):
    path = write(tmp_path, "Depth (nm)\tLoad (µN)\tDepth (V)\tLoad (V)\n1\t2\t3\t4\n2\t3\t4\t5\n")
    curve = read_curve(path)
    np.testing.assert_allclose(curve.position, [1e-9, 2e-9])
    np.testing.assert_allclose(curve.force, [2e-6, 3e-6])


@pytest.mark.parametrize(
    ("text", "given", "why"),
    [
        ("piezo [nm],force [nN]\n0,0\n1,1\n", {}, r"give spring_constant in N/m, infinite where"),
        ("piezo [nm],deflection [nm]\n0,0\n1,1\n", {}, r"give spring_constant in N/m, which makes it one"),
        ("piezo [nm],deflection [V]\n0,0\n1,1\n", {"spring_constant": 1.0}, r"give sensitivity"),
        (
            "piezo [nm],force [nN]\n0,0\n1,1\n",
            {"spring_constant": -1.0},
            r"spring_constant is -1.0; it must",
        ),
        ("depth,force\n0,0\n1,1\n", {}, r"no unit stands with 'depth' and 'force'"),
        ("depth [nm],force [nm]\n0,0\n1,1\n", {}, r"nm"),
        ("depth [nm],force [nN]\n0,0\n1,x\n", {}, r"line 3.*'x' in the column"),
        ("depth [nm],force [nN]\n0,0\n", {}, r"position has 1 number; give a row of at least 2"),
        ("radius [nm],height [nm]\n0,0\n1,1\n", {}, r"there is no table of a force curve in this text"),
    ],
)
def test_one_sentence_says_what_is_wrong(tmp_path, text, given, why):
    with pytest.raises(wk.InvalidInput, match=why) as message:
        read_curve(write(tmp_path, text), **given)
    assert "curve.csv" in str(message.value)
    assert "\n" not in str(message.value)


def test_a_file_that_is_not_there(tmp_path):
    write(tmp_path, "depth [nm],force [nN]\n0,0\n1,1\n")
    with pytest.raises(wk.InvalidInput, match=r"did you mean.*curve\.csv"):
        read_curve(tmp_path / "curv.csv")
    with pytest.raises(wk.InvalidInput, match="no path of a file"):
        read_curve(3)


def test_a_spring_constant_with_a_comma(tmp_path):
    path = tmp_path / "curve.txt"
    path.write_text("k (N/m) 1,000\nPiezo (nm)\tLoad (uN)\n0\t0\n1\t1\n", encoding="utf-8")
    with pytest.raises(wk.InvalidInput, match="'1,000' has a comma, which is ambiguous; write '1000'"):
        read_curve(path)


def test_a_file_of_noughts(tmp_path):
    path = tmp_path / "curve.jpk-force"
    path.write_bytes(bytes(100))
    with pytest.raises(wk.InvalidInput, match=r"curve\.jpk-force"):
        read_curve(path)


# ------------------------------------------------------------------------------------------------ real instruments

FILES = {
    "force_curves/fmt-jpk-fd_spot3-0192.jpk-force": ({}, 0.043493666, [(1, 2000), (-1, 2000)], 3.6813837e-9),
    "force_curves/force-save-example.jpk-force": ({}, 0.022300658, [(1, 6000), (-1, 2400)], 5.3141649e-9),
    "force_curves/fmt-jpk-cc_pr14-polymergel-2021.06.30.jpk-force": (
        {},
        0.061,
        [(1, 3000), (0, 3000), (-1, 3000)],
        1.1192040e-8,
    ),
    "force_curves/fmt-jpk-sr_cell1-0008.jpk-force": (
        {},
        1.0677,
        [(0, 256), (1, 2048), (0, 7680), (-1, 1951)],
        2.0727056e-7,
    ),
    "force_curves/fmt-ntmdt-txt-fd_2015_01_17_gel4-0,1_mQ_adh_6B_Curve_DFL_Height_51.txt": (
        {"spring_constant": 0.05, "sensitivity": 50e-9},
        0.05,
        [(1, 822), (-1, 822)],
        3.6815e-18,
    ),
    "force_curves/fmt-afm-workshop-fd_single_2020-02-14_13.41.25.csv": (
        {"spring_constant": 2.5},
        2.5,
        [(1, 1015), (-1, 1015)],
        4.2406828e-6,
    ),
    "nanoindentation/RobinSteel0000LC.txt": (
        {},
        math.inf,
        [(0, 306), (1, 1995), (0, 1005), (-1, 1998)],
        3.000027e-3,
    ),
}


@pytest.mark.parametrize("name", FILES)
def test_a_file_of_an_instrument(name, shared_data):
    given, stiffness, parts, highest = FILES[name]
    if name.startswith("force"):
        pytest.importorskip("afmformats")
    curve = read_curve(shared_data / name, **given)
    assert curve.machine_stiffness == pytest.approx(stiffness, rel=1e-6)
    assert [(int(part.direction[0]), part.count) for part in curve.parts] == parts
    assert np.max(curve.force) == pytest.approx(highest, rel=1e-6)
    # towards the sample positions grow, and so does the force
    approach = curve.approach
    assert approach.position[-1] > approach.position[0]
    assert np.mean(approach.force[-20:]) > np.mean(approach.force[:20])


def test_files_that_lack_something(shared_data):
    pytest.importorskip("afmformats")
    folder = shared_data / "force_curves"
    with pytest.raises(wk.InvalidInput, match="give spring_constant in N/m"):
        read_curve(folder / "fmt-afm-workshop-fd_single_2020-02-14_13.41.25.csv")
    with pytest.raises(wk.InvalidInput, match="give spring_constant in N/m and sensitivity in m/V"):
        read_curve(next(folder.glob("fmt-ntmdt*")))
    with pytest.raises(wk.InvalidInput, match="there is no table of a force curve in this text"):
        read_curve(shared_data / "nanoindentation" / "ISO.txt")


def test_an_indenter_with_a_cantilever(tmp_path, shared_data):
    with zipfile.ZipFile(next((shared_data / "force_curves").glob("*.zip"))) as archive:
        archive.extractall(tmp_path)
    curve = read_curve(next(tmp_path.glob("*.txt")))
    packed = read_curve(next((shared_data / "force_curves").glob("*.zip")))
    assert np.array_equal(packed.force, curve.force)
    assert packed.name.endswith(curve.name)
    assert curve.count == 13827
    assert curve.machine_stiffness == 0.019
    assert np.max(curve.force) == pytest.approx(4.924e-8)


def test_an_archive_of_curves(tmp_path):
    """Each file of an archive is read as it would be by itself, and one that cannot be read is named."""
    pytest.importorskip("afmformats")
    file = tmp_path / "curves.zip"
    inner = tmp_path / "inner.zip"
    with zipfile.ZipFile(inner, "w") as archive:
        archive.writestr("c.txt", "h [nm], F [nN]\n0, 0\n1, 1\n2, 3\n")
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr("day/b.txt", "depth [nm], force [nN]\n0, 0\n1, 2\n2, 6\n")
        archive.writestr("day/a.csv", "h (nm);F (nN)\n0;0\n1;1\n2;3\n")
        archive.writestr("__MACOSX/a.csv", "x")
        archive.writestr("notes.txt", "nothing here\n")
        archive.write(inner, "old.zip")
    first, second, third, fourth = try_curves(file)
    assert first.curve.force.tolist() == pytest.approx([0.0, 1e-9, 3e-9])
    assert second.curve.force.tolist() == pytest.approx([0.0, 2e-9, 6e-9])
    assert first.curve.name == "curves.zip, day/a.csv"
    assert third.reason.startswith(f"{file}, notes.txt: ")
    assert "an archive within an archive is not opened" in fourth.reason


def test_where_it_was_taken(shared_data):
    pytest.importorskip("afmformats")
    (placed,) = read_curves(shared_data / "force_curves" / "fmt-jpk-fd_spot3-0192.jpk-force")
    assert placed.x == pytest.approx(-16.6666667e-6)
    assert placed.y == pytest.approx(-16.6666667e-6)


@pytest.mark.parametrize(
    ("header", "stiffness"),
    [("h (nm), F (mN), t (s)", None), ("t [s], F [uN], h [nm]", None), ("Piezo (nm), Defl (nm), t (s)", 0.1)],
)
def test_columns_as_instruments_name_them(tmp_path, header, stiffness):
    """Symbols for words: depth h, force F, time t, and a cantilever's Piezo and Defl."""
    names = [part.strip()[0].lower() for part in header.split(",")]
    rows = [{"h": 10.0 * i, "p": 10.0 * i, "f": 2.0 * i, "d": 2.0 * i, "t": 0.5 * i} for i in range(12)]
    lines = [header, *(", ".join(str(row[name]) for name in names) for row in rows)]
    (tmp_path / "curve.csv").write_text("\n".join(lines), encoding="utf-8")
    curve = read_curve(tmp_path / "curve.csv", spring_constant=stiffness)
    np.testing.assert_allclose(curve.position, 1e-8 * np.arange(12), rtol=1e-12)
    unit = {"mN": 1e-3, "uN": 1e-6}.get(header.split("F ")[-1][1:3], 1e-9 * 0.1)
    np.testing.assert_allclose(curve.force, 2.0 * unit * np.arange(12), rtol=1e-12)
    np.testing.assert_allclose(curve.time, 0.5 * np.arange(12), rtol=1e-12)
