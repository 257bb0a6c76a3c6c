"""Whatever stands in a study file: a study, or one sentence of a `WinklerError`; never another error, never a hang."""

from __future__ import annotations

import copy
import functools
import math
import tomllib

import pytest
import tomli_w
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from winkler.study.language.catalogue import kinds
from winkler.study.language.reading import parse_study, read_study
from winkler.study.language.template import whole_text
from winkler.study.language.writing import study_text
from winkler.values.errors import WinklerError

QUICK = settings(max_examples=60, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))


@functools.cache
def example(name):
    """Return the study of a kind; texts are written when a test needs them, not while tests are collected."""
    return tomllib.loads(whole_text(name))


NUMBERS = st.one_of(
    st.sampled_from(
        [0, 1, -1, 2**31, 2**63 - 1, -(2**63), 0.0, -0.0, 1e-320, 1e308, -1e308, math.nan, math.inf, -math.inf]
    ),
    st.floats(),
    st.integers(-(2**63), 2**63 - 1),
)
UNITS = [
    "m",
    "mm",
    "um",
    "N",
    "Pa",
    "GPa",
    "deg",
    "K",
    "degC",
    "1/s",
    "m^-3",
    "",
    "furlong",
    "m**9999",
    "N/0",
    "m^(1e9)",
]
QUANTITIES = st.builds("{} {}".format, NUMBERS, st.sampled_from(UNITS))
WORDS = st.one_of(
    st.text(max_size=20),
    st.sampled_from([*kinds(), "infinite", "nan", "__class__", "file", "../..", "r**9**9**9", "1 m; 2 m", "\x00", "μ"]),
)
LEAVES = st.one_of(NUMBERS, QUANTITIES, WORDS, st.booleans())
RANGES = st.fixed_dictionaries(
    {"from": LEAVES, "to": LEAVES, "count": NUMBERS}, optional={"spacing": st.sampled_from(["log", "linear", "x", ""])}
)
TABLES = st.sampled_from(list(kinds())).map(lambda name: example(name)["problem"])
CONTENT = st.recursive(
    st.one_of(LEAVES, RANGES, TABLES),
    lambda inner: st.one_of(st.lists(inner, max_size=4), st.dictionaries(st.text(max_size=8), inner, max_size=3)),
    max_leaves=6,
)


def places(content, path=()):
    """Return the path of everything inside a table."""
    found = []
    items = content.items() if isinstance(content, dict) else enumerate(content) if isinstance(content, list) else ()
    for key, inner in items:
        found += [(*path, key), *places(inner, (*path, key))]
    return found


@st.composite
def spoilt(draw):
    """Return a study with one to three things replaced, added, or taken away."""
    study = copy.deepcopy(example(draw(st.sampled_from(list(kinds())))))
    for _ in range(draw(st.integers(1, 3))):
        all_places = places(study)
        if not all_places:
            break
        *route, last = draw(st.sampled_from(all_places))
        inside = study
        for key in route:
            inside = inside[key]
        what = draw(st.sampled_from(["replace", "replace", "take", "add", "sweep", "fields", "expect"]))
        if what == "replace":
            inside[last] = copy.deepcopy(draw(CONTENT))
        elif what == "take":
            del inside[last]
        elif what == "add" and isinstance(inside, dict):
            inside[draw(st.one_of(WORDS, st.sampled_from(["file", "kind", "radii", "count"])))] = copy.deepcopy(
                draw(CONTENT)
            )
        elif what == "sweep":
            study["sweep"] = {".".join(map(str, (*route, last))): copy.deepcopy(draw(CONTENT))}
        elif what == "fields":
            study["fields"] = {draw(st.sampled_from(["r", "z", "x"])): copy.deepcopy(draw(CONTENT))}
        elif what == "expect":
            study["expect"] = [{"quantity": draw(WORDS), "value": draw(LEAVES), "tolerance": draw(NUMBERS)}]
    return study


def read_or_refused(text: str) -> None:
    """Read a study: what comes is a study that can be written, or an error that says what is wrong."""
    try:
        study = parse_study(text, file="study.toml")
    except WinklerError as error:
        message = str(error)
        assert message.startswith("study.toml")
        assert message.rstrip().endswith((".", ". "))
        assert "Traceback" not in message
        return
    assert parse_study(study_text(study), file="study.toml").problem == study.problem


def written(table) -> str:
    try:
        return tomli_w.dumps(table)
    except (TypeError, ValueError, AttributeError):
        return ""


@pytest.mark.slow
@QUICK
@given(spoilt())
def test_a_spoilt_study(table):
    read_or_refused(written(table))


@QUICK
@given(st.one_of(st.text(max_size=200), st.text(alphabet="[]{}=\"'\n.,#abk 1e9_-", max_size=200)))
def test_any_text(text):
    read_or_refused(text)


@QUICK
@given(st.binary(max_size=200), st.sampled_from([b"", b"\xef\xbb\xbf", b"\xff\xfe", b"[problem]\n"]))
def test_any_bytes(tmp_path_factory, content, start):
    path = tmp_path_factory.getbasetemp() / "study.toml"
    path.write_bytes(start + content)
    try:
        read_study(path)
    except WinklerError as error:
        message = str(error)
    else:
        message = "."
    assert message.endswith(".")


DEEP = {
    "tables in tables": "a" + ".a" * 5000 + " = 1",
    "lists in lists": "a = " + "[" * 5000 + "]" * 5000,
    "inline tables": "a = " + "{a=" * 3000 + "1" + "}" * 3000,
    "thousands of keys": "\n".join(f"k{number} = 1" for number in range(20_000)),
    "one long text": 'title = "' + "x" * 1_000_000 + '"',
    "one long number": "a = " + "9" * 10_000,
    "a date": "[problem]\nkind = 1979-05-27T07:32:00Z",
    "a sweep of a key that is long": '[problem]\nkind = "indentation"\n[sweep]\n"problem.' + "a." * 10_000 + 'b" = [1]',
    "a profile in a profile": '[problem]\nkind = "indentation"\n[problem.bed.profile'
    + ".cap" * 900
    + ']\nkind = "capped_cylinder"\nradius = "1 mm"',
}


@pytest.mark.parametrize("name", DEEP)
def test_what_is_far_too_much(name):
    read_or_refused(DEEP[name])


@pytest.mark.parametrize("count", [10**9, 2**62, 1e300, -5, 0, 1.5])
def test_a_range_of_too_many(count):
    text = whole_text("indentation").replace('"100 N"', f'{{ from = "1 N", to = "2 N", count = {count} }}')
    with pytest.raises(WinklerError, match="count"):
        parse_study(text)
