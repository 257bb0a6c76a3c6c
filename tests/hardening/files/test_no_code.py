"""What comes from a stranger runs no code: a payload that would leave a file behind leaves none."""

from __future__ import annotations

import os

import numpy as np
import pytest

import winkler as wk
from winkler.cli import main
from winkler.io.contact_state import read_contacts
from winkler.io.wear_states import read_wear


class Payload:
    """Unpickled, it makes a folder."""

    def __init__(self, folder):
        self.folder = str(folder)

    def __reduce__(self):
        return os.mkdir, (self.folder,)


def test_the_payload_works(tmp_path):
    np.save(tmp_path / "payload.npy", np.array([Payload(tmp_path / "done")], dtype=object))
    np.load(tmp_path / "payload.npy", allow_pickle=True)
    assert (tmp_path / "done").is_dir()


def worn(path):
    return read_wear(path, wk.Foundation(wk.Paraboloid(0.01), wk.HalfSpace(wk.Elastic(1e9, 0.3))))


READERS = (read_contacts, worn, wk.read_profile, wk.read_curve, wk.read_bed)
CASES = [(reader, ending) for reader in READERS for ending in (".npy", ".npz", ".csv", ".pkl")]
CASES += [(wk.read_topography, ".npy"), (wk.read_topography, ".npz")]


@pytest.mark.parametrize(("reader", "ending"), CASES)
def test_nothing_is_unpickled(reader, ending, tmp_path):
    path, payload = tmp_path / f"payload{ending}", np.array([Payload(tmp_path / "done")], dtype=object)
    with path.open("wb") as file:
        if ending == ".npz":
            np.savez(file, **dict.fromkeys(("format", "heights"), payload))
        elif ending == ".pkl":
            file.write(payload.dumps())
        else:
            np.save(file, payload)
    with pytest.raises(wk.WinklerError):
        reader(path)
    assert not (tmp_path / "done").exists()


@pytest.mark.parametrize(
    "text",
    [
        "__import__('os').mkdir('done')",
        "r**2 + (lambda: __import__('os').mkdir('done'))()",
        "().__class__.__base__.__subclasses__()",
        "r.__class__",
        "[r for r in (1,)]",
        "exec('import os')",
        "r**2 if r else r",
        "{r}",
        "f'{r}'",
    ],
)
def test_a_formula_runs_no_code(text, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(wk.InvalidInput):
        wk.Formula(text)
    (tmp_path / "study.toml").write_text(
        f'[problem]\nkind = "indentation"\nload = {{ kind = "depth", depth = "1 um" }}\n[problem.bed]\n'
        f'kind = "foundation"\nprofile = {{ kind = "formula", expression = """{text}""", reach = "1 mm" }}\n'
        '[problem.bed.medium]\nkind = "half_space"\nfirst = { kind = "elastic", young = "1 GPa", poisson = 0.3 }\n'
    )
    assert main(["run", "study.toml", "--quiet"]) == 2
    assert capsys.readouterr().err.startswith("winkler: ")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["study.toml"]
