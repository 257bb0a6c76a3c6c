"""Contacts that are saved and restored, and reference traces."""

from __future__ import annotations

import json

import numpy as np
import pytest

import winkler as wk
from winkler.io.contact_state import read_contacts, write_contacts
from winkler.io.traces import write_trace

GLASS = wk.HalfSpace.between(wk.Elastic(70e9, 0.22), wk.Elastic(70e9, 0.22))


@pytest.fixture
def contacts():
    fresh = wk.Contacts.apart(GLASS, curvature_radius=np.full(5, 1e-3), coefficient=0.3, reach=1e-6, rolling_arm=1e-6)
    rng = np.random.default_rng(4)
    for _ in range(6):
        fresh = fresh.moved(
            rng.uniform(-1e-7, 1e-6, 5),
            motion=rng.normal(size=(5, 2)) * 2e-7,
            twist=rng.normal(size=5) * 1e-3,
            roll=rng.normal(size=(5, 2)) * 1e-3,
        )
    return fresh


def test_contacts_go_on_as_if_nothing_had_happened(contacts, tmp_path):
    restored = read_contacts(write_contacts(contacts, tmp_path / "state.npz"))
    assert restored == contacts
    step = {"motion": np.full((5, 2), 1e-7), "twist": np.full(5, 1e-3)}
    assert restored.moved(np.full(5, 5e-7), **step) == contacts.moved(np.full(5, 5e-7), **step)
    assert [file.name for file in tmp_path.iterdir()] == ["state.npz"]


