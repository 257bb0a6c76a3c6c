"""Every public value with every sort of nonsense in every field: one sentence of a `WinklerError`, or an answer.

The fields are those of the examples of all kinds, with everything inside them; each field of each class is tried once.
"""

from __future__ import annotations

import dataclasses
import math
import warnings

import numpy as np
import pytest

import winkler as wk
from winkler.study.language.build import build
from winkler.study.language.catalogue import kinds
from winkler.study.language.explain import completed
from winkler.values.errors import WinklerError

BAD = {
    "nan": math.nan, "infinite": math.inf, "minus infinite": -math.inf, "huge": 1e308, "negative": -1.0, "text": "a",
    "none": None, "nothing": [], "nans": np.full(3, math.nan), "complex": 1j, "empty": np.zeros(0), "object": object(),
    "true": True, "grid": np.ones((2, 2, 2)), "a huge whole number": 10**400, "words": np.array(["a"]), "table": {},
    "bytes": b"1",
}  # fmt: skip
SOLVED = ("nan", "infinite", "huge", "text", "none", "empty", "true")
"""What is also solved where it can be made."""


def parts(content, route=()):
    """Yield every field of a value, and of those inside it: the route to it, and its class and name."""
    for field in dataclasses.fields(content):
        if not field.init:
            continue
        inside = getattr(content, field.name)
        yield (*route, field.name), (type(content).__name__, field.name)
        if dataclasses.is_dataclass(inside):
            yield from parts(inside, (*route, field.name))
        elif isinstance(inside, tuple):
            for place, one in enumerate(inside):
                if dataclasses.is_dataclass(one):
                    yield from parts(one, (*route, field.name, place))


def put(content, route, new):
    """Return a value with something else at a place inside it, every value on the route made anew."""
    key, *rest = route
    if isinstance(key, int):
        items = list(content)
        items[key] = put(items[key], rest, new)
        return tuple(items)
    given = {field.name: getattr(content, field.name) for field in dataclasses.fields(content) if field.init}
    given[key] = put(given[key], rest, new) if rest else new
    return type(content)(**given)


def examples():
    """Return one case for every field of every class: its name, the example it stands in, and the route to it."""
    found = {}
    for name, line in kinds().items():
        for route, owned in parts(build(completed({"kind": name}), _slot(name))):
            found.setdefault(owned, (name, route))
        assert line.cls is not None
    return found


def _slot(name):
    from winkler.study.language.catalogue import slot_of

    return slot_of(name)


@pytest.mark.slow
def test_nonsense_is_refused_in_one_sentence():
    cases = examples()
    assert len(cases) > 600
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for (owner, field), (name, route) in cases.items():
            example = build(completed({"kind": name}), _slot(name))
            for bad in BAD.values():
                try:
                    put(example, list(route), bad)
                except WinklerError as error:
                    sentence = str(error)
                except Exception as error:
                    pytest.fail(f"{owner}.{field} = {bad!r} ends in {error!r}")
                else:
                    sentence = "."
                assert sentence.rstrip().endswith("."), f"{owner}.{field} = {bad!r}: {sentence}"
                assert len(sentence) < 2000, f"{owner}.{field} = {bad!r}: {sentence}"


BALL = wk.Foundation(wk.Sphere(10e-3), wk.HalfSpace(wk.Elastic(210e9, 0.3)))
CONTACT = wk.Indentation(BALL, wk.Force(100.0)).solve()
FUNCTIONS = {
    "restore": lambda bad: wk.restore(CONTACT, bad),
    "restore below": lambda bad: wk.restore(CONTACT, 1e-4, bad),
    "restore what": lambda bad: wk.restore(bad, 1e-4),
    "restore_body": lambda bad: wk.restore_body(CONTACT, bad, 0.0, 1e-4),
    "peak_stress": lambda bad: wk.peak_stress(bad),
    "staircase": lambda bad: wk.staircase(CONTACT, bad),
    "material": lambda bad: wk.material(bad),
    "to_pandas": lambda bad: wk.to_pandas(bad),
    "to_xarray": lambda bad: wk.to_xarray(bad),
    "write_vtk": lambda bad: wk.write_vtk(bad, "none/a.vtk"),
    "write_surface_interaction": lambda bad: wk.write_surface_interaction(bad, "none/a.inp", program="abaqus"),
    "write_law": lambda bad: wk.write_law(bad, "none/a.csv"),
    "write_trace": lambda bad: wk.write_trace(bad, "none/a.csv"),
    "ContactLaw": lambda bad: wk.ContactLaw(BALL, bad),
    "Indentation of a force": lambda bad: wk.Indentation(BALL, wk.Force(bad)).solve(),
    "Indentation of a depth": lambda bad: wk.Indentation(BALL, wk.Depth(bad)).solve(),
    "Indentation of a radius": lambda bad: wk.Indentation(BALL, wk.Radius(bad)).solve(),
}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_functions_refuse_nonsense(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for bad in BAD.values():
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            try:
                FUNCTIONS[name](bad)
            except WinklerError as error:
                sentence = str(error)
            else:
                sentence = "."
        assert sentence.rstrip().endswith((".", ")"))


@pytest.mark.slow
def test_what_can_be_made_of_nonsense_is_solved_or_refused():
    """All problems, with what their fields let through."""
    wrong = []
    for owned, (name, route) in examples().items():
        example = build(completed({"kind": name}), _slot(name))
        if not hasattr(example, "solve"):
            continue
        for word in SOLVED:
            try:
                with warnings.catch_warnings():
                    warnings.simplefilter("error")
                    put(example, list(route), BAD[word]).solve()
            except WinklerError:
                continue
            except Exception as error:  # collected, and shown together
                wrong.append(f"{'.'.join(owned)} {word}: {type(error).__name__} {str(error)[:80]}")
    assert wrong == []
