"""Save and restore the state of many contacts, so that a stopped discrete element run can be continued."""

from __future__ import annotations

import dataclasses
import os
from pathlib import Path

import numpy as np

from winkler.io.array_file import read_state, write_state
from winkler.io.foreign import reader
from winkler.problems.particles.contacts import Contacts
from winkler.values.errors import InvalidInput

FORMAT = "winkler contacts 1"
FIELD_NAMES = tuple(field.name for field in dataclasses.fields(Contacts))


def write_contacts(contacts: Contacts, path: str | os.PathLike[str]) -> Path:
    """Save contacts with their load history. An existing file is replaced only after the new one is complete.

    Parameters
    ----------
    contacts : Contacts
        The contacts, saved with all digits.
    path : str or path
        Path of the file, in NumPy's format ``.npz``.

    Returns
    -------
    Path

    Raises
    ------
    InvalidInput
        If there is no such folder, or its file cannot be written.
    """
    return write_state(path, FORMAT, {word: getattr(contacts, word) for word in FIELD_NAMES})


@reader("contacts")
def read_contacts(path: str | os.PathLike[str]) -> Contacts:
    """Return contacts as they were saved.

    Parameters
    ----------
    path : str or path
        A file that `write_contacts` wrote.

    Returns
    -------
    Contacts

    Raises
    ------
    InvalidInput
        If the file is missing, broken, or of another kind.
    """
    arrays = read_state(path, FORMAT, FIELD_NAMES, needed=FIELD_NAMES, what="contacts")
    spoilt = [word for word, content in arrays.items() if content.dtype.kind != "f" or not np.isfinite(content).all()]
    if spoilt:
        raise InvalidInput(
            f"{path}: no contacts can be read from it ({spoilt[0]} holds what is no finite number); give a file of "
            "write_contacts."
        )
    return Contacts(**arrays)
