"""Columns as instruments name them, units given by one key, decimal commas, and exchanged columns."""

import numpy as np
import pytest

import winkler as wk
from winkler.io.curves import read_curve, read_curves


def write(folder, text, name="curve.csv", encoding="utf-8"):
    path = folder / name
    path.write_bytes(text.encode(encoding))
    return path


HEADERS = [
    ("h,F,t", {"position": "nm", "force": "uN", "time": "s"}),
    ("Depth (nm),Load (uN),Time (s)", {}),
    ("Displacement Into Surface (nm),Load On Sample (uN),Time On Sample (s)", {}),
    ("Pd [nm],Fn [uN],Time [s]", {}),
    ("h,P,t\nnm,uN,s", {}),
    ("h (nm),F,t", {"force": "uN", "time": "s"}),
    ("Penetration depth [um],Normal force [mN],Time [ms]", {}),
]
SCALES = {"Penetration depth [um],Normal force [mN],Time [ms]": 1e3}


@pytest.mark.parametrize(("header", "units"), HEADERS)
def test_names_and_units(tmp_path, header, units):
    scale = SCALES.get(header, 1.0)
    rows = [f"{4.0 * i},{2.0 * i * i},{0.5 * i}" for i in range(5)]
    curve = read_curve(write(tmp_path, "\n".join([header, *rows])), units=units)
    i = np.arange(5.0)
    np.testing.assert_allclose(curve.position, 4e-9 * i * scale, rtol=1e-12)
    np.testing.assert_allclose(curve.force, 2e-6 * i * i * scale, rtol=1e-12)
    np.testing.assert_allclose(curve.time, 0.5 * i / scale, rtol=1e-12)


def test_the_instrument_s_own_name_comes_first(tmp_path):
    """A file that repeats the raw time, load and depth is read by the names that state the corrected ones."""
    header = "Time (s),Load (mN),Depth (nm),Displacement Into Surface (nm),Load On Sample (mN),Time On Sample (s)"
    curve = read_curve(write(tmp_path, f"{header}\n100,9,99,0,0,0\n101,9,99,1,2,1\n102,9,99,2,8,2\n"))
    np.testing.assert_allclose(curve.time, [0.0, 1.0, 2.0])
    np.testing.assert_allclose(curve.force, [0.0, 2e-3, 8e-3])
    assert "depth from 'Displacement Into Surface (nm)', force from 'Load On Sample (mN)'" in curve.reading


def test_a_stiffness_beside_the_curve(tmp_path):
    header = "Depth (nm),Load On Sample (mN),Time On Sample (s),Harmonic Contact Stiffness (N/m)"
    rows = "0,0,0,0\n10,1,1,100\n20,4,2,200\n10,1,3,900\n"
    (placed,) = read_curves(write(tmp_path, f"{header}\n{rows}"))
    np.testing.assert_allclose(placed.continuous.stiffness, [100.0, 200.0])
    np.testing.assert_allclose(placed.continuous.force, [1e-3, 4e-3])
    np.testing.assert_allclose(placed.continuous.time, [1.0, 2.0])


def test_a_cantilever_s_deflection_in_given_units(tmp_path):
    path = write(tmp_path, "Piezo,Defl\n0,0\n100,0\n200,0.5\n")
    volts = {"position": "nm", "deflection": "V"}
    curve = read_curve(path, spring_constant=0.2, sensitivity=80e-9, units=volts)
    np.testing.assert_allclose(curve.force, [0.0, 0.0, 8e-9])
    assert "spring constant 0.2 N/m given; sensitivity 8e-08 m/V given" in curve.reading
    curve = read_curve(path, spring_constant=0.2, units=volts | {"deflection": "um"})
    np.testing.assert_allclose(curve.force, [0.0, 0.0, 1e-7])


@pytest.mark.parametrize(
    ("header", "units", "why"),
    [
        ("h,F", {}, r"no unit stands with 'h' and 'F'; give it as units = \{ position = \"nm\", force = \"uN\" \}, or"),
        (
            "h,F",
            {"position": "nm"},
            r"no unit stands with 'F'; give it as units = \{ force = \"uN\" \}, or write it in",
        ),
        ("h (nm),F (uN)", {"force": "mN"}, r"the file states 'uN' for the force, and units gives force = 'mN'; leave"),
        ("h (nm),F (uN)", {"position": "m"}, r"states 'nm' for the depth, and units gives position = 'm'"),
        ("h,F", {"position": "nm", "force": "nm"}, r"units, force: 'nm' is the unit of a length, not of a force"),
        ("h,F", {"place": "nm"}, r"units: 'place' is not known; there are position, force, time"),
        ("h,F", {"forces": "nN"}, r"units: 'forces' is not known \(did you mean 'force'\?\)"),
        ("h,F", "nm", r"units is 'nm'; give the unit of each quantity, as in units = \{ position = \"nm\", force"),
        ("h,F", {"position": "florin", "force": "N"}, r"units, position: 'florin' cannot be read"),
        ("h,F", {"position": 3}, r"units is \{'position': 3\}; give the unit of each quantity"),
    ],
)
def test_units_that_are_refused(tmp_path, header, units, why):
    with pytest.raises(wk.InvalidInput, match=why) as error:
        read_curve(write(tmp_path, f"{header}\n0,0\n1,1\n"), units=units)
    assert "\n" not in str(error.value)


