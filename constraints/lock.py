"""The versions that winkler is tested with: writes them down, and compares an environment with them.

    python constraints/lock.py lowest       write lowest.txt: the lower bounds that pyproject.toml states
    python constraints/lock.py newest       ask pip for the newest versions that it allows, and write newest.txt
    python constraints/lock.py compare      say where this environment differs from newest.txt
    python constraints/lock.py compare --equal newest.txt
                                            and fail where it does

`docs/releases.md` says which environment is held to which file.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tomllib
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name
from packaging.version import Version

HERE = Path(__file__).resolve().parent
TREE = HERE.parent
RUN = ("afm", "app", "cluster", "topography", "test")
"""The extras whose lower bounds are tested; those left out hold tools that no user of winkler needs."""
LOCKED = (*RUN, "docs", "dev", "checks", "release")


def direct(extras: tuple[str, ...]) -> list[Requirement]:
    """Return what pyproject.toml asks for: to build winkler, to run it, and for these extras."""
    content = tomllib.loads((TREE / "pyproject.toml").read_text(encoding="utf-8"))
    project = content["project"]
    asked = [*content["build-system"]["requires"], *project["dependencies"]]
    for extra in extras:
        asked += project["optional-dependencies"][extra]
    return [Requirement(text) for text in asked]


def lowest() -> dict[str, Version]:
    """Return the lower bound of each direct dependency; one that is asked for twice has the same bound twice."""
    bounds: dict[str, Version] = {}
    for asked in direct(RUN):
        [bound] = [Version(part.version) for part in asked.specifier if part.operator == ">="]
        name = canonicalize_name(asked.name)
        if bounds.setdefault(name, bound) != bound:
            raise SystemExit(f"pyproject.toml states two lower bounds for {name}: {bounds[name]} and {bound}.")
    return bounds


def newest() -> dict[str, Version]:
    """Return what pip would install today on this system and Python, nothing being installed yet."""
    wanted = f"{TREE}[{','.join(LOCKED)}]"
    words = ["install", "--dry-run", "--ignore-installed", "--quiet", "--only-binary", ":all:", "--report", "-", wanted]
    answer = subprocess.run([sys.executable, "-m", "pip", *words], stdout=subprocess.PIPE, check=True)
    found = [item["metadata"] for item in json.loads(answer.stdout)["install"]]
    return {canonicalize_name(one["name"]): Version(one["version"]) for one in found if one["name"] != "winkler"}


def read(name: str) -> dict[str, Version]:
    """Return the versions that a file of this folder states."""
    lines = (HERE / name).read_text(encoding="utf-8").splitlines()
    stated = [line.split("==") for line in lines if line and not line.startswith("#")]
    return {package: Version(number) for package, number in stated}


def write(name: str, versions: dict[str, Version], head: str) -> None:
    """Write versions to a file of this folder, below a comment."""
    lines = [f"# {head}", *(f"{package}=={number}" for package, number in sorted(versions.items()))]
    (HERE / name).write_text("\n".join(lines) + "\n", encoding="utf-8")


def installed(package: str) -> Version | None:
    """Return the version of a package in this environment."""
    try:
        return Version(version(package))
    except PackageNotFoundError:
        return None


def differences(locked: dict[str, Version]) -> list[str]:
    """Return one line for each package that is installed in another version than the locked one."""
    here = {package: installed(package) for package in locked}
    return [
        f"{package} {found} is {'newer' if found > locked[package] else 'older'} than the locked {locked[package]}"
        for package, found in here.items()
        if found is not None and found != locked[package]
    ]


def not_allowed() -> list[str]:
    """Return one line for each direct dependency that is installed in a version that pyproject.toml does not allow."""
    here = [(asked, installed(asked.name)) for asked in direct(LOCKED)]
    return [f"{asked.name} {found} is not {asked}" for asked, found in here if found and found not in asked.specifier]


def compare(name: str, *, equal: bool) -> int:
    """Say how this environment differs from a file; return 1 where it must not."""
    locked = read(name)
    other, wrong = differences(locked), not_allowed()
    held = sum(installed(package) is not None for package in locked)
    print(f"{held - len(other)} of {held} packages have the version of {name}.")
    print("\n".join(other + wrong), end="\n" if other + wrong else "")
    if equal and other:
        print(f"Every package of this environment must have the version of {name}.")
    return int(bool(wrong) or (equal and bool(other)))


def main(words: list[str]) -> int:
    """Do what the words ask for."""
    match words:
        case ["lowest"]:
            write("lowest.txt", lowest(), "written by: python constraints/lock.py lowest")
        case ["newest"]:
            python = ".".join(map(str, sys.version_info[:2]))
            write("newest.txt", newest(), f"{sys.platform}, Python {python}; by: python constraints/lock.py newest")
        case ["compare"]:
            return compare("newest.txt", equal=False)
        case ["compare", "--equal", name]:
            return compare(name, equal=True)
        case _:
            print(__doc__)
            return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
