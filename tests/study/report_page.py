"""What a page of a report must have, whatever it is about."""

from __future__ import annotations

import html.parser
import re
from collections.abc import Iterator
from typing import Any

from winkler.study.report.citing import cite

VOID = {"meta", "br", "img", "link", "input", "hr"}
CHAPTERS = (
    *("The problem", "At a glance", "Results", "How far this can be trusted", "The method in pictures", "Inputs"),
    *("The formulas", "Papers", "Version and origin of the results", "The same results elsewhere"),
)
NUMBERS = re.compile(r"\d+(?:\.\d+)?(?:e[+-]\d+)?(?: (?:m|N|Pa|K|s|per cent)\b)?")
"""In a statement; a report writes them with prefixes, and per cent as a sign."""


class Page(html.parser.HTMLParser):
    """Reads a page; complains about tags that do not match."""

    def __init__(self, text):
        super().__init__()
        self.open, self.tags, self.ids, self.words, self.links = [], [], [], [], []
        self.feed(text)
        self.close()
        assert self.open == [], f"never closed: {self.open}"

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))
        self.ids += [content for name, content in attrs if name == "id"]
        self.links += [content for name, content in attrs if name in ("src", "href", "xlink:href", "srcset", "data")]
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.handle_starttag(tag, attrs)
        if tag not in VOID:
            self.open.pop()

    def handle_endtag(self, tag):
        assert self.open[-1:] == [tag], f"</{tag}> closes {self.open[-3:]}"
        self.open.pop()

    def handle_data(self, data):
        if not {"style", "svg"} & set(self.open):
            self.words.append(data)

    @property
    def text(self):
        return re.sub(r"\s+", " ", " ".join(self.words))


def page_mistakes(outcome: Any, page: str) -> Iterator[str]:
    """Yield what is wrong with the page of an outcome, a line for each mistake."""
    parsed = Page(page)
    text = parsed.text
    if not page.startswith("<!DOCTYPE html>"):
        yield "it does not begin as a page"
    # it needs nothing else
    yield from sorted({tag for tag, _ in parsed.tags} & {"script", "link", "iframe", "object", "img", "embed"})
    yield from (
        link for link in parsed.links if not link.startswith(("#", "data:image/png;base64,", "https://doi.org/"))
    )
    yield from re.findall(r"@import|url\((?!#).*", page)
    yield from (str(given) for tag, given in parsed.tags if tag != "a" and "https" in given.get("href", ""))
    # what is pointed to is there, once
    named = [one for one in parsed.ids if not re.search(r"-image[0-9a-f]{10}$", one)]  # by content: equal ones are one
    yield from sorted({f"twice: {one}" for one in named if named.count(one) > 1})
    used = set(re.findall(r'href="#([^"]+)"', page)) | set(re.findall(r"url\(#([^)]+)\)", page))
    yield from (f"not there: {one}" for one in sorted(used - set(parsed.ids)))
    # every chapter, in its place
    chapters = list(CHAPTERS)
    if "The method in pictures" not in text:
        if "Results as curves" not in text and page.count("<figure") > 1:  # one stands at a glance
            yield f"{page.count('<figure')} figures without their chapter"
        chapters.remove("The method in pictures")
    places = [text.find(chapter) for chapter in chapters]
    if min(places) <= 0 or places != sorted(places):
        yield f"chapters stand at {dict(zip(chapters, places, strict=True))}"
    # what is known of the answers, and from where
    if not outcome.validity:
        yield "nothing is said of its validity"
    for note in outcome.validity:
        if not all(words in text for words in NUMBERS.split(note.statement)) or note.source not in text:
            yield f"not stated: {note.statement} ({note.source})"
        if f'class="standing {note.standing.value}"' not in page:
            yield f"no standing: {note.standing.value}"
    for paper in cite(outcome.study):
        if paper.text.split(", doi:")[0] not in text or paper.doi not in text:
            yield f"not cited: {paper.text}"
    made = outcome.provenance
    yield from (f"not stated: {one}" for one in (made.hash, made.version, made.created) if one not in text)
