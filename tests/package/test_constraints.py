"""The files of `constraints/` agree with pyproject.toml, and the lock is whole."""

from __future__ import annotations

import importlib.util
from importlib.metadata import PackageNotFoundError, distribution

import pytest

pytest.importorskip("packaging")

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name
from packaging.version import Version


@pytest.fixture(scope="module")
def lock(root):
    spec = importlib.util.spec_from_file_location("lock", root / "constraints" / "lock.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_lowest_versions_are_those_of_pyproject(lock):
    stated = lock.read("lowest.txt")
    assert stated == lock.lowest()
    assert all(stated[canonicalize_name(requested.name)] in requested.specifier for requested in lock.direct(lock.RUN))


def test_the_lock_holds_an_allowed_version_of_each_direct_dependency(lock):
    locked = lock.read("newest.txt")
    requested = lock.direct(lock.LOCKED)
    assert [str(one) for one in requested if locked.get(canonicalize_name(one.name)) not in one.specifier] == []
    assert [name for name, number in lock.read("lowest.txt").items() if locked[name] < number] == []


def test_the_lock_holds_what_its_packages_need(lock):
    """Of those installed here in the locked version, without extras: nothing that they need is left open."""
    locked, missing = lock.read("newest.txt"), []
    for name, number in locked.items():
        try:
            found = distribution(name)
        except PackageNotFoundError:
            continue
        needs = [Requirement(text) for text in found.requires or ()] if Version(found.version) == number else []
        for requested in needs:
            if requested.marker is None or requested.marker.evaluate({"extra": ""}):
                here = locked.get(canonicalize_name(requested.name))
                if here is None or here not in requested.specifier:
                    missing.append(f"{name} needs {requested}, and the lock holds {here}")
    assert missing == []


def test_an_environment_is_compared_with_a_file(lock, monkeypatch, tmp_path, capsys):
    monkeypatch.setattr(lock, "HERE", tmp_path)
    (tmp_path / "newest.txt").write_text(f"# written\nnumpy==1.0\npackaging=={lock.installed('packaging')}\nnone==1\n")
    assert lock.main(["compare"]) == 0
    shown = capsys.readouterr().out
    assert shown.startswith("1 of 2 packages have the version of newest.txt.\nnumpy ")
    assert shown.endswith(" is newer than the locked 1.0\n")
    assert lock.main(["compare", "--equal", "newest.txt"]) == 1
    monkeypatch.setattr(lock, "direct", lambda extras: [Requirement("numpy<1.0")])
    assert lock.main(["compare"]) == 1
