"""Profiles of wheels and rails in files: tables, Simpack, MiniProf, two that touch; and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk

Y = np.arange(-8.0, 9.0)
Z = -0.01 * Y**2
SIMPACK = """! a rail
header.begin
  version = 1
  type    = 0   ! 0: rail
header.end
spline.begin
  approx.smooth = 0.0
  comment = 'a rail = an arc'
  shift.y = {shift}
  mirror.y = {mirror}
  bound.y.min = {least}
  bound.y.max = 100.
  {unit}
  {more}
  point.begin
    ! y  z
{points}
  point.end
spline.end
"""
MINIPROF = """Filename=rail.ban
XYPoints=17
RefPoint1=0.0000, 0.0000
ColumnDef=A,X,Y

{points}
"""


def simpack(shift=0.0, mirror=0, least=200.0, unit="units.len.f = 1000.", more="rotate = 0"):
    points = "\n".join(f"    {a:.4f} {b:.6f} 1.0" for a, b in zip(Y, Z, strict=True))
    return SIMPACK.format(shift=shift, mirror=mirror, least=least, unit=unit, more=more, points=points)


def read(tmp_path, name, text, **options):
    file = tmp_path / name
    file.write_text(text, encoding="utf-8")
    return wk.read_cross_profile(file, **options)


def test_a_table(tmp_path):
    rows = "\n".join(f"{a},{b}" for a, b in zip(Y, Z, strict=True))
    found = read(tmp_path, "rail.csv", f"y [mm],z [mm]\n{rows}\n", down=True)
    np.testing.assert_allclose(found.y, 1e-3 * Y)
    np.testing.assert_allclose(found.z, -1e-3 * Z)
    assert read(tmp_path, "rail.csv", f"lateral [mm],height [um]\n{rows}\n", mirrored=True).z[0] == pytest.approx(
        -0.64e-6
    )


def test_a_profile_of_simpack(tmp_path):
    found = read(tmp_path, "rail.prr", simpack())
    np.testing.assert_allclose(found.y, 1e-3 * Y)
    np.testing.assert_allclose(found.z, 1e-3 * Z, atol=1e-12)
    found = read(tmp_path, "rail.prr", simpack(shift=2.0, mirror=1, unit="units.len.f = 1."))
    np.testing.assert_allclose(found.y, -(Y + 2.0))
    assert read(tmp_path, "rail.prr", simpack(least=-3.0)).y.min() == pytest.approx(-3e-3)


def test_a_text_of_miniprof(tmp_path):
    points = "\n".join(f'"0.0\t{a:.4E}\t{b:.4E}' for a, b in zip(Y, Z, strict=True))
    found = read(tmp_path, "rail.ban", MINIPROF.format(points=points))
    np.testing.assert_allclose(found.y, 1e-3 * Y)
    np.testing.assert_allclose(found.z, 1e-3 * Z, atol=1e-12)


@pytest.mark.parametrize(
    ("name", "text", "sentence"),
    [
        ("a.prr", simpack(unit=""), "unit is not stated"),
        ("a.prr", simpack(more="rotate = 0.02"), "save the rotated points"),
        ("a.ban", MINIPROF.format(points="1.0 2.0"), "there are 2 numbers"),
        ("a.ban", MINIPROF.replace("A,X,Y", "X,A").format(points="1.0 2.0"), "columns X and Y are needed"),
        ("a.csv", "y,z\n1,2\n", "y"),
    ],
)
def test_other_files_are_refused(tmp_path, name, text, sentence):
    with pytest.raises(wk.InvalidInput, match=sentence):
        read(tmp_path, name, text)


def test_contact_and_winkler_read_the_same_rail(tmp_path, shared_data):
    """The rail of the Manchester benchmark, once as the table and once in MiniProf's columns (in mm, mirrored)."""
    lines = (shared_data / "reference" / "contact" / "manchester" / "rail_uic60.csv").read_text(encoding="utf-8")
    rows = [line.split(",") for line in lines.splitlines() if not line.startswith(("#", "y"))]
    points = "\n".join(f"0 {-1e3 * float(a):.6f} {1e3 * float(b):.6f}" for a, b in rows)
    one = read(tmp_path, "rail.csv", lines, down=True)
    other = read(tmp_path, "rail.ban", MINIPROF.format(points=points), down=True, mirrored=True)
    y = np.linspace(-0.03, 0.02, 21)
    np.testing.assert_allclose(one.height(y), other.height(y), atol=1e-8)


