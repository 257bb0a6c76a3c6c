"""Which kinds a word or a question means: a ranking over their names and the words of their records.

Words that are alike, tasks that are no kinds, and what is not covered are those of ``words.toml``.
"""

from __future__ import annotations

import ast
import difflib
import functools
import math
import re
import tomllib
import unicodedata
from collections import Counter, defaultdict
from importlib import resources
from typing import Any, NamedTuple

from winkler.materials.named import material_names, other_names
from winkler.study.chapters.contents import answers
from winkler.study.chapters.kind import Words
from winkler.study.language.catalogue import kinds, slot_of
from winkler.study.language.explain import summary

LANGUAGES = ("en", "de", "fr")
SATURATION, LENGTH = 1.2, 0.1
"""Of BM25: how soon one more occurrence counts no more, and how far long entries are held back."""

NAME, KEY, SAID, MATERIAL = 3.0, 5.0, 2.0, 1.0
"""Weight of a word in the name of a kind, under "key" of its words, in the rest of them, in the name of a material."""

ALIKE, PREFIX, PART, TYPO = 0.7, 0.7, 0.6, 0.5
"""Weight of a word that means the same, begins another, is a part of it, or is spelled like it."""

SHARE = 0.6
"""Least share of a word that its beginning has, if it is to stand for it."""

SAME = 0.8
"""Least similarity, by difflib, of a mistyped word to the known one, which begins with the same letter."""

SHORTEST, SHORTEST_PART, LONGEST = 5, 3, 40
"""Letters of the shortest word that may begin another, be a part of it, or be mistyped; of the shortest and of the
longest part of a compound."""

LINKS = ("", "s", "n", "en", "es", "er", "e")
"""Letters between the parts of a German compound."""

COMMON, SELDOM = 1.1, 0.6
"""Factor of what is meant most often, and of kinds that are mere parts of a study, such as solids and steps."""

ASKED = ("problem", "medium", "profile")
"""Slots whose kinds people ask for."""

DECIDES = 1.3
"""Factor of what is not covered, where a typed word belongs to such a neighbour alone."""

PROMISED = 0.45
"""Share of the best score down to which others are shown."""

ENDINGS = (
    "ungen", "ations", "ation", "ements", "ement", "ings", "ing", "ung", "ies", "ed", "es", "en", "er", "s", "e", "n",
    "als", "al", "t", "y",
)  # fmt: skip
"""What is cut off a word, the first that fits, if four letters are left."""


class Hit(NamedTuple):
    """What a search found.

    Parameters
    ----------
    name
        A kind, a material, a task that is no kind (fit, nanoindentation, materials, export, sweep, map), or a public
        name of Python.
    group
        The slot of the kind; ``task``, ``material`` or ``python`` otherwise.
    command
        What shows it.
    """

    name: str
    group: str
    command: str

    @property
    def meaning(self) -> str:
        """What it is, in one sentence."""
        if self.group == "material":
            return "A material of the table."
        if self.group == "python":
            return _described(self.name)
        task = _table()["task"].get(self.name) if self.group == "task" else None
        return str(task["meaning"]) if task else summary(kinds()[self.name].cls)


class Beyond(NamedTuple):
    """A neighbour that winkler does not cover.

    Parameters
    ----------
    what
        Its name.
    nearest
        Names of the hits that come nearest.
    """

    what: str
    nearest: tuple[str, ...]


class SearchResult(NamedTuple):
    """The outcome of a search.

    Parameters
    ----------
    hits
        The best first.
    beyond
        What was asked for and is not covered, or None; the hits are then what the other words mean, and the nearest.
    unknown
        Words that no covered entry has.
    """

    hits: tuple[Hit, ...]
    beyond: Beyond | None
    unknown: tuple[str, ...] = ()

    @property
    def remark(self) -> str:
        """What is not covered, or may not be, in one sentence; empty where all words are known."""
        if self.beyond:
            return f"winkler does not cover {self.beyond.what}."
        if self.unknown:
            return f"winkler does not know {' or '.join(map(repr, self.unknown))} and may not cover the question."
        return ""

    def table(self) -> dict[str, Any]:
        """Return it as data for JSON."""
        return {
            "not_covered": self.beyond.what if self.beyond else None,
            "unknown": self.unknown,
            "found": [{**hit._asdict(), "meaning": hit.meaning} for hit in self.hits],
        }