def test_a_unit_that_the_file_states_too(tmp_path):
    path = write(tmp_path, "h (nm),F (µN)\n0,0\n1,1\n")
    assert read_curve(path, units={"force": "uN"}).force[1] == pytest.approx(1e-6)


@pytest.mark.parametrize("encoding", ["utf-8", "latin-1", "utf-8-sig", "utf-16"])
def test_decimal_commas(tmp_path, encoding):
    path = write(tmp_path, "h (µm);F (mN)\n0,0;0,0\n0,5;1,250\n1,25;2,000\n", encoding=encoding)
    curve = read_curve(path)
    np.testing.assert_allclose(curve.position, [0.0, 0.5e-6, 1.25e-6])
    np.testing.assert_allclose(curve.force, [0.0, 1.25e-3, 2e-3])


@pytest.mark.parametrize("order", ["le", "be"])
def test_a_long_table_in_utf_16(tmp_path, order):
    """The header is read from a first part of the file, which ends within a line."""
    count = 4000
    text = "\ufefftime [s],h [µm],F [nN]\n" + "".join(f"{i},{0.5 * i},{i * i}\n" for i in range(count))
    path = tmp_path / "curve.csv"
    path.write_bytes(text.encode(f"utf-16-{order}"))
    curve = read_curve(path)
    np.testing.assert_allclose(curve.position, 0.5e-6 * np.arange(count))
    np.testing.assert_allclose(curve.force, 1e-9 * np.arange(count) ** 2)


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("h (nm);F (mN)\n1,000;2,000\n3,000;4,000\n", "line 2: '1,000' has a comma, which is ambiguous"),
        ("h (nm);F (mN)\n1.000,5;2\n3,5;4\n", r"line 2: '1.000,5' has a comma"),
        ("h (nm),F (mN)\n1,5,2,5\n", "if commas mark decimals or group thousands"),
        ("h (nm);F (mN)\n1.5;2,5\n2.5;3,5\n", "line 2: '2,5' has a comma, and '1.5' a point"),
    ],
)
def test_commas_that_are_refused(tmp_path, text, why):
    with pytest.raises(wk.InvalidInput, match=why):
        read_curve(write(tmp_path, text))


LOAD = np.concatenate([np.linspace(0.0, 1.0, 60), np.linspace(1.0, 0.0, 40)])


@pytest.mark.parametrize("exponent", [1.0, 1.5, 2.0])
def test_exchanged_columns_are_a_doubt(tmp_path, exponent):
    """Force over depth is convex under a punch, ball or cone; exchanged it is concave, which the reading says."""
    force = LOAD**exponent
    rows = [f"{100 * h},{100 * f}" for h, f in zip(LOAD, force, strict=True)]
    right = read_curve(write(tmp_path, "\n".join(["h (nm),F (uN)", *rows])))
    assert "doubtful" not in right.reading
    exchanged = read_curve(write(tmp_path, "\n".join(["F (uN),h (nm)", *rows])))
    assert ("position and force may be exchanged" in exchanged.reading) == (exponent > 1.0)


def test_exchanged_columns_of_a_microscope(tmp_path):
    """Out of contact the force is constant while the piezo travels, not the piezo while the force rises."""
    travel = np.linspace(0.0, 1.0, 100)
    force = np.maximum(0.0, travel - 0.6) ** 1.5
    rows = [f"{1000 * z},{10 * f}" for z, f in zip(travel, force, strict=True)]
    for header, doubtful in (("piezo (nm),force (nN)", False), ("force (nN),piezo (nm)", True)):
        curve = read_curve(write(tmp_path, "\n".join([header, *rows])), spring_constant=0.1)
        assert ("may be exchanged" in curve.reading) == doubtful


@pytest.mark.parametrize("name", ["Extension", "Standard travel", "Course standard", "Traversenweg"])
def test_a_testing_machine_needs_no_spring_constant(tmp_path, name):
    rows = [f"{0.01 * h},{100 * h**1.5}" for h in LOAD]
    path = write(tmp_path, "\n".join([f"{name} (mm),Load (N)", *rows]))
    assert read_curve(path).machine_stiffness == np.inf
    assert "the position is taken as that of the tip, for no spring constant is stated" in read_curve(path).reading
    assert read_curve(path, spring_constant=5e6).machine_stiffness == 5e6
    piezo = write(tmp_path, "\n".join(["piezo (um),Load (uN)", *rows]), name="piezo.csv")
    with pytest.raises(wk.InvalidInput, match="give spring_constant in N/m"):
        read_curve(piezo)
