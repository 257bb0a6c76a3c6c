r"""Output to a terminal or a pipe: plain texts, whatever titles, names, units and labels contain.

Control characters (ESC, BEL and others of C0 and C1) and those that change the direction of a line become escapes such
as ``\x1b``, so that no foreign file moves a cursor, renames a window or hides a part of a sentence.  A character that
the stream cannot encode is spelled (``um`` for µm), or replaced by a question mark.  Nothing more is written to a
stream that is closed or whose reader has ended (``winkler run study.toml | head``), and the command goes on.
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

DIRECTION_MARKS = frozenset("\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069\u2028\u2029")
"""Characters that change the direction of a line, or break it."""
SPELLINGS = {
    "µ": "u", "μ": "u", "×": "x", "·": "*", "±": "+-", "−": "-", "–": "-", "—": "-", "…": "...", "°": " deg",
    "Ω": "ohm",
    "≤": "<=", "≥": ">=", "≈": "~", "→": "->", "“": '"', "”": '"', "‘": "'", "’": "'", "∞": "infinite",
    "ß": "ss", "ø": "o", "ł": "l",
}  # fmt: skip
ERROR_HANDLER = "winkler.spelled"


def safe(text: str) -> str:
    r"""Return a text whose control characters are escapes; line breaks and tabs stay.

    Examples
    --------
    >>> safe("Gel\x1b[31m µm\n")
    'Gel\\x1b[31m µm\n'
    """
    if text.isprintable():
        return text
    return "".join(_escaped(letter) if _harmful(letter) else letter for letter in text)


def _harmful(letter: str) -> bool:
    return letter in DIRECTION_MARKS or (unicodedata.category(letter) in ("Cc", "Cs") and letter not in "\n\t")


def _escaped(letter: str) -> str:
    return letter.encode("ascii", "backslashreplace").decode("ascii") if ord(letter) > 127 else f"\\x{ord(letter):02x}"


def write_line(text: str, *, end: str = "\n", error: bool = False) -> None:
    """Write a line of text to stdout, or to stderr."""
    if error:
        with contextlib.suppress(OSError):  # the exit code states the error
            print(safe(text), end=end, file=sys.stderr)
        return
    with until_closed():
        print(safe(text), end=end)


JSON_SCHEMA = 1
"""Number of the form of all that `--json` writes; it grows when an entry goes or changes its meaning."""


def write_json(content: dict[str, Any]) -> None:
    """Write JSON to stdout: in ASCII, infinite numbers as words, and the number of its form first."""
    import json

    with until_closed():
        print(json.dumps(plain_json({"schema": JSON_SCHEMA, **content}), indent=2, allow_nan=False))


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


def spell_unencodable() -> None:
    """Let stdout and stderr spell what they cannot encode; replace closed ones by the null device."""
    sys.stdout, sys.stderr = (stream or open(os.devnull, "w") for stream in (sys.stdout, sys.stderr))  # noqa: SIM115
    codecs.register_error(ERROR_HANDLER, _spelled)
    for stream in (sys.stdout, sys.stderr):
        encoding = getattr(stream, "encoding", None) or "utf-8"
        if hasattr(stream, "reconfigure") and not codecs.lookup(encoding).name.startswith("utf"):
            stream.reconfigure(errors=ERROR_HANDLER)


@contextlib.contextmanager
def until_closed() -> Iterator[None]:
    """Guard a block that writes to stdout alone; if the reader has ended, the rest of the block is skipped.

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
        _discarded(sys.stdout)
        if not isinstance(error, BrokenPipeError):
            from winkler.values.errors import InvalidInput

            why = (error.strerror or type(error).__name__).lower()
            raise InvalidInput(
                f"stdout cannot be written ({why}); send it elsewhere. Files that the command has written are complete."
            ) from None


def flush_streams() -> None:
    """Flush stdout and stderr, if they are still read."""
    with until_closed():
        sys.stdout.flush()
    with contextlib.suppress(OSError):
        sys.stderr.flush()


def _discarded(stream: Any) -> None:
    """Discard what a stream holds, and all later output."""
    with contextlib.suppress(OSError):  # a stream of Python alone has no descriptor
        null_device = os.open(os.devnull, os.O_WRONLY)
        os.dup2(null_device, stream.fileno())
        os.close(null_device)


def _spelled(error: UnicodeError) -> tuple[str, int]:
    if not isinstance(error, UnicodeEncodeError):
        raise error
    letters = error.object[error.start : error.end]
    return "".join(map(_spelling, letters)), error.end


def _spelling(letter: str) -> str:
    if letter in SPELLINGS:
        return SPELLINGS[letter]
    plain = unicodedata.normalize("NFKD", letter).encode("ascii", "ignore").decode("ascii")
    return plain or "?"
