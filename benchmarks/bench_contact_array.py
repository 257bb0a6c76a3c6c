"""Steps of contacts in arrays, law by law: bytes and processor time of each contact.

Four steps of 100,000 contacts with 8 springs, a tenth of them open, as in bench_contacts.py: rows for measure.py.
The time is that of the processor, summed over cores, so that what else runs on the machine hardly counts.
"""

from __future__ import annotations

import statistics
import time

import numpy as np
from bench_contacts import BEAD, LAWS, moved

import winkler as wk

ROUNDS = 3
WORDS = {
    "hertz": "Hertz, a table",
    "balls": "balls with friction",
    "turning": "balls with friction, twist and rolling",
    "friction": "a paraboloid by a table, with friction",
    "adhesion": "balls that attract",
    "yield": "particles that yield",
}


def rows_of(name: str, many: int, rounds: int = ROUNDS) -> list[str]:
    """Return a row: bytes of a contact, processor time of its step, steps a second."""
    contacts = wk.ContactArray(LAWS.get(name, BEAD), many, count=8)
    steps = moved(contacts)
    if name == "turning":
        rng = np.random.default_rng(2)
        turns = {"twist": rng.normal(scale=1e-4, size=many), "roll": rng.normal(scale=1e-4, size=(many, 2))}
        steps = [step | turns for step in steps]
    times = []
    for _ in range(rounds + 1):
        begin = time.process_time()
        for step in steps:
            contacts.step(**step)
        times.append((time.process_time() - begin) / (len(steps) * many))
    spent = statistics.median(times[1:])
    return [f"{contacts.bytes_for(many) / many:.0f}", f"{1e9 * spent:.0f} ns", f"{1.0 / spent:.2g}"]