def _parsed(module: str) -> list[ast.stmt]:
    """Return the statements of a module, which is not loaded for it; none if its text is not there."""
    folders = module.split(".")[1:]
    file = resources.files("winkler").joinpath(*folders[:-1], f"{folders[-1]}.py")
    return ast.parse(file.read_text(encoding="utf-8")).body if file.is_file() else []


@functools.cache
def public_names() -> dict[str, str]:
    """Return public name -> its module."""
    imports = [line for line in _parsed("winkler.public") if isinstance(line, ast.ImportFrom)]
    return {imported.name: line.module or "" for line in imports for imported in line.names}


def _described(name: str) -> str:
    """Return the first sentence of the docstring of a public name."""
    for line in _parsed(public_names()[name]):
        if isinstance(line, ast.ClassDef | ast.FunctionDef) and line.name == name:
            return (ast.get_docstring(line) or "").split("\n\n")[0].replace("\n", " ")
    return "A public name of Python."


@functools.cache
def _table() -> Any:
    text = resources.files(__package__).joinpath("words.toml").read_text(encoding="utf-8")
    return tomllib.loads(text)


@functools.cache
def _list(name: str) -> frozenset[str]:
    return frozenset(_table()[name].split())


def _folded(text: str) -> str:
    """Return small letters without accents; an umlaut is as good as two letters, S-N as SN."""
    plain = unicodedata.normalize("NFKD", text.lower().replace("ß", "ss").replace("œ", "oe").replace("’", "'"))
    plain = "".join(letter for letter in plain if not unicodedata.combining(letter))
    plain = re.sub(r"\b([a-z])-(?=[a-z]\b)", r"\1", plain)
    return re.sub(r"([aou])e(?=[a-z])", r"\1", plain)


def _stem(word: str) -> str:
    if word in _list("whole"):
        return word
    for ending in ENDINGS:
        if word.endswith(ending) and len(word) - len(ending) >= (5 if ending == "er" else 4):
            return word.removesuffix(ending)
    return word


def _tokens(text: str) -> list[str]:
    """Return the words of a text and their stems, each once; a word in capitals begins a word of a public name."""
    found = re.findall(r"[a-z]+[0-9]*|[0-9]+", _folded(re.sub(r"(?<=[a-z])(?=[A-Z])", " ", text)))
    told = [word for word in found if len(word) > 1 and word not in _list("idle")]
    return list(dict.fromkeys(map(_stem, told)))


@functools.cache
def _alike() -> dict[str, tuple[str, ...]]:
    """Return folded word or stem -> stems of the words that mean the same in the entries."""
    found: defaultdict[str, dict[str, None]] = defaultdict(dict)
    for line in _table()["alike"]["words"].strip().splitlines():
        head, _, others = line.partition(":")
        for other in _tokens(others):
            found[other].update(dict.fromkeys(_tokens(head)))
    return {word: tuple(heads) for word, heads in found.items()}


@functools.cache
def _parts(token: str) -> tuple[str, ...]:
    """Return the known words of which a compound consists, the longest first ones, or nothing."""
    known = _index().scores.keys() | _alike().keys()
    for end in range(min(len(token), LONGEST), SHORTEST_PART - 1, -1):
        part, rest = token[:end], token[end:]
        if part not in known and _stem(part) not in known:
            continue
        if not rest:
            return (part,)
        for link in LINKS:
            if rest.startswith(link) and (others := _parts(rest.removeprefix(link))):
                return (part, *others)
    return ()


def _told(name: str) -> Words:
    """Return the words of a kind or task."""
    if name in kinds():
        return kinds()[name].words
    task = _table()["task"].get(name, {})
    return Words(*(task.get(part, "") for part in Words._fields))


def words(name: str) -> str:
    """Return all that people call a kind or task, in three languages; empty where nothing is known."""
    told = _told(name)
    return " ".join(filter(None, (told.en, told.de, told.fr)))


