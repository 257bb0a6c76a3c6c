"""Containers as contact.engineering publishes them: an archive of measurements with meta.yml or index.json."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from winkler.io.archive_file import archive, is_archive
from winkler.values.errors import InvalidInput, suggest

LISTS = {"meta.yml", "index.json"}
"""Files that name the measurements."""
REMEDY = "download the container anew"


def is_container(path: Path) -> bool:
    """Return whether an archive holds a list of measurements.

    Raises
    ------
    InvalidInput
        If it begins as an archive and is none.
    """
    if not is_archive(path) or path.suffix.lower() != ".zip":
        return False
    with archive(path, path, remedy=REMEDY) as pack:
        return bool(LISTS & set(pack.namelist()))


def measurement_names(path: Path) -> list[str]:
    """Return the names of all measurements of a container, in their order; of several surfaces, as surface/measurement.

    Raises
    ------
    Exception
        Whatever SurfaceTopography raises at damaged lists.
    """
    return [name for name, _, _ in _measurements(path)]


def contained_surface(path: Path, name: str, directions: int) -> Any:
    """Return one measurement of a container as SurfaceTopography reads it, prepared as its authors stated.

    Parameters
    ----------
    path : path
        The container.
    name : str
        Of the measurement; the first one of so many directions if empty.
    directions : int
        2 for height maps, 1 for line scans.

    Raises
    ------
    InvalidInput
        If there is no such measurement.
    """
    found = _measurements(path)
    fitting = [one for one in found if one[2] in (0, directions)]
    what = "height map" if directions == 2 else "line scan"
    names = [one[0] for one in fitting]
    if name:
        chosen = [one for one in fitting if name in (one[0], one[0].rpartition("/")[2])]
        if not chosen:
            raise InvalidInput(
                f"{path}: the container has no {what} {name!r}{suggest(name, names)}; give one of {', '.join(names)}."
            )
        fitting = chosen[:1]
    for _, read, _ in fitting:
        surface = read()
        if surface.dim == directions:
            return surface
    raise InvalidInput(f"{path}: the container holds no {what}, but {', '.join(one[0] for one in found) or 'nothing'}.")


def _measurements(path: Path) -> list[tuple[str, Any, int]]:
    """Return name, function that reads it, and directions (zero if not stated) of each measurement."""
    from SurfaceTopography.Container.IO.CE import CEReader

    reader = CEReader(str(path))
    several = reader.nb_containers > 1
    rows = []
    for index in range(reader.nb_containers):
        surface = reader.container(index)
        stated = surface.info.get("topographies") or []
        for place, member in enumerate(reader.members(index)):
            size = stated[place].get("size") or ()
            name = f"{surface.info.get('name', index)}/{member.name}" if several else str(member.name)
            rows.append((name, lambda surface=surface, place=place: surface[place], len(size)))
    return rows