def written(folder, name, heights, places=Y):
    rows = "\n".join(f"{y},{z}" for y, z in zip(places, heights, strict=True))
    (folder / name).write_text("y [mm],z [mm]\n" + rows, encoding="utf-8")
    return folder / name


def test_each_body_of_a_pair_is_read_by_its_own_convention(tmp_path):
    rail = written(tmp_path, "rail.csv", -Z)
    wheel = written(tmp_path, "wheel.csv", 0.1 * Z - 0.01 * Y)
    lower, upper = wk.read_profile_pair(rail, wheel, down=(True, False), mirrored=(False, True), smoothing=0.0)
    assert np.array_equal(lower.z, Z / 1e3)
    assert np.array_equal(upper.y, -Y / 1e3)
    assert np.array_equal(upper.z, (0.1 * Z - 0.01 * Y) / 1e3)
    for one, other in zip(wk.read_profile_pair(rail, wheel, down=True), (Z, 0.01 * Y - 0.1 * Z), strict=True):
        assert np.allclose(one.z, other / 1e3, rtol=1e-14, atol=0.0)


def test_a_pair_that_does_not_meet_is_refused_in_one_sentence(tmp_path):
    rail, wheel = written(tmp_path, "rail.csv", Z), written(tmp_path, "wheel.csv", -0.5 * Z)
    with pytest.raises(
        wk.InvalidInput, match=r"rail\.csv and .*wheel\.csv: the profiles do not meet: .*check the units\.$"
    ):
        wk.read_profile_pair(rail, wheel, lateral=0.1)
    with pytest.raises(wk.InvalidInput, match=r"nearest at an end of them, at y = .*down=True.*profiles\.$"):
        wk.read_profile_pair(rail, wheel, down=True)
    with pytest.raises(wk.InvalidInput, match="wheel.whl"):
        wk.read_profile_pair(rail, tmp_path / "wheel.whl")


@pytest.mark.parametrize("separator", [" ", "\t", ",", ";"])
def test_two_bare_columns_need_the_unit_alone(tmp_path, separator):
    """Drawing programs write y and z without a header."""
    file = tmp_path / "rail.dat"
    file.write_text("\n".join(f"{y:.3f}{separator}{z:.5f}" for y, z in zip(Y, Z, strict=True)))
    with pytest.raises(wk.InvalidInput, match="give unit, such as unit = 'mm'"):
        wk.read_cross_profile(file)
    profile = wk.read_cross_profile(file, unit="mm")
    assert profile.y == pytest.approx(Y * 1e-3)
    assert profile.z == pytest.approx(Z * 1e-3)


def test_a_unit_that_the_file_states_is_not_given_again(tmp_path):
    file = tmp_path / "rail.csv"
    file.write_text("y [mm],z [mm]\n" + "\n".join(f"{y},{z}" for y, z in zip(Y, Z, strict=True)))
    with pytest.raises(wk.InvalidInput, match="leave unit 'm' out"):
        wk.read_cross_profile(file, unit="m")


def test_a_pair_of_bare_columns_needs_the_unit_alone(tmp_path):
    for name, sign in (("rail.dat", 1.0), ("wheel.dat", -1.0)):
        (tmp_path / name).write_text("\n".join(f"{y} {sign * 0.01 * y * y}" for y in Y))
    lower, upper = wk.read_profile_pair(tmp_path / "rail.dat", tmp_path / "wheel.dat", down=True, unit="mm")
    assert lower.z == pytest.approx(-1e-5 * Y**2)
    assert upper.z == pytest.approx(1e-5 * Y**2)
