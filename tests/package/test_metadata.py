"""What is said in several places is the same: pyproject.toml, citation, archive, recipe, changelog."""

from __future__ import annotations

import json
import re
import tomllib

import pytest

yaml = pytest.importorskip("yaml", reason="PyYAML comes with the extra test")


@pytest.fixture(scope="module")
def project(root):
    return tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["project"]


@pytest.fixture(scope="module")
def citation(root):
    return yaml.safe_load((root / "CITATION.cff").read_text(encoding="utf-8"))


def test_the_version_is_stated_once(root, project, citation):
    """In pyproject.toml: the package reads it from its metadata, citation and archive take that of a release's tag, the
    recipe repeats it, which is compared below."""
    number = re.fullmatch(r"(\d+\.\d+\.\d+)(\.dev0)?", project["version"])
    assert number is not None
    assert "version" not in citation
    assert "version" not in json.loads((root / ".zenodo.json").read_text(encoding="utf-8"))
    changes = (root / "CHANGELOG.md").read_text(encoding="utf-8")
    heads = re.findall(r"^## (\S+) \((.*)\)$", changes, re.MULTILINE)
    assert [head for head, _ in heads] == [number[1]], "the changelog is that of the version in work"
    assert (heads[0][1] == "unreleased") == bool(number[2])
    pages = sorted(path.stem for path in (root / "docs" / "changelog").glob("[0-9]*.md"))
    assert pages == ["0.1.0", "0.2.0"]
    for name in pages:
        text = (root / "docs" / "changelog" / f"{name}.md").read_text(encoding="utf-8")
        assert text.startswith(f"# Version {name}\n")
        assert text.count("\n") <= 100, "one page for a user"
        assert f"](docs/changelog/{name}.md)" in changes


def test_authors_licence_and_title_are_the_same(root, project, citation):
    archive = json.loads((root / ".zenodo.json").read_text(encoding="utf-8"))
    [holder] = re.findall(r"^Copyright \(c\) \d+, (.*)$", (root / "LICENSE").read_text(encoding="utf-8"), re.MULTILINE)
    assert [one["name"] for one in project["authors"]] == [holder]
    assert [one["name"] for one in citation["authors"]] == [holder]
    assert [one["name"] for one in archive["creators"]] == [holder]
    assert project["license"] == citation["license"] == archive["license"]
    assert citation["title"] == archive["title"]
    assert " ".join(citation["abstract"].split()) == archive["description"]
    assert project["keywords"][0] == citation["keywords"][0] == archive["keywords"][0]
    assert citation["keywords"] == archive["keywords"]
    papers = [one["doi"] for one in citation["references"]]
    assert [one["identifier"] for one in archive["related_identifiers"]] == papers
    assert citation["url"] == project["urls"]["Documentation"]


@pytest.fixture(scope="module")
def recipe(root):
    """Return the text of the recipe, and what rattler-build makes of it where that is installed."""
    text = (root / "conda" / "recipe.yaml").read_text(encoding="utf-8")
    return text, yaml.safe_load(text.replace("${{ version }}", yaml.safe_load(text)["context"]["version"]))


def test_the_recipe_for_conda_asks_for_the_same(project, recipe):
    from packaging.requirements import Requirement
    from packaging.utils import canonicalize_name

    _, stated = recipe
    assert stated["package"] == {"name": project["name"], "version": project["version"]}
    about = stated["about"]
    assert (about["license"], about["summary"]) == (project["license"], project["description"])
    assert stated["build"]["python"]["entry_points"] == [f"winkler = {project['scripts']['winkler']}"]
    other = {"matplotlib": "matplotlib-base"}
    asked = {canonicalize_name(one.name): str(one.specifier) for one in map(Requirement, project["dependencies"])}
    run = dict(line.split(" ") for line in stated["requirements"]["run"])
    assert run.pop("python") == project["requires-python"]
    assert run == {other.get(name, name): bound for name, bound in asked.items()}


def test_rattler_build_takes_the_recipe(recipe):
    """It reads fields, bounds and licence as for a build, and refuses what it does not know."""
    rattler = pytest.importorskip("rattler_build", reason="no rattler-build here: pip install winkler[checks]")
    text, stated = recipe
    [made] = rattler.Stage0Recipe.from_yaml(text).render()
    found = made.recipe.to_dict()
    assert found["package"] == stated["package"]
    assert found["requirements"]["run"] == stated["requirements"]["run"]
    assert found["build"]["noarch"] == "python"
    for good, bad in (
        ("noarch: python", "noarch: pythons"),
        ("homepage:", "home:"),
        ("numpy >=", "numpy >>="),
        ("BSD-3-Clause", "BSD3"),
        ("${{ version }}", "${{ versions }}"),
    ):
        assert text.count(good) == 1
        with pytest.raises((rattler.RecipeParseError, rattler.RattlerBuildError)):
            rattler.Stage0Recipe.from_yaml(text.replace(good, bad)).render()


def test_the_manual_is_built_online_as_here(root):
    built = yaml.safe_load((root / ".readthedocs.yaml").read_text(encoding="utf-8"))
    assert (root / built["sphinx"]["configuration"]).exists()
    assert built["sphinx"]["fail_on_warning"] is True
    [lock, own] = built["python"]["install"]
    head = (root / lock["requirements"]).read_text(encoding="utf-8").partition("\n")[0]
    assert f"Python {built['build']['tools']['python']};" in head
    assert "docs" in own["extra_requirements"]