def test_a_save_that_fails_leaves_the_old_file(contacts, tmp_path, monkeypatch):
    path = write_contacts(contacts, tmp_path / "state.npz")

    def full(_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("os.fsync", full)
    with pytest.raises(wk.InvalidInput, match="no space left"):
        write_contacts(contacts.moved(np.zeros(5)), path)
    assert read_contacts(path) == contacts
    assert [file.name for file in tmp_path.iterdir()] == ["state.npz"]


def test_files_that_hold_no_contacts(contacts, tmp_path):
    with pytest.raises(wk.InvalidInput, match=r"missing\.npz: there is no such file"):
        read_contacts(tmp_path / "missing.npz")
    (tmp_path / "text.npz").write_text("depth")
    with pytest.raises(wk.InvalidInput, match="no contacts can be read"):
        read_contacts(tmp_path / "text.npz")
    whole = write_contacts(contacts, tmp_path / "state.npz").read_bytes()
    (tmp_path / "half.npz").write_bytes(whole[: len(whole) // 2])
    with pytest.raises(wk.InvalidInput, match="no contacts can be read"):
        read_contacts(tmp_path / "half.npz")
    np.savez(tmp_path / "other.npz", depth=np.zeros(3))
    with pytest.raises(wk.InvalidInput, match="no contacts can be read"):
        read_contacts(tmp_path / "other.npz")
    with np.load(tmp_path / "state.npz") as stored:
        np.savez(tmp_path / "later.npz", **{**stored, "format": np.array("winkler contacts 99")})
    with pytest.raises(wk.InvalidInput, match="does not hold"):
        read_contacts(tmp_path / "later.npz")
    with pytest.raises(wk.InvalidInput, match="folder that exists"):
        write_contacts(contacts, tmp_path / "nowhere" / "state.npz")


# ---------------------------------------------------------------------------------------------------------------------
# traces


@pytest.fixture(scope="module")
def loop():
    bed = wk.Foundation(wk.Paraboloid(1e-3), GLASS)
    shift = np.concatenate([np.linspace(0.0, 4e-7, 11), np.linspace(4e-7, -4e-7, 21), np.linspace(-4e-7, 4e-7, 21)])
    path = wk.Path(np.arange(53.0), wk.Depth(1e-6), wk.Shift(shift))
    return wk.Tangential(bed, wk.Coulomb(0.3), path).solve()


def test_a_trace_in_columns_holds_every_digit(loop, tmp_path):
    text = write_trace(loop, tmp_path / "loop.csv").read_text(encoding="utf-8").splitlines()
    comments = [line for line in text if line.startswith("# ")]
    header, *rows = text[len(comments) :]
    assert "depth [m], " in header
    names = [cell.partition(" [")[0] for cell in header.split(", ")]
    numbers = np.array([[float(cell) for cell in row.split(", ")] for row in rows])
    for name in ("time", "depth", "force", "shift", "shear_force", "dissipation", "stored_energy"):
        assert np.array_equal(numbers[:, names.index(name)], getattr(loop, name))
    assert "# problem.law.coefficient = 0.3" in comments
    assert "# problem.bed.medium.first.young = 70000000000.0 Pa" in comments
    assert any("positive in compression" in line for line in comments)
    assert any(line.startswith("# shear_force [N]:") for line in comments)


def test_a_trace_in_entries_holds_every_digit(loop, tmp_path):
    """YAML as this writer makes it: every line is a key with a JSON value, so that JSON reads it here."""
    text = write_trace(loop, tmp_path / "loop.yaml").read_text(encoding="utf-8").splitlines()
    assert text[0] == "conventions:"
    start = text.index("  shear_force:")
    assert json.loads(text[start + 1].partition(": ")[2]) == "N"
    assert np.array_equal(json.loads(text[start + 3].partition(": ")[2]), loop.shear_force)
    # YAML takes 1e-07 for a word: a number has a point
    for line in text:
        key, _, rest = line.strip().partition(": ")
        if key == "values":
            assert all("." in number for number in rest.strip("[]").split(", "))


def test_traces_of_loading_and_of_impacts(tmp_path):
    bed = wk.Foundation(wk.Paraboloid(1e-3), GLASS)
    pressed = wk.Indentation(bed, wk.Depth(np.linspace(0.0, 1e-6, 11))).solve()
    thrown = wk.Impact(bed, wk.Coulomb(0.3), mass=1e-5, velocity=0.1, lateral_velocity=0.05, count=11).solve()
    powder = wk.ElasticPlasticParticle(1e-3, wk.Elastic(1e9, 0.3, 2e7), wk.Depth(np.linspace(0.0, 1e-4, 11))).solve()
    for solution, column in (
        (pressed, "radius [m]"),
        (thrown, "sliding_velocity [m/s]"),
        (powder, "residual_depth [m]"),
    ):
        text = write_trace(solution, tmp_path / "trace.csv").read_text(encoding="utf-8")
        assert column in text
        assert len([line for line in text.splitlines() if not line.startswith("#")]) == 12
    entries = write_trace(thrown, tmp_path / "trace.yml").read_text(encoding="utf-8")
    assert '  "problem.inertia": .inf\n' in entries
    assert '  "problem.mass": 1.0e-05\n' in entries


def test_units_of_what_was_given_are_those_of_its_class(tmp_path):
    """The coefficient of friction has none, that of a shape has one."""
    pressed = wk.Indentation(wk.Foundation(wk.PowerLaw(1e3, 3.0), GLASS), wk.Force([1.0, 2.0])).solve()
    text = write_trace(pressed, tmp_path / "pressed.csv").read_text(encoding="utf-8")
    assert "# problem.bed.profile.coefficient = 1000.0 m^(1-n)\n" in text


def test_traces_that_cannot_be_written(loop, tmp_path):
    with pytest.raises(wk.InvalidInput, match="ending"):
        write_trace(loop, tmp_path / "loop.txt")
    with pytest.raises(wk.InvalidInput, match="no solution"):
        write_trace(3.0, tmp_path / "loop.csv")
    bed = wk.Foundation(wk.Paraboloid(1e-3), GLASS)
    with pytest.raises(wk.InvalidInput, match="no columns"):
        write_trace(wk.Indentation(bed, wk.Depth(1e-6)).solve(), tmp_path / "loop.csv")
    with pytest.raises(wk.InvalidInput, match="folder that exists"):
        write_trace(loop, tmp_path / "nowhere" / "loop.csv")
