"""Rough joints for Abaqus and CalculiX: read back by a reader written after the manuals, and by CalculiX itself."""

from __future__ import annotations

import dataclasses
import re
import shutil
import subprocess

import numpy as np
import pytest

import winkler as wk

PERIOD, NU = 1e-3, 0.3
STEEL = wk.Elastic(210e9, NU)
CONDUCTORS = wk.HeatConductors(wk.ThermalConductor(45.0), wk.ThermalConductor(15.0))
PRESSURES = np.geomspace(1e6, 200e6, 5)


@pytest.fixture(scope="module")
def joint():
    x = 2.0 * np.pi * np.arange(16) / 16
    heights = 2e-6 * (np.cos(x)[:, None] + 0.7 * np.cos(2.0 * x) + 0.4 * np.cos(3.0 * (x[:, None] + x)))
    rough = wk.Topography(heights, [PERIOD, PERIOD], periodic=True)
    return wk.SurfaceContact(rough, wk.HalfSpace.between(STEEL, STEEL), wk.Force(PRESSURES * PERIOD**2)).solve()


def read(path):
    """Return keyword with parameters -> rows of numbers; ** begins a comment, and at most 20 letters are a number."""
    found, rows = {}, []
    for line in path.read_text(encoding="ascii").splitlines():
        if line.startswith("**"):
            continue
        if line.startswith("*"):
            rows = found.setdefault(line.replace(", ", ","), [])
        else:
            words = [word.strip() for word in line.split(",")]
            assert all(len(word) <= 20 for word in words)
            rows.append([float(word) for word in words])
    return {name: np.array(rows) for name, rows in found.items()}


@pytest.mark.parametrize(("program", "unit", "many"), [("calculix", "m", 1.0), ("abaqus", "mm", 1e3)])
def test_the_tables_are_the_joint(joint, program, unit, many, tmp_path):
    """Per area: p is F over the period, the closure what the mean gap loses, heat what resistances say, by hand."""
    path = wk.write_surface_interaction(
        joint, tmp_path / "a.inp", program=program, name="JOINT", conductors=CONDUCTORS, law=wk.Coulomb(0.2),
        length_unit=unit,
    )  # fmt: skip
    found = read(path)
    assert "*SURFACE INTERACTION,NAME=JOINT" in found
    pressure, closure = found["*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=TABULAR"].T
    np.testing.assert_allclose(pressure, np.concatenate([[0.0], PRESSURES]) / many**2, rtol=1e-9)
    open_gap = np.mean(joint.problem.topography.gaps)
    np.testing.assert_allclose(closure[1:], (open_gap - joint.mean_gap) * many, rtol=1e-9)
    assert closure[0] == 0.0

    [heat] = [rows for name, rows in found.items() if name.startswith("*GAP CONDUCTANCE")]
    resistivities = [wk.ElectricalConductor(1.0 / body.conductivity) for body in (CONDUCTORS.first, CONDUCTORS.second)]
    alike = wk.SurfaceConduction(joint.problem, wk.ElectricalConductors(*resistivities), realisations=1).solve()
    expected = 1.0 / np.asarray(alike.resistance) / PERIOD**2 / many
    np.testing.assert_allclose(heat[1:, 0], expected, rtol=1e-9)
    np.testing.assert_allclose(heat[:, 1], pressure)
    assert heat[0, 0] == 0.0

    ratio = 2.0 * (1.0 - NU) / (2.0 - NU)  # Mindlin
    slope = ratio * joint.stiffness[-1] / PERIOD**2 / many**3
    if program == "calculix":
        np.testing.assert_allclose(found["*FRICTION"], [[0.2, slope]], rtol=1e-9)
        assert "*GAP CONDUCTANCE" in found
    else:
        [(name, rows)] = [one for one in found.items() if one[0].startswith("*FRICTION")]
        assert float(name.partition("ELASTIC SLIP=")[2]) == pytest.approx(0.2 * pressure[-1] / slope, rel=1e-9)
        assert rows == pytest.approx(0.2)
        assert "*GAP CONDUCTANCE,PRESSURE" in found


