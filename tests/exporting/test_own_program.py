"""The complete example of the manual: a ball that bounces on an exported law, in C."""

from __future__ import annotations

import re
import subprocess

import numpy as np
import pytest
from compiled_c import compiler

from winkler.cli import main


def test_the_ball_of_the_manual_bounces_as_hertz_has_it(root, tmp_path, capsys):
    study = root / "examples" / "studies" / "normal" / "hertz.toml"
    assert main(["export", str(study), "--to", "c", "--output", str(tmp_path)]) in (0, None)
    assert "contact.h written" in capsys.readouterr().out
    program = tmp_path / "bouncing_ball"
    source = root / "examples" / "exchange" / "bouncing_ball.c"
    command = [
        *compiler(),
        "-std=c99",
        "-Wall",
        "-Wextra",
        "-O0",
        f"-I{tmp_path}",
        str(source),
        "-o",
        str(program),
        "-lm",
    ]
    made = subprocess.run(command, capture_output=True, text=True, check=True)
    assert made.stderr == ""
    text = subprocess.run([program], capture_output=True, text=True, check=True).stdout
    assert text in (root / "docs" / "tutorials" / "own-program.md").read_text(encoding="utf-8")
    time, depth, force, restitution, off = map(float, re.findall(r"(\d[\d.e+-]*\d)", text))
    modulus, radius, mass, velocity = 210e9 / (2.0 * (1.0 - 0.3**2)), 10e-3, 0.0327, 0.005
    deepest = (15.0 / 16.0 * mass * velocity**2 / (modulus * np.sqrt(radius))) ** 0.4
    assert depth * 1e-6 == pytest.approx(deepest, rel=1e-4)
    assert time * 1e-6 == pytest.approx(2.943275 * deepest / velocity, rel=2e-4)  # Johnson 1985, eq. 11.24
    assert force == pytest.approx(4.0 / 3.0 * modulus * np.sqrt(radius) * deepest**1.5, rel=1e-4)
    assert restitution == pytest.approx(1.0, abs=1e-6)
    assert off < 1e-7


def test_existing_files_are_not_replaced_without_consent(root, tmp_path, capsys):
    study = str(root / "examples" / "studies" / "normal" / "hertz.toml")
    command = ["export", study, "--to", "python", "--output", str(tmp_path), "--name", "ball"]
    main(command)
    assert main(command) == 2
    assert "exists; add --overwrite" in capsys.readouterr().err
    assert main([*command, "--overwrite"]) in (0, None)
