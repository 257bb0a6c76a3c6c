"""Ten thousand random histories of every law, through its compiled C file."""

from __future__ import annotations

import ctypes
import subprocess

import numpy as np
import pytest
from compiled_c import compiler
from exported_laws import PROBLEMS, random_motions

from winkler.exporting.choose import law_of
from winkler.exporting.targets.c_law import c_law

HISTORIES = 10_000
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


@pytest.mark.few(0, slow=3)
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
