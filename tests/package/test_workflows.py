"""The workflows run their commands on the systems that the package names, and only the last step may publish."""

from __future__ import annotations

import re
import tomllib

import pytest

yaml = pytest.importorskip("yaml", reason="PyYAML comes with the extra test")

SYSTEMS = {"ubuntu": "POSIX :: Linux", "macos": "MacOS", "windows": "Microsoft :: Windows"}


@pytest.fixture(scope="module", params=["ci", "release"])
def text(root, request):
    folder = root / ".github" / "workflows"
    if not folder.is_dir():
        pytest.skip("the workflows are not in this copy")
    assert sorted(path.name for path in folder.iterdir()) == ["ci.yml", "release.yml", "weekly.yml"]
    return (folder / f"{request.param}.yml").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def workflow(text):
    return yaml.safe_load(text)


def test_each_action_is_pinned_by_its_commit(text):
    used = re.findall(r"uses: *(.*)$", text, re.MULTILINE)
    assert len(used) >= 4
    assert [line for line in used if not re.fullmatch(r"[\w-]+/[\w-]+@[0-9a-f]{40} # v\d+\.\d+\.\d+", line)] == []


def test_the_matrix_is_what_the_package_names(root, workflow):
    project = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    matrix = workflow["jobs"]["tests"]["strategy"]["matrix"]
    stated = [f"Operating System :: {SYSTEMS[name.partition('-')[0]]}" for name in matrix["system"]]
    assert sorted(stated) == sorted(one for one in project["classifiers"] if one.startswith("Operating System"))
    stated = [f"Programming Language :: Python :: {number}" for number in matrix["python"]]
    assert stated == [one for one in project["classifiers"] if re.search(r"Python :: 3\.", one)]
    assert project["requires-python"] == f">={matrix['python'][0]}"


def test_all_that_must_hold_is_run(workflow):
    command = "WINKLER_CI_LONG=1 .ci/run" if "publish" in workflow["jobs"] else ".ci/run"
    assert {"run": command} in workflow["jobs"]["all"]["steps"]
    assert any("pytest" in step.get("run", "") for step in workflow["jobs"]["tests"]["steps"])


def test_only_publishing_may_write_and_it_waits_for_the_tests(workflow):
    assert workflow["permissions"] == {"contents": "read"}
    assert "secrets." not in str(workflow)
    jobs = workflow["jobs"]
    may = {name for name, job in jobs.items() if "permissions" in job or "environment" in job}
    assert may == ({"publish"} if "publish" in jobs else set())
    for job in jobs.values():
        checkouts = [step["with"] for step in job["steps"] if step.get("uses", "").startswith("actions/checkout")]
        assert all(given["persist-credentials"] is False for given in checkouts)
    if "publish" in jobs:
        assert set(jobs["publish"]["needs"]) == set(jobs) - {"publish"}
        assert jobs["tests"]["needs"] == "build"
        assert not any("run" in step for step in jobs["publish"]["steps"]), "what publishes runs no code of ours"


def test_the_manual_is_built_for_each_change_and_the_files_are_looked_at(root):
    folder = root / ".github" / "workflows"
    if not folder.is_dir():
        pytest.skip("the workflows are not in this copy")
    jobs = {
        name: yaml.safe_load((folder / f"{name}.yml").read_text(encoding="utf-8"))["jobs"] for name in ("ci", "release")
    }
    assert any("sphinx -W" in step.get("run", "") for step in jobs["ci"]["manual"]["steps"])
    done = " ".join(step.get("run", "") for step in jobs["release"]["build"]["steps"])
    for tool in ("twine check --strict", "check-wheel-contents", "validate-pyproject"):
        assert tool in done


def test_the_weekly_run_may_fail_alone(root):
    path = root / ".github" / "workflows" / "weekly.yml"
    if not path.exists():
        pytest.skip("the workflows are not in this copy")
    text = path.read_text(encoding="utf-8")
    used = re.findall(r"uses: *(.*)$", text, re.MULTILINE)
    assert [line for line in used if not re.fullmatch(r"[\w-]+/[\w-]+@[0-9a-f]{40} # v\d+\.\d+\.\d+", line)] == []
    content = yaml.safe_load(text)
    assert content["permissions"] == {"contents": "read"}
    assert set(content[True]) == {"schedule", "workflow_dispatch"}
    newest = {one["python"] for one in content["jobs"]["newest"]["strategy"]["matrix"]["include"]}
    assert newest == {"3.14", "3.15"}
    assert "3.14t" in text
