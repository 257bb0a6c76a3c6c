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
    """In pyproject.toml: the package reads it from its metadata, citation and archive take that of a release's tag."""
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


def test_the_recipe_for_conda_asks_for_the_same(root, project):
    jinja2 = pytest.importorskip("jinja2")
    from packaging.requirements import Requirement
    from packaging.utils import canonicalize_name

    content = {"project": project}
    text = (root / "conda" / "meta.yaml").read_text(encoding="utf-8")
    filled = jinja2.Template(text, undefined=jinja2.StrictUndefined).render(
        load_file_data=lambda path, from_recipe_dir: (
            content if (path, from_recipe_dir) == ("../pyproject.toml", True) else {}
        ),
        PYTHON="python",
    )
    recipe = yaml.safe_load(filled)
    assert recipe["package"] == {"name": project["name"], "version": project["version"]}
    assert recipe["about"]["license"] == project["license"]
    [point] = recipe["build"]["entry_points"]
    assert point == f"winkler = {project['scripts']['winkler']}"
    other = {"matplotlib": "matplotlib-base"}
    asked = {canonicalize_name(one.name): str(one.specifier) for one in map(Requirement, project["dependencies"])}
    stated = dict(line.split(" ") for line in recipe["requirements"]["run"])
    assert stated.pop("python") == project["requires-python"]
    assert stated == {other.get(name, name): bound for name, bound in asked.items()}


def test_the_manual_is_built_online_as_here(root):
    built = yaml.safe_load((root / ".readthedocs.yaml").read_text(encoding="utf-8"))
    assert (root / built["sphinx"]["configuration"]).exists()
    assert built["sphinx"]["fail_on_warning"] is True
    [lock, own] = built["python"]["install"]
    head = (root / lock["requirements"]).read_text(encoding="utf-8").partition("\n")[0]
    assert f"Python {built['build']['tools']['python']};" in head
    assert "docs" in own["extra_requirements"]
