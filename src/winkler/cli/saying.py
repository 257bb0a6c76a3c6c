r"""What is said to a terminal or a pipe: plain texts, whatever stands in titles, names, units and labels.

Control characters (ESC, BEL and others of C0 and C1) and those that turn the direction of a line around become escapes
such as ``\x1b``: no file of somebody else moves a cursor, renames a window or hides a part of a sentence.  Where the
stream cannot write a character, it is spelled (``um`` for µm), or a question mark.  A stream that is closed, or whose
reader has gone (``winkler run study.toml | head``), is written no more, and the command goes on.
"""

from __future__ import annotations

import codecs
import contextlib
import math
import os
import sys
import unicodedata
from collections.abc import Iterator
from typing import Any

__all__ = ["emptied", "plain_json", "read_or_not", "safe", "say", "say_json", "spell"]

TURNING = frozenset("\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069\u2028\u2029")
"""They turn the direction of a line around, or break it."""
SPELLED = {
    "µ": "u", "μ": "u", "×": "x", "·": "*", "±": "+-", "−": "-", "–": "-", "—": "-", "…": "...", "°": " deg",
    "Ω": "ohm",
    "≤": "<=", "≥": ">=", "≈": "~", "→": "->", "“": '"', "”": '"', "‘": "'", "’": "'", "∞": "infinite",
    "ß": "ss", "ø": "o", "ł": "l",
}  # fmt: skip
HANDLER = "winkler.spelled"


def safe(text: str) -> str:
    r"""Return a text whose control characters are escapes; line breaks and tabs stay.

    Examples
    --------
    >>> safe("Gel\x1b[31m µm\n")
    'Gel\\x1b[31m µm\n'
    """
    if text.isprintable():
        return text
    return "".join(_shown(letter) if _harmful(letter) else letter for letter in text)


def _harmful(letter: str) -> bool:
    return letter in TURNING or (unicodedata.category(letter) in ("Cc", "Cs") and letter not in "\n\t")


def _shown(letter: str) -> str:
    return letter.encode("ascii", "backslashreplace").decode("ascii") if ord(letter) > 127 else f"\\x{ord(letter):02x}"


def say(text: str, *, end: str = "\n", error: bool = False) -> None:
    """Say a text on stdout, or on stderr."""
    if error:
        with contextlib.suppress(OSError):  # the exit code tells
            print(safe(text), end=end, file=sys.stderr)
        return
    with read_or_not():
        print(safe(text), end=end)


def say_json(content: Any) -> None:
    """Say JSON on stdout: in ASCII, and with numbers that JSON does not know in words."""
    import json

    with read_or_not():
        print(json.dumps(plain_json(content), indent=2, allow_nan=False))


def plain_json(content: Any) -> Any:
    """Return what JSON can hold: "infinite" and "-infinite" in words, null where there is no number.

    Examples
    --------
    >>> plain_json({"resistance": [math.inf, 2.0, math.nan]})
    {'resistance': ['infinite', 2.0, None]}
    """
    if isinstance(content, dict):
        return {name: plain_json(part) for name, part in content.items()}
    if isinstance(content, list | tuple):
        return [plain_json(part) for part in content]
    if hasattr(content, "tolist"):  # an array, or a number of one
        return plain_json(content.tolist())
    if not isinstance(content, float) or math.isfinite(content):
        return content
    return None if math.isnan(content) else f"{'-' * (content < 0.0)}infinite"


def spell() -> None:
    """Let stdout and stderr spell what they cannot write, instead of raising; what is closed is written nowhere."""
    sys.stdout, sys.stderr = (stream or open(os.devnull, "w") for stream in (sys.stdout, sys.stderr))  # noqa: SIM115
    codecs.register_error(HANDLER, _spelled)
    for stream in (sys.stdout, sys.stderr):
        encoding = getattr(stream, "encoding", None) or "utf-8"
        if hasattr(stream, "reconfigure") and not codecs.lookup(encoding).name.startswith("utf"):
            stream.reconfigure(errors=HANDLER)


@contextlib.contextmanager
def read_or_not() -> Iterator[None]:
    """Write to stdout, and to nothing else; if the reader goes away, the rest of the block is left out.

    Raises
    ------
    InvalidInput
        If stdout cannot be written for another reason: its disk is full.
    """
    try:
        yield
    except OSError as error:
        if error.filename is not None:
            raise
        _dropped(sys.stdout)
        if not isinstance(error, BrokenPipeError):
            from winkler.errors import InvalidInput

            why = (error.strerror or type(error).__name__).lower()
            raise InvalidInput(
                f"stdout cannot be written ({why}); send it elsewhere. Files that the command has written are complete."
            ) from None


def emptied() -> None:
    """Write out what stdout and stderr still hold, if anybody reads it."""
    with read_or_not():
        sys.stdout.flush()
    with contextlib.suppress(OSError):
        sys.stderr.flush()


def _dropped(stream: Any) -> None:
    """Write nowhere what a stream holds, and what comes later."""
    with contextlib.suppress(OSError):  # a stream of Python alone has no descriptor
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, stream.fileno())
        os.close(nowhere)


def _spelled(error: UnicodeError) -> tuple[str, int]:
    if not isinstance(error, UnicodeEncodeError):
        raise error
    letters = error.object[error.start : error.end]
    return "".join(map(_letters, letters)), error.end


def _letters(letter: str) -> str:
    if letter in SPELLED:
        return SPELLED[letter]
    plain = unicodedata.normalize("NFKD", letter).encode("ascii", "ignore").decode("ascii")
    return plain or "?"
