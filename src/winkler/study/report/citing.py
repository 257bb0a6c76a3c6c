"""The papers behind a problem.

A class names them by BibTeX keys, in its attribute ``references`` or in its line of the catalogue; the entries stand
in ``references.bib`` beside this file.
"""

from __future__ import annotations

import dataclasses
import functools
import re
from pathlib import Path
from typing import Any, NamedTuple

from winkler.study.language.catalogue import kind_of, kinds

ACCENTS = {r"{\"u}": "ü", r"{\"o}": "ö", r"{\"a}": "ä", r"{\ss}": "ß", r"{\`a}": "à", r"{\'e}": "é"}


class Reference(NamedTuple):
    """A paper or book.

    Parameters
    ----------
    key
        BibTeX key.
    text
        One line of text.
    bibtex
        The entry.
    doi
        Digital object identifier; empty if there is none.
    """

    key: str
    text: str
    bibtex: str
    doi: str


@functools.cache
def bibliography() -> dict[str, Reference]:
    """Return every entry of the bibliography by its key."""
    content = (Path(__file__).parent / "references.bib").read_text(encoding="utf-8")
    entries = re.findall(r"^@\w+\{(\w+),\n.*?^\}$", content, flags=re.DOTALL | re.MULTILINE)
    texts = re.findall(r"^@\w+\{\w+,\n.*?^\}$", content, flags=re.DOTALL | re.MULTILINE)
    return {key: _reference(key, text) for key, text in zip(entries, texts, strict=True)}


def _reference(key: str, bibtex: str) -> Reference:
    plain = bibtex
    for accent, letter in ACCENTS.items():
        plain = plain.replace(accent, letter)
    fields = {name: text.replace("{", "").replace("}", "").replace("--", "-") for name, text in _fields(plain)}
    authors = [" ".join(reversed(name.split(", "))) for name in fields["author"].split(" and ")]
    if "journal" in fields:
        # an article that has appeared online only has no volume
        parts = (fields["journal"], fields.get("volume"), f"({fields['year']})", fields.get("pages"))
        where = " ".join(part for part in parts if part)
    else:
        where = f"{fields['publisher']}, {fields['address']} {fields['year']}"
    doi = fields.get("doi", "")
    text = f"{', '.join(authors)}: {fields['title']}. {where}" + (f", doi:{doi}" if doi else "")
    return Reference(key, text, bibtex, doi)


def _fields(bibtex: str) -> list[tuple[str, str]]:
    return re.findall(r"^\s+(\w+)\s+= \{(.*)\},?$", bibtex, flags=re.MULTILINE)


def cite(content: Any) -> tuple[Reference, ...]:
    """Return the papers on which a problem, or a whole study, is based.

    Parameters
    ----------
    content
        Any value; the values inside it are included.

    Returns
    -------
    tuple of Reference
        Those of the problem first, each once.
    """
    return tuple(bibliography()[key] for key in dict.fromkeys(_keys(content)))


def _keys(content: Any) -> list[str]:
    if isinstance(content, tuple):
        return [key for item in content for key in _keys(item)]
    if not dataclasses.is_dataclass(content):
        return []
    cls = type(content)
    keys = list(getattr(cls, "references", ()))
    keys += kinds()[kind_of(cls)].cites if kind_of(cls) else ()
    for field in dataclasses.fields(content):
        keys += _keys(getattr(content, field.name))
    return keys
