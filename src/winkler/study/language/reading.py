"""Studies read from TOML, and written back to it."""

from __future__ import annotations

import re
import tomllib
import unicodedata
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from winkler.io.foreign import path_text
from winkler.io.text_file import content_of, path_of
from winkler.study.language import axes
from winkler.study.language.build import assembled
from winkler.study.language.catalogue import in_present_kinds
from winkler.study.language.study import Fields, Output, Study
from winkler.values.errors import InvalidInput, WinklerError
from winkler.values.limits import STUDY_BYTES, STUDY_MARKS

MOST_LEVELS = 50
"""Levels of tables and lists within each other."""
DEEP_KEY = re.compile(
    rf"(?<![\w.-])(?:(?:[\w-]++|\"[^\"\n]*+\"|'[^'\n]*+')[ \t]*+\.[ \t]*+){{{MOST_LEVELS}}}", re.ASCII
)
"""A key of more parts; the time to parse TOML grows with the square of their number."""
SEPARATORS = (",", "=", "\n", "[", "{", "\\")
SPACES_PER_ENTRY = 20
"""Spaces that cost the parsing time of one entry."""


def read_study(path: str | Path, *, settings: Sequence[str] = ()) -> Study:
    """Read a study file.

    Parameters
    ----------
    path
        A TOML file; files that it names lie relative to it.
    settings : sequence of str
        What replaces its own contents, as ``problem.load.force=20 N``.

    Returns
    -------
    Study

    Raises
    ------
    InvalidInput
        With one sentence for every mistake: file, key, its value, what is allowed.
    """
    path = path_of(path)
    return parse_study(read_text(path, settings), file=path.name, folder=path.parent)


def read_text(path: Path, settings: Sequence[str] = ()) -> str:
    """Return the text of a study file, in which `settings` have replaced contents; as it is if there are none.

    Raises
    ------
    InvalidInput
        If it cannot be read, or a setting has no place in it.
    """
    text = _text_of(path)
    if not settings:
        return text
    import tomli_w

    raw = parsed(text, path.name)
    for setting in settings:
        _set(raw, setting)
    return tomli_w.dumps(raw)


def _set(raw: dict[str, Any], setting: str) -> None:
    """Put the content of a setting into the tables of a study."""
    key, sign, content = setting.partition("=")
    try:
        found: Any = tomllib.loads(f"{key} = 0")
    except (tomllib.TOMLDecodeError, RecursionError):
        found = {}
    if not sign or not found:
        raise InvalidInput(f"set: '{setting}' is no setting; give KEY=CONTENT, such as problem.load.force='20 N'.")
    parts: list[str] = []
    while isinstance(found, dict):
        [(part, found)] = found.items()
        parts.append(part)
    owner: Any = raw
    for number, part in enumerate(parts[:-1]):
        owner = owner.setdefault(part, {}) if isinstance(owner, dict) else _entry(owner, part, key)
        if not isinstance(owner, dict | list):
            raise InvalidInput(f"set: '{key}' lies below {'.'.join(parts[: number + 1])}, which is no table or list.")
    if isinstance(owner, list):
        _entry(owner, parts[-1], key)
        owner[int(parts[-1])] = _content(content)
    else:
        owner[parts[-1]] = _content(content)


def _entry(listed: list[Any], part: str, key: str) -> Any:
    """Return the entry of a list at a place."""
    if not part.isdecimal() or int(part) >= len(listed):
        raise InvalidInput(f"set: '{key}': '{part}' is no place in a list of {len(listed)}; the first one is 0.")
    return listed[int(part)]


def _content(text: str) -> Any:
    """Return a content as TOML reads it, else the text itself: a quantity needs no second pair of quotes."""
    try:
        return tomllib.loads(f"content = {text}")["content"]
    except (tomllib.TOMLDecodeError, RecursionError):
        return text.strip()


def _text_of(path: Path) -> str:
    try:
        if path.is_dir():
            raise InvalidInput(f"{path_text(path)} is a folder; give a study file in it.")
        if not path.exists():
            near = sorted(item.name for item in path.parent.glob("*.toml"))[:5] if path.parent.is_dir() else []
            others = f"; there are {', '.join(near)}" if near else ""
            raise InvalidInput(
                f"{path_text(path)}: there is no such file{others}; `winkler new indentation` writes one."
            ) from None
        if not path.is_file():
            raise InvalidInput(f"{path_text(path)}: this is not a file with contents; give a study file.")
        return content_of(path, STUDY_BYTES).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise InvalidInput(f"{path}: byte {error.start} is not UTF-8; save the study as UTF-8 text.") from None
    except OSError as error:
        raise InvalidInput(
            f"{path_text(path)}: cannot be read ({error.strerror or error}); give a readable study file."
        ) from None


def parse_study(text: str, *, file: str = "", folder: Path = Path()) -> Study:
    """Return the study that TOML `text` describes.

    Parameters
    ----------
    text
        The content of a study file.
    file
        Its name, for messages and as the title where none is given.
    folder
        Where the files that it names lie.

    Raises
    ------
    InvalidInput
        With one sentence for every mistake.
    """
    raw = parsed(text, file)
    if "fit" in raw:
        command = f"winkler fit {_typed(folder / file)}" if file else "winkler fit"
        raise InvalidInput(f"{_at(file)}the study has a section [fit]; `{command}` fits it.")
    if "function" in raw:
        command = f"winkler validate {_typed(folder / file)}" if file else "winkler validate"
        raise InvalidInput(
            f"{_at(file)}the study has a section [function]: it is a case of the ledger; `{command}` runs it."
        )
    return _study(raw, file, folder)


