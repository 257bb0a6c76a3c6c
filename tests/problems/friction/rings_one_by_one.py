"""Rings that slide under changing loads, spring by spring: even places, small even steps, extrapolated.

A second derivation of what `winkler.problems.ring_slip` answers.  Of the engine it takes the bound of a press and the
weights of springs alone, read at even places; in each step springs move along, and those beyond the bound return to it.
`python tests/problems/friction/rings_one_by_one.py` follows the golden histories of rings in this way and writes what
they end at to `rings_one_by_one.json`; `test_rings_one_by_one.py` compares.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import winkler as wk
from winkler.foundation.torsion_bound import PressedState, TwistBound, twist_bound
from winkler.problems.normal.solve_contact import at_depth, at_force
from winkler.problems.ring_slip.push_bound import push_bound

FOUND = Path(__file__).with_name("rings_one_by_one.json")
GOLDEN = Path(__file__).parents[2] / "golden"
RINGS = [GOLDEN / "numbers" / f"{number}-history-lasting.json" for number in (18, 19)]
"""Golden numbers of rings under changing loads, of class W; of two of one group the later counts."""
PLACES, STEPS = 600, 50
"""Springs, and steps between two points of the path, of the coarsest of three runs; each is doubled once."""
ROUNDING = 1e-12
MOST_FINER = 4
"""By how much runs are finer at most."""
Array = np.ndarray


def stepped(
    bed: Any, bound_of: Callable[..., TwistBound], law: wk.Coulomb, path: wk.Path, unit: float, places: int, steps: int
) -> Array:
    """Return motion, load, stored energy and loss at the points of a path, ``(points, 4)``.

    `unit` is what a stuck spring bears over its motion: 8 G_t of a twist [Pa], G* of a push [Pa].
    """
    forced, moved = isinstance(path.normal, wk.Force), isinstance(path.lateral, wk.Shift | wk.Angle)
    parts = np.arange(1, steps + 1) / steps
    levels, targets = (
        np.concatenate([each[:1], (each[:-1, None] + np.diff(each)[:, None] * parts).ravel()])
        for each in (path.across, path.along * (unit if moved else 1.0))
    )
    radii = (at_force if forced else at_depth)(bed, levels)[1]
    bound = bound_of(bed, law.coefficient, float(np.max(radii)), forced)
    width = float(np.max(radii)) / places
    x = width * (np.arange(places) + 0.5)
    panel = bound.panels.panel(x)
    reading = bound.panels.reading(x, panel)

    def read(values: Array) -> Array:
        return np.asarray(np.sum(reading * values[panel], axis=-1))

    weight, touch = 2.0 * width * read(bound.weight), read(bound.clock)
    bears, limit, before, motion, lost = np.zeros(places), np.zeros(places), levels[0], 0.0, 0.0
    points = []
    for level, radius, target in zip(levels, radii, targets, strict=True):
        press = PressedState(float(level), float(radius), 0.0)
        allowed = np.where(x < radius, np.maximum(read(bound.at(press)), 0.0), 0.0)
        share = np.clip((level - touch) / (level - before), 0.0, 1.0) if level > before else np.ones(places)
        low, high, move = -np.inf, np.inf, target - motion if moved else 0.0
        while True:
            free = bears + move * share
            after = np.clip(free, -allowed, allowed)
            missed = weight @ after - target
            if moved or abs(missed) <= 1e-13 * np.max(np.abs(path.along)):
                break
            low, high = (move, high) if missed < 0.0 else (low, move)
            ahead = move - missed / (weight @ np.where(np.abs(free) < allowed, share, 0.0) or weight.sum())
            following = ahead if low < ahead < high else 0.5 * (low + high)
            if following == move:
                break
            move = following
        lost += weight @ (np.abs(free - after) * np.where(limit > 0.0, 0.5 * (limit + allowed), allowed))
        bears, limit, before, motion = after, allowed, level, motion + move
        points.append((motion / unit, weight @ bears, 0.5 * weight @ bears**2 / unit, lost / unit))
    return np.array(points)[::steps]


def extrapolated(*given: Any, finer: int = 1) -> Array:
    """Return the limit of ever more places and steps of `stepped`, in both of second order."""
    runs = ((PLACES, STEPS), (PLACES, 2 * STEPS), (2 * PLACES, 2 * STEPS))
    coarse, fine, dense = (stepped(*given, *(finer * each for each in run)) for run in runs)
    return np.asarray(fine + (fine - coarse) / 3.0 + (dense - fine) * 4.0 / 3.0)


def given_of(problem: Any) -> tuple[Any, ...]:
    """Return what `stepped` needs of a push or a twist."""
    medium = problem.bed.medium
    twisted = isinstance(problem, wk.Torsion)
    unit = 8.0 * medium.torsional_modulus if twisted else medium.shear_modulus
    return problem.bed, twist_bound if twisted else push_bound, problem.law, problem.path, unit


def golden() -> dict[str, Any]:
    """Return the golden numbers of rings, group by group."""
    return {name: group for file in RINGS for name, group in json.loads(file.read_text()).items()}


def ends(row: dict[str, list[float]]) -> Array:
    """Return what a golden history ends at: motion [rad or m], load, stored energy, loss and work [J]."""
    two = ("angle", "torque") if "angle" in row else ("shift", "shear_force")
    return np.array([row[name][-1] for name in (*two, "stored_energy", "dissipation", "work")])


def with_work(row: Array) -> Array:
    """Return motion, load, stored energy and loss, and the sum of both energies."""
    return np.append(row, row[2] + row[3])


def scales(row: Array) -> Array:
    """Return what differences of each number of `with_work` count over: of energies the one that is stored."""
    return np.abs([row[0], row[1], *[max(row[2], row[3])] * 3])


def missed(stored: Array, error: float, coarse: Array, fine: Array) -> float:
    """Return the greatest difference, over the stated error of a number and what the finer of two limits moved."""
    rounding = ROUNDING * scales(fine)
    coarse, fine = with_work(coarse), with_work(fine)
    return float(np.max(np.abs(stored - fine) / (error * np.abs(fine) + np.abs(fine - coarse) + rounding)))


def main() -> None:
    """Follow the golden histories of rings; in finer runs what is not confirmed."""
    sys.path.insert(0, str(GOLDEN))
    from histories import GROUPS

    found: dict[str, list[Any]] = {}
    for name, group in golden().items():
        rows = found[name] = []
        for seed, row in enumerate(group["rows"]):
            given = given_of(GROUPS[name.removeprefix("history/")](seed))
            stored = ends(dict(zip(group["names"], row, strict=True)))
            finer, fine = 1, extrapolated(*given)[-1]
            while True:
                finer, coarse, fine = 2 * finer, fine, extrapolated(*given, finer=2 * finer)[-1]
                if finer == MOST_FINER or missed(stored, group["error"][seed], coarse, fine) <= 1.0:
                    break
            rows.append([finer, coarse.tolist(), fine.tolist()])
            print(name, seed, rows[-1], file=sys.stderr, flush=True)
    FOUND.write_text(json.dumps(found))


if __name__ == "__main__":
    main()
