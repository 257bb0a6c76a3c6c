"""Ten thousand random histories of every law, through its compiled C file."""

from __future__ import annotations

import ctypes
import subprocess

import numpy as np
import pytest
from compiled_c import compiler
from exported_laws import PROBLEMS

from winkler.exporting.choose import law_of
from winkler.exporting.targets.c_law import c_law

HISTORIES, STEPS, SEED = 10_000, 24, 20260824
DRIVER = """
#include "law.h"
void follow(const double *motions, double *answers, int64_t histories, int64_t steps) {{
    for (int64_t k = 0; k < histories; ++k) {{
        law_state state;
        law_begin(&state);
        for (int64_t j = 0; j < steps; ++j) {{
            law_motion motion;
            law_answer answer;
            memcpy(&motion, motions + (k * steps + j) * {takes}, sizeof(motion));
            law_step(&state, &motion, &answer);
            memcpy(answers + (k * steps + j) * {gives}, &answer, sizeof(answer));
        }}
    }}
}}
"""


def compiled(folder, law):
    """Return a function that follows histories, (histories, steps, inputs)."""
    (folder / "law.h").write_text(c_law(law, "law"))
    (folder / "driver.c").write_text(DRIVER.format(takes=len(law.motion), gives=len(law.answer)))
    command = [*compiler(), "-std=c99", "-O1", "-ffp-contract=off", "-shared", "-fPIC", "driver.c", "-o", "law.so"]
    subprocess.run([*command, "-lm"], cwd=folder, check=True)
    library = ctypes.CDLL(str(folder / "law.so"))

    def follow(motions):
        motions = np.ascontiguousarray(motions)
        answers = np.empty((*motions.shape[:2], len(law.answer)))
        place = ctypes.c_void_p(motions.ctypes.data), ctypes.c_void_p(answers.ctypes.data)
        library.follow(*place, ctypes.c_int64(motions.shape[0]), ctypes.c_int64(motions.shape[1]))
        return answers

    return follow


def random_motions(law, histories):
    """Return motions of all sizes, with steps that stay, just touch, and part."""
    rng = np.random.default_rng(SEED)
    shape = (histories, STEPS)
    size = np.max(np.abs(law.trial), axis=0)
    motions = rng.normal(size=(*shape, size.size)) * size * 10.0 ** rng.uniform(-16.0, 4.0, (*shape, 1))
    deepest = np.max(law.trial[:, 0])
    depth = deepest * rng.choice([-1.0, 1.0, 1.0], shape) * 10.0 ** rng.uniform(-9.0, 0.0, (*shape,))
    depth[rng.random(shape) < 0.1] = 0.0
    for k in range(1, STEPS):  # some stay where they are, and some move by little
        stays = rng.random(histories)
        depth[:, k] = np.where(stays < 0.2, depth[:, k - 1], depth[:, k])
        depth[:, k] = np.where((stays > 0.2) & (stays < 0.4), depth[:, k - 1] * (1.0 - 1e-13), depth[:, k])
    motions[:, :, 0] = depth
    names = [one.name for one in law.motion]
    if "duration" in names:
        motions[:, :, names.index("duration")] = np.abs(motions[:, :, names.index("duration")])
    motions[rng.random(shape) < 0.1, 1:] = 0.0
    return motions


@pytest.mark.slow
@pytest.mark.parametrize("name", PROBLEMS)
def test_no_history_creates_energy(tmp_path, name):
    law = law_of(PROBLEMS[name], tolerance=1e-6, count=6)
    answers = compiled(tmp_path, law)(random_motions(law, HISTORIES))
    assert np.all(np.isfinite(answers))
    column = {one.name: answers[:, :, k] for k, one in enumerate(law.answer)}
    if "dissipation" not in column:  # no memory: the energy is a function of the depth; negative where bodies attract
        assert name == "pulled" or np.min(column["energy"]) >= 0.0
        return
    lost = column["dissipation"]
    scale = np.maximum.accumulate(np.abs(lost), axis=1)
    for other in ("stored_energy", "energy", "work"):
        if other in column:
            scale = np.maximum(scale, np.maximum.accumulate(np.abs(column[other]), axis=1))
    assert np.min(lost[:, 0] + 1e-12 * scale[:, 0]) >= 0.0
    assert np.min(np.diff(lost, axis=1) + 1e-12 * scale[:, 1:]) >= 0.0
    assert np.mean(lost[:, -1] > 0.0) > 0.5
    if "stored_energy" in column:
        assert np.min(column["stored_energy"] + 1e-12 * scale) >= 0.0
    if "work" in column:
        balance = column["work"] - column["stored_energy"] - lost
        assert np.max(np.abs(balance) / np.maximum(scale, 1e-300)) < 1e-9
