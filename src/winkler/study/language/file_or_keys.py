"""Tables of a study that a file may replace: a key whose content the file gives is refused beside it."""

from __future__ import annotations

from typing import Any

from winkler.study.language.quantities import WHERE, wrong

__all__ = ["either_file_or"]


def either_file_or(
    raw: Any, *, required: list[str], others: list[str], options: tuple[str, ...], alone: tuple[str, ...]
) -> Any:
    """Refuse a table with a file and with keys that the file replaces, or with neither.

    Parameters
    ----------
    raw
        The table.
    required, others
        Keys of the class that must be given, and those that may.
    options
        Options of the reader of the file.
    alone
        Those of them that are no keys of the class.
    """
    if not isinstance(raw, dict):
        return raw
    given = [key for key in required if key in raw and not ("file" in raw and key in options)]
    listed = ", ".join(required[:-1]) + f" and {required[-1]}"
    if "file" in raw:
        if given:
            wrong(f"{WHERE} has both file and {given[0]}; give the file, or {listed}.")
        for key in others:
            if key in raw and key not in options:
                wrong(f"{WHERE} has both file and {key}, which the file states; leave one of them out.")
        return raw
    for key in alone:
        if key in raw:
            wrong(f"{WHERE}.{key} states how a file is read, but there is no file; leave it out.")
    if len(given) < len(required):
        missing = next(key for key in required if key not in raw)
        wrong(f"{WHERE} has no '{missing}'; give {listed}, or a file.")
    return raw
