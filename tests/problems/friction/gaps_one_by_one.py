"""Springs of one gap that slide under changing loads, spring by spring: even places, small even steps, extrapolated.

A second derivation of what `Tangential` by springs of one gap answers where normal load and shear force change
together.  Of the package it takes k(a), g(a) and the ratio of both stiffnesses alone.
`python tests/problems/friction/gaps_one_by_one.py` follows the golden histories in this way and writes their shifts and
losses to `gaps_one_by_one.json`; `test_gaps_one_by_one.py` compares.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import numpy as np

import winkler as wk
from winkler.problems.normal.solve_contact import at_depth, at_force

FOUND = Path(__file__).with_name("gaps_one_by_one.json")
KEYS = [
    "history/Tangential/half_space/depth-shear-varying",
    "history/Tangential/half_space/force-shear-varying",
    "history/Tangential/power_law/depth-shear-varying",
]
PLACES, STEPS = 4000, 250
"""Springs, and steps between two points of the path, of the coarsest of three runs; the next have twice the steps."""
MOST_TURNS, CLOSE = 100, 1e-13
Array = np.ndarray


def followed(bed: Any, law: wk.Coulomb, path: wk.Path, places: int, steps: int) -> Array:
    """Return shift and loss at the last point of a path under shear forces, ``(2,)``."""
    across, forces = (
        np.concatenate([each[:1], (each[:-1, None] + np.diff(each)[:, None] * np.arange(1, steps + 1) / steps).ravel()])
        for each in (path.across, path.along)
    )
    depths = at_force(bed, across)[0] if isinstance(path.normal, wk.Force) else across
    edges = float(at_depth(bed, np.array([np.max(depths)]))[1][0]) * np.linspace(0.0, 1.0, places + 1)
    normal, gap = np.diff(bed.stiffness(edges)), bed.gap(0.5 * (edges[1:] + edges[:-1]))
    lateral = normal * (bed.tangential_stiffness(edges[-1:]) / bed.normal_stiffness(edges[-1:]))
    load, shift, lost = np.zeros(places), 0.0, 0.0
    bound = law.coefficient * normal * np.maximum(depths[0] - gap, 0.0)
    for before, depth, force in zip(depths[:-1], depths[1:], forces[1:], strict=True):
        new = law.coefficient * normal * np.maximum(depth - gap, 0.0)
        # what touches within the step does so for a part of it, and moves along for that part alone
        part = np.where((bound == 0.0) & (new > 0.0), (depth - gap) / (depth - before) if depth != before else 1.0, 1.0)
        low, high, moved = -np.inf, np.inf, 0.0
        for turn in range(MOST_TURNS):
            tried = load + lateral * part * moved
            borne = np.clip(tried, -new, new)
            short = force - float(np.sum(borne))
            if abs(short) <= CLOSE * float(np.sum(new)):
                break
            low, high = (moved, high) if short > 0.0 else (low, moved)
            steep = float(np.sum((lateral * part)[np.abs(tried) < new]))
            next_ = moved + short / steep if steep > 0.0 else np.inf
            if not low < next_ < high or turn % 5 == 4:
                next_ = 0.5 * (low + high) if np.isfinite(low + high) else moved + 2.0 * short / float(np.sum(lateral))
            moved = next_
        # slip is what the motion leaves beyond the change of the load; what lets go slides until it does
        slid = np.where(bound > 0.0, moved - (borne - load) / lateral, part * moved - borne / lateral)
        gone = (bound > 0.0) & (new == 0.0)
        if np.any(gone):
            held = np.clip((before - gap[gone]) / (before - depth), 0.0, 1.0)
            slid[gone] = held * moved + load[gone] / lateral[gone]
        slid[(bound == 0.0) & (new == 0.0)] = 0.0
        lost += float(np.sum(0.5 * np.abs(slid) * (np.minimum(bound, np.abs(tried)) + np.abs(borne))))
        load, bound, shift = borne, new, shift + moved
    return np.array([shift, lost])


def limit(bed: Any, law: wk.Coulomb, path: wk.Path) -> tuple[Array, Array]:
    """Return shift and loss in the limit of many steps, and their errors ``(2,)`` each; runs are of first order."""
    runs = [followed(bed, law, path, PLACES, STEPS << k) for k in range(3)]
    ends = [2.0 * fine - coarse for coarse, fine in zip(runs[:-1], runs[1:], strict=True)]
    places = np.abs(followed(bed, law, path, PLACES // 2, STEPS) - runs[0])
    return ends[1] + (ends[1] - ends[0]) / 3.0, np.abs(ends[1] - ends[0]) + places


def main() -> None:
    """Follow the golden histories and write what they end at."""
    sys.path.insert(0, str(Path(__file__).parents[2] / "golden"))
    import histories

    found = {}
    for key in KEYS:
        rows = []
        for seed in range(histories.SEEDS):
            problem = histories.pushed(wk.Tangential, *key.split("/")[2:], seed)
            ends, errors = limit(problem.bed, problem.law, problem.path)
            rows.append(
                {"shift": [float(ends[0]), float(errors[0])], "dissipation": [float(ends[1]), float(errors[1])]}
            )
            print(key, seed, rows[-1], flush=True)
        found[key] = rows
    FOUND.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
