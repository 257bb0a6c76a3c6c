"""A study as part of an address, and back: compressed text in letters that an address may hold."""

from __future__ import annotations

import base64
import zlib

from winkler.values.errors import InvalidInput

LONGEST_LINK = 16_000
"""Most letters of a study in an address: longer ones are cut by mail programs and browsers."""
MOST_TEXT = 2_000_000
"""Most bytes of a study that is read from an address."""
CUT = "The address holds no whole study: it was cut or changed. Ask for the study file, or copy the whole address."


def code_of(text: str) -> str:
    """Return the text of a study as letters, digits, ``-`` and ``_``.

    Parameters
    ----------
    text
        A study file.

    Examples
    --------
    >>> study_of(code_of("title = 'a ball'"))
    "title = 'a ball'"
    """
    return base64.urlsafe_b64encode(zlib.compress(text.encode(), 9)).decode().rstrip("=")


def study_of(code: str) -> str:
    """Return the text of a study from an address.

    Parameters
    ----------
    code
        As `code_of` returns it.

    Raises
    ------
    InvalidInput
        If it is cut, changed, or its text is too long.
    """
    try:
        packed = base64.b64decode(code + "=" * (-len(code) % 4), altchars=b"-_", validate=True)
        reader = zlib.decompressobj()
        text = reader.decompress(packed, MOST_TEXT + 1).decode()
    except (zlib.error, ValueError):  # of base64 and UTF-8, too
        raise InvalidInput(CUT) from None
    if len(text.encode()) > MOST_TEXT:
        raise InvalidInput("The study in this address is too long; ask for the study file.")
    if not reader.eof or reader.unused_data:
        raise InvalidInput(CUT)
    return text