def test_what_is_no_joint_is_refused(joint, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    problem = joint.problem
    ball = wk.Topography(problem.topography.heights, [PERIOD, PERIOD])
    layered = wk.CoatedHalfSpace([wk.Layer(STEEL, 1e-4)], wk.Elastic(70e9, 0.3))
    some = wk.Force(PRESSURES[:2] * PERIOD**2)

    def contact(**changed):
        return dataclasses.replace(problem, load=some, **changed).solve()

    def written(answer=joint, path="a.inp", **changed):
        return wk.write_surface_interaction(answer, path, **{"program": "abaqus", **changed})

    for make, sentence in (
        (lambda: written(3.0), "a float is no contact of a map"),
        (lambda: written(path="a.txt"), "the ending is '.txt'; give .inp"),
        (lambda: written(program="ansys"), "program is 'ansys'; give abaqus or calculix"),
        (lambda: written(length_unit="in"), "length_unit is 'in'; give m or mm"),
        (lambda: written(name="my joint"), "name is 'my joint'; give letters"),
        (lambda: written(contact(topography=ball)), "the map stands alone"),
        (lambda: written(dataclasses.replace(problem, load=wk.Force(1.0)).solve()), "under at least two loads"),
        (lambda: written(dataclasses.replace(problem, load=wk.Force([2.0, 1.0])).solve()), "each above the last"),
        (lambda: written(dataclasses.replace(problem, load=wk.Force([1.0, 1e5])).solve()), "touch everywhere"),
    ):
        with pytest.raises(wk.WinklerError, match=sentence):
            make()
    with pytest.raises(wk.OutsideValidity, match="CoatedHalfSpace is not implemented"):
        written(contact(medium=layered))
    film = wk.HeatConductors(CONDUCTORS.first, CONDUCTORS.second, wk.ThermalInterface(1e-5))
    with pytest.raises(wk.OutsideValidity, match="thick conductors without film"):
        written(conductors=film)
    assert list(tmp_path.iterdir()) == []


YOUNG, HEIGHT, CLOSING, SLIDING, CONDUCTIVITY = 210e3, 0.01, 2e-3, 2e-5, 45.0


def computed(folder, interaction, kind):
    """Return force and heat through two flat bricks [N, mW], pressed by CalculiX, then pushed; each of 1 mm2."""
    corners = [(x, y, z) for z in (-HEIGHT, 0.0, 0.0, HEIGHT) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    nodes = "\n".join(f"{number}, {x}, {y}, {z}" for number, (x, y, z) in enumerate(corners, 1))
    step = "*STEP, NLGEOM, INC=1000\n*COUPLED TEMPERATURE-DISPLACEMENT, STEADY STATE\n0.05, 1.\n*BOUNDARY\n"
    asked = "*NODE PRINT, NSET=TOP, TOTALS=ONLY, FREQUENCY=1000\nRF, RFL\n*END STEP\n"
    deck = f"""*NODE, NSET=ALL
{nodes}
*ELEMENT, TYPE=C3D8, ELSET=BRICKS
1, 1, 2, 3, 4, 5, 6, 7, 8
2, 9, 10, 11, 12, 13, 14, 15, 16
*NSET, NSET=BOTTOM
1, 2, 3, 4
*NSET, NSET=TOP
13, 14, 15, 16
*MATERIAL, NAME=BRICK
*ELASTIC
{YOUNG}, 0.
*CONDUCTIVITY
{CONDUCTIVITY}
*SOLID SECTION, ELSET=BRICKS, MATERIAL=BRICK
*SURFACE, NAME=BELOW
1, S2
*SURFACE, NAME=ABOVE
2, S1
{interaction}
*CONTACT PAIR, INTERACTION=ROUGH, TYPE={kind}
ABOVE, BELOW
*INITIAL CONDITIONS, TYPE=TEMPERATURE
ALL, 0.
{step}ALL, 2, 2
BOTTOM, 1, 3
TOP, 1, 1
TOP, 3, 3, {-CLOSING}
BOTTOM, 11, 11, 0.
TOP, 11, 11, 1.
{asked}{step}TOP, 1, 1, {SLIDING}
{asked}"""
    (folder / "bricks.inp").write_text(deck, encoding="ascii")
    done = subprocess.run(["ccx", "bricks"], cwd=folder, capture_output=True, text=True, check=True, timeout=300)
    assert "*ERROR" not in done.stdout
    blocks = re.split(r" total ", (folder / "bricks.dat").read_text(encoding="ascii"))[1:]
    numbers = [[float(word) for word in block.split("\n")[2].split()] for block in blocks]
    return [part for part in numbers if len(part) == 3], [part[0] for part in numbers if len(part) == 1]


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("ccx") is None, reason="CalculiX (ccx) is not installed")
def test_by_calculix_itself(joint, tmp_path):
    """Springs in a row: brick, joint, brick; the table is read at the pressure that closes by what is left."""
    text = wk.write_surface_interaction(
        joint, tmp_path / "rough.inp", program="calculix", conductors=CONDUCTORS, law=wk.Coulomb(0.3), length_unit="mm"
    ).read_text(encoding="ascii")
    found = read(tmp_path / "rough.inp")
    (pressures, closures), heat = found["*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=TABULAR"].T, found["*GAP CONDUCTANCE"].T
    bricks = 2.0 * HEIGHT / YOUNG
    pressure = np.interp(CLOSING, closures + bricks * pressures, pressures)
    slope = found["*FRICTION"][0, 1]
    shear = SLIDING / (4.0 * HEIGHT / YOUNG + 1.0 / slope)
    forces, _ = computed(tmp_path, text, "NODE TO SURFACE")
    assert -forces[0][2] == pytest.approx(pressure, rel=1e-4)
    assert forces[1][0] == pytest.approx(shear, rel=1e-3)
    # its heat takes no pressure from a table of closures (2.20): the same lines behind a straight one
    straight = re.sub(r"=TABULAR\n[^*]*", "=LINEAR\n40000., 1.\n", text)
    forces, flows = computed(tmp_path, straight, "SURFACE TO SURFACE")
    conductance = np.interp(-forces[0][2], heat[1], heat[0])
    assert flows[0] == pytest.approx(1.0 / (2.0 * HEIGHT / CONDUCTIVITY + 1.0 / conductance), rel=1e-3)