class _Index:
    """How much each word tells of each entry."""

    def __init__(self) -> None:
        table = _table()
        self.hits: dict[str, Hit] = {}
        self.beyond: dict[str, Beyond] = {}
        self.titles: dict[str, list[str]] = {}
        counts: dict[str, Counter[str]] = {}

        def count(name: str, *texts: tuple[str, float]) -> None:
            counts[name], self.titles[name] = Counter(), _tokens(texts[0][0])
            for text, weight in texts:
                counts[name].update(dict.fromkeys(_tokens(text), weight))

        for kind, line in kinds().items():  # their classes are not loaded for this: that takes seconds
            self.hits[kind] = Hit(kind, slot_of(kind), f"winkler show {kind}")
            asked = answers()[kind].question if kind in answers() else ""
            said = f"{words(kind)} {asked}"
            count(kind, (kind, NAME), (line.path.split(":")[1], NAME), (said, SAID), (_told(kind).key, KEY))
        for name, entry in table["task"].items():
            self.hits[name] = Hit(name, "task", entry["command"])
            count(name, (name, NAME), (words(name), SAID), (_told(name).key, KEY))
        for name in material_names():
            self.hits[name] = Hit(name, "material", f"winkler show {name}")
            count(name, (name, MATERIAL), (" ".join(other_names(name)), MATERIAL))
        for name, entry in table["beyond"].items():
            self.beyond[name] = Beyond(entry["what"], tuple(entry["nearest"]))
            said = " ".join(entry[each] for each in LANGUAGES)
            count(f"beyond.{name}", (entry["what"], SAID), (said, SAID), (entry.get("key", ""), KEY))
        self.favour = {kind: SELDOM for kind in kinds() if slot_of(kind) not in ASKED}
        self.favour |= dict.fromkeys(table["common"].split(), COMMON)
        mean = sum(sum(told.values()) for told in counts.values()) / len(counts)
        holders = Counter(token for told in counts.values() for token in told)
        self.scores: dict[str, dict[str, float]] = {token: {} for token in holders}
        for name, held_words in counts.items():
            held = SATURATION * (1.0 - LENGTH + LENGTH * sum(held_words.values()) / mean)
            for token, weight in held_words.items():
                rare = math.log(1.0 + (len(counts) - holders[token] + 0.5) / (holders[token] + 0.5))
                self.scores[token][name] = rare * weight * (SATURATION + 1.0) / (weight + held)

    def alike(self, token: str) -> dict[str, float]:
        """Return known words that a typed one may mean, and how surely."""
        same = [head for head in _alike().get(token, ()) if head in self.scores]
        found = dict.fromkeys(same, ALIKE) | ({token: 1.0} if token in self.scores else {})
        if found:
            return found
        if len(token) < SHORTEST:
            return {}
        begun = [known for known in self.scores if known[0] == token[0]]
        found = dict.fromkeys(difflib.get_close_matches(token, begun, n=3, cutoff=SAME), TYPO)
        for known in self.scores:
            short, long = sorted((token, known), key=len)
            if len(short) >= SHORTEST and len(short) >= SHARE * len(long) and long.startswith(short):
                found[known] = PREFIX
            elif len(short) >= SHORTEST and short in long:
                found[known] = PART
        return found


@functools.cache
def _index() -> _Index:
    return _Index()


def known() -> tuple[Hit, ...]:
    """Return all kinds and tasks of which words are known, in the order of the catalogue."""
    return tuple(_index().hits[name] for name in (*kinds(), *_table()["task"]) if words(name))


def neighbours() -> tuple[Beyond, ...]:
    """Return what is known and not covered."""
    return tuple(_index().beyond.values())


def _asked(text: str) -> list[str]:
    """Return the words of a question; a compound that is not known is replaced by its parts."""
    known = _index().scores.keys() | _alike().keys()
    found: list[str] = []
    for token in _tokens(text):
        parts = (token,) if token in known else _parts(token)
        found += [part if part in known else _stem(part) for part in parts] or [token]
    return list(dict.fromkeys(found))


