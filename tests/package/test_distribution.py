"""What is shipped: the wheel holds the package and nothing else, and the source archive what its tests need.

The archives are those of the folder that `WINKLER_DIST` names; `.ci/run` and the release build them there.
"""

from __future__ import annotations

import json
import os
import tarfile
import tomllib
import zipfile
from email import message_from_string
from pathlib import Path, PurePosixPath

import pytest
from project_files import project_files

FOLDERS = {"src", "tests", "examples", "docs", "benchmarks", "constraints", "conda"}
PAGES = {
    ".readthedocs.yaml", ".zenodo.json", "README.md", "CHANGELOG.md", "CODE_OF_CONDUCT.md", "CONTRIBUTING.md",
    "SECURITY.md", "CITATION.cff", "LICENSE",
}  # fmt: skip
MADE = {"PKG-INFO", "pyproject.toml", ".gitignore"}
LARGEST = 500_000  # bytes of one file
ENDINGS = {".py", ".toml", ".md", ".csv", ".css", ".js", ".bib", ".typed", ".html", ".npz", ".wasm", ".sha256"}


@pytest.fixture(scope="module")
def project(root):
    return tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["project"]


@pytest.fixture(scope="module")
def dist():
    folder = os.environ.get("WINKLER_DIST")
    if not folder:
        pytest.skip("WINKLER_DIST names no folder with a wheel and a source archive")
    return Path(folder)


@pytest.fixture(scope="module")
def wheel(dist):
    [path] = dist.glob("*.whl")
    with zipfile.ZipFile(path) as archive:
        return {item.filename: (item.file_size, archive.read(item)) for item in archive.infolist()}


@pytest.fixture(scope="module")
def source(dist):
    [path] = dist.glob("*.tar.gz")
    with tarfile.open(path) as archive:
        assert all(item.isfile() or item.isdir() for item in archive.getmembers()), "a link was packed"
        return {item.name.partition("/")[2]: item.size for item in archive.getmembers() if item.isfile()}


def files(folder: Path) -> set[str]:
    """Return the files below a folder that git would keep, as paths from the folder that holds it."""
    return {path.relative_to(folder.parent).as_posix() for path in project_files(folder)}


def test_the_wheel_holds_the_package(root, wheel, project):
    info = f"winkler-{project['version']}.dist-info"
    made = {f"{info}/{name}" for name in ("METADATA", "WHEEL", "RECORD", "entry_points.txt", "licenses/LICENSE")}
    assert set(wheel) - made == files(root / "src" / "winkler")
    assert made <= set(wheel)
    assert wheel[f"{info}/licenses/LICENSE"][1] == (root / "LICENSE").read_bytes()


def test_the_wheel_says_what_pyproject_says(wheel, project):
    [text] = [content.decode() for name, (_, content) in wheel.items() if name.endswith(".dist-info/METADATA")]
    stated = message_from_string(text)
    assert (stated["Name"], stated["Version"]) == (project["name"], project["version"])
    assert stated["License-Expression"] == project["license"]
    assert stated.get_all("License-File") == project["license-files"]
    assert stated["Requires-Python"] == project["requires-python"]
    assert stated.get_all("Classifier") == project["classifiers"]
    needed = [text for text in stated.get_all("Requires-Dist") if "extra ==" not in text]
    assert len(needed) == len(project["dependencies"])
    [tag] = [content.decode() for name, (_, content) in wheel.items() if name.endswith(".dist-info/WHEEL")]
    assert "\nTag: py3-none-any\n" in tag


def test_the_source_archive_holds_what_its_tests_need(root, source):
    assert {name.partition("/")[0] for name in source} == FOLDERS | PAGES | MADE
    for folder in ("src", "constraints", "benchmarks"):
        assert {name for name in source if name.startswith(f"{folder}/")} == files(root / folder)
    assert {"tests/conftest.py", "docs/conf.py", "examples/studies/normal/measured_tip.toml"} <= set(source)


def test_nothing_large_and_nothing_foreign_is_shipped(wheel, source):
    sizes = {**source, **{name: size for name, (size, _) in wheel.items()}}
    assert {name: size for name, size in sizes.items() if size > LARGEST} == {}
    assert {name for name in wheel if PurePosixPath(name).suffix not in ENDINGS and ".dist-info/" not in name} == set()
    left = ("results/", "__pycache__", ".hypothesis", "docs/gallery", "docs/_build", ".egg-info", ".venv")
    assert [name for name in sizes if any(word in name for word in left)] == []


def test_the_bill_of_materials_is_that_of_the_lock(root, dist, project):
    """The release makes it; the components are those of the lock, and all that winkler needs is among them."""
    from packaging.requirements import Requirement
    from packaging.utils import canonicalize_name

    bills = list(dist.glob("*.cdx.json"))
    if not bills:
        pytest.skip("only the release makes a bill of materials")
    [bill] = [json.loads(path.read_text(encoding="utf-8")) for path in bills]
    assert bill["bomFormat"] == "CycloneDX"
    assert (bill["metadata"]["component"]["name"], bill["metadata"]["component"]["version"]) == (
        project["name"],
        project["version"],
    )
    found = {f"{canonicalize_name(one['name'])}=={one['version']}" for one in bill["components"]}
    assert found <= set((root / "constraints" / "newest.txt").read_text(encoding="utf-8").splitlines())
    names = {line.partition("==")[0] for line in found}
    assert {canonicalize_name(Requirement(text).name) for text in project["dependencies"]} <= names
    assert [one["name"] for one in bill["components"] if not one.get("licenses")] == []
