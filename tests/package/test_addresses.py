"""Addresses are stated in pyproject.toml; other files follow it: the manual's, and the repository's if it has one."""

from __future__ import annotations

import re
import shutil
import tomllib

import pytest

yaml = pytest.importorskip("yaml", reason="PyYAML comes with the extra test")

FOLLOWERS = ("pyproject.toml", "CITATION.cff", "README.md", "conda/recipe.yaml")
HOST = "https://code.example.org/somebody/winkler"


def wrong_addresses(root) -> list[str]:
    """Return a line for each address that does not follow `Documentation` and `Source` of pyproject.toml."""
    urls = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["project"]["urls"]
    manual, source = urls["Documentation"], urls.get("Source")
    citation = yaml.safe_load((root / "CITATION.cff").read_text(encoding="utf-8"))
    about = yaml.safe_load((root / "conda" / "recipe.yaml").read_text(encoding="utf-8"))["about"]
    stated = {
        "pyproject.toml, Changelog": (urls.get("Changelog"), f"{manual}changelog/index.html"),
        "pyproject.toml, Issues": (urls.get("Issues"), source and f"{source}/issues"),
        "CITATION.cff, url": (citation.get("url"), manual),
        "CITATION.cff, repository-code": (citation.get("repository-code"), source),
        "conda/recipe.yaml, homepage": (about.get("homepage"), manual),
        "conda/recipe.yaml, repository": (about.get("repository"), source),
    }
    wrong = [f"{place}: {found}, not {wanted}" for place, (found, wanted) in stated.items() if found != wanted]
    links = re.findall(r"https://[^\s)\"'>]+", (root / "README.md").read_text(encoding="utf-8"))
    return wrong + [f"README.md: {one}" for one in links if not one.startswith((manual, source or manual))]


def test_all_addresses_follow_those_of_pyproject(root):
    assert wrong_addresses(root) == []


def test_what_an_owner_has_to_change_is_named(root, tmp_path):
    """First the repository gets a host, then the manual moves: each line that stays behind is named."""
    for name in FOLLOWERS:
        (tmp_path / name).parent.mkdir(exist_ok=True)
        shutil.copy(root / name, tmp_path / name)

    def write(name, old, new):
        path = tmp_path / name
        text = path.read_text(encoding="utf-8")
        assert old in text
        path.write_text(text.replace(old, new), encoding="utf-8")

    urls = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["project"]["urls"]
    if "Source" not in urls:
        write("pyproject.toml", "[project.urls]\n", f'[project.urls]\nSource = "{HOST}"\n')
        assert [line.partition(":")[0] for line in wrong_addresses(tmp_path)] == [
            "pyproject.toml, Issues", "CITATION.cff, repository-code", "conda/recipe.yaml, repository",
        ]  # fmt: skip
        write("pyproject.toml", "[project.urls]\n", f'[project.urls]\nIssues = "{HOST}/issues"\n')
        write("CITATION.cff", "type: software\n", f'type: software\nrepository-code: "{HOST}"\n')
        write("conda/recipe.yaml", "about:\n", f"about:\n  repository: {HOST}\n")
        assert wrong_addresses(tmp_path) == []
    write(
        "pyproject.toml", f'Documentation = "{urls["Documentation"]}"', 'Documentation = "https://manual.example.org/"'
    )
    wrong = wrong_addresses(tmp_path)
    assert {line.partition(":")[0] for line in wrong} == {
        "pyproject.toml, Changelog", "CITATION.cff, url", "conda/recipe.yaml, homepage", "README.md",
    }  # fmt: skip
    assert len(wrong) > 40