def _unknown(text: str) -> tuple[str, ...]:
    """Return the words of a question that no covered entry has, neither a part nor what they may become."""
    index = _index()
    told = {word: _asked(word) for word in re.findall(r"[^\W\d_][\w-]+", text)}
    for word, tokens in list(told.items()):
        meant = (index.alike(each).keys() | {one for one in index.scores if one.startswith(each)} for each in tokens)
        if not tokens or any(index.scores[one].keys() & index.hits.keys() for some in meant for one in some):
            del told[word]
    return tuple(told)


def _public(text: str) -> list[Hit]:
    """Return the kinds of a class, or the public name of Python, that a text names; capitals do not count."""
    hits, told = _index().hits, text.strip().lower()
    made = [hits[kind] for kind, line in kinds().items() if line.path.split(":")[1].lower() == told]
    others = [name for name in public_names() if name.lower() == told]
    return made or [Hit(name, "python", f"python -m pydoc winkler.{name}") for name in others if name not in hits]


def _nearest(beyond: str, each: list[dict[str, float]]) -> tuple[Hit, ...]:
    """Return what comes nearest to what is not covered: what the other words of the question mean comes first."""
    index = _index()
    others: defaultdict[str, float] = defaultdict(float)
    for best in each:
        if beyond not in best:
            for name in best.keys() & index.hits.keys():
                others[name] += best[name] * index.favour.get(name, 1.0)
    ranked = sorted(others, key=lambda name: -others[name])
    named = [name for name in ranked[:1] if name in kinds()]
    return tuple(
        index.hits[name] for name in dict.fromkeys([*named, *index.beyond[beyond.removeprefix("beyond.")].nearest])
    )


def find(text: str, *, most: int = 5) -> SearchResult:
    """Return what a word or a question means, the best first.

    Parameters
    ----------
    text
        Words of English, German or French, or a public name of Python.
    most
        How many hits are wanted at most.

    Examples
    --------
    >>> [hit.name for hit in find("does my gasket leak?").hits][0]
    'seal'
    >>> find("oil film thickness").beyond.what
    'lubricant films'
    """
    index = _index()
    totals: defaultdict[str, float] = defaultdict(float)
    each: list[dict[str, float]] = []
    for token in _asked(text):
        best: defaultdict[str, float] = defaultdict(float)
        for known, sure in index.alike(token).items():
            for name, score in index.scores[known].items():
                best[name] = max(best[name], sure * score)
        decides = token in index.scores and all(name.startswith("beyond.") for name in best)
        for name, score in best.items():
            totals[name] += score * (DECIDES if decides else 1.0)
        each.append(best)
    public = _public(text)
    if not totals:
        return SearchResult(tuple(public), None)
    for name in totals:
        totals[name] *= index.favour.get(name, 1.0)
    ranked = sorted(totals, key=lambda name: -totals[name])
    if ranked[0].startswith("beyond.") and not public:
        beyond = index.beyond[ranked[0].removeprefix("beyond.")]
        return SearchResult(_nearest(ranked[0], each)[:most], beyond)
    least = PROMISED * totals[ranked[0]]
    names = [name for name in ranked if name in index.hits and totals[name] >= least]
    names.sort(key=lambda name: index.titles[name] != _tokens(text))  # what is asked for by its name comes first
    found = dict.fromkeys([*public, *(index.hits[name] for name in names)])
    return SearchResult(tuple(found)[:most], None, () if public else _unknown(text))


def materials_meant(word: str) -> tuple[str, ...]:
    """Return the materials that one word of English, German or French means above all, such as ``Stahl``.

    Examples
    --------
    >>> materials_meant("Messing"), materials_meant("leak")
    (('brass',), ())
    """
    told, hits = _tokens(word), find(word, most=1).hits
    if len(told) != 1 or not hits or "material" not in (hits[0].group, hits[0].name.rstrip("s")):
        return ()
    meant = {*told, *_alike().get(told[0], ())}
    return tuple(name for name in material_names() if meant & set(_tokens(" ".join((name, *other_names(name)[:-1])))))