def _typed(path: Path) -> str:
    """Return a path as it is typed after a command."""
    return path_text(path) if " " not in str(path) else f'"{path_text(path)}"'


def parsed(text: str, file: str) -> dict[str, Any]:
    """Return the tables of a study's TOML `text`; `file` is its name, for messages.

    Raises
    ------
    InvalidInput
        If it is not TOML, or empty.
    """
    text = text.removeprefix("\ufeff")  # with which some editors begin a file of UTF-8
    marks = sum(map(text.count, SEPARATORS)) + text.count(" ") // SPACES_PER_ENTRY
    if marks > STUDY_MARKS:
        raise InvalidInput(
            f"{_at(file)}the study has more than {STUDY_MARKS} entries; put long lists into a table, and name its file."
        )
    if DEEP_KEY.search(text):
        raise InvalidInput(f"{_at(file)}a key has more than {MOST_LEVELS} parts; a study needs about ten levels.")
    try:
        raw = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise InvalidInput(f"{_at(file)}this is not TOML: {_told(str(error))}.") from None
    except ValueError:  # Python turns at most 4300 digits into a whole number
        raise InvalidInput(f"{_at(file)}a number has thousands of digits; write it as 1e9.") from None
    except RecursionError:
        raise InvalidInput(f"{_at(file)}tables or lists are nested too deep; a study needs about ten levels.") from None
    if _too_deep(raw):
        raise InvalidInput(f"{_at(file)}tables or lists are nested more than {MOST_LEVELS} deep; write it more simply.")
    if controlled := next(_controlled(raw), ""):
        raise InvalidInput(
            f"{_at(file)}the text {controlled!a:.60} holds a control character; leave it out, only line breaks and "
            "tabs are allowed."
        )
    if not raw:
        raise InvalidInput(
            f"{_at(file)}the study is empty; it needs at least [problem], see `winkler new indentation`."
        )
    present: dict[str, Any] = in_present_kinds(raw)
    return present


def _too_deep(content: Any) -> bool:
    """Return whether a table or list is nested deeper than a study needs."""
    level = [content]
    for _ in range(MOST_LEVELS):
        level = [
            inner
            for outer in level
            for inner in (outer.values() if isinstance(outer, dict) else outer)
            if isinstance(inner, dict | list)
        ]
    return bool(level)


def _controlled(content: Any) -> Iterator[str]:
    """Yield texts with control characters: no table, page or archive needs them, and some cannot hold them."""
    if isinstance(content, str):
        if not content.isprintable() and any(
            unicodedata.category(one) == "Cc" and one not in "\t\n\r" for one in content
        ):
            yield content
    elif isinstance(content, dict):
        for name, inner in content.items():
            yield from _controlled(name)
            yield from _controlled(inner)
    elif isinstance(content, list):
        for inner in content:
            yield from _controlled(inner)


def _at(file: str) -> str:
    return f"{file}: " if file else ""


def _told(sentence: str) -> str:
    """Return what the reader of TOML found, in words for those who do not know it."""
    sentence = sentence.replace("Cannot overwrite a value", "the key is given twice")
    sentence = sentence.replace(r"Illegal character '\n'", "a quote is not closed")
    return sentence[:1].lower() + sentence[1:].rstrip(".")


def checked(raw: dict[str, Any], file: str, folder: Path) -> tuple[Any, Any]:
    """Return the checked input model of the tables of a study, and its problem.

    Raises
    ------
    InvalidInput
        With one sentence for every mistake.
    """
    from pydantic import ValidationError

    from winkler.study.language import grammar, mistakes

    try:
        form: Any = grammar.study_form().model_validate(raw)
    except ValidationError as error:
        raise mistakes.worded(file, mistakes.sentences(error, raw)) from None
    return form, assembled(form.problem, folder=folder, file=file, key="problem")


def _study(raw: dict[str, Any], file: str, folder: Path) -> Study:
    form, problem = checked(raw, file, folder)
    try:
        design = axes.design(form.sweep.pop("design", {"kind": "crossed"}))
        expect = []
        for place, item in enumerate(form.expect):
            from winkler.study.language.compared.expectations import expectation

            try:
                expect.append(expectation(dict(item), problem))
            except InvalidInput as error:
                sentence = str(error)
                rest = sentence.removeprefix("expect") if sentence.startswith("expect") else f".{sentence}"
                raise InvalidInput(f"expect[{place}]{rest}") from None
        return Study(
            title=form.title or Path(file).stem,
            problem=problem,
            sweep=tuple(
                axes.line(key, values, problem, design, file=file, folder=folder) for key, values in form.sweep.items()
            ),
            design=design,
            fields=Fields(**stated(form.fields)),
            output=Output(**stated(form.output)),
            expect=tuple(expect),
            source=form.source,
            grade=form.grade,
        )
    except WinklerError as error:
        if file and str(error).startswith(f"{file}: "):
            raise
        raise error.reworded(lambda sentence: f"{_at(file)}{sentence}") from None


def stated(form: Any) -> dict[str, Any]:
    """Return the keys that an input model of a section states; none if the section is missing."""
    from winkler.study.language.schema import MISSING

    return {} if form is MISSING else {name: content for name, content in form if content is not MISSING}
