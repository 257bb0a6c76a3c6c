"""A wrong name or argument suggests the right one, and costs nothing where the name is right."""

from __future__ import annotations

import copy
import dataclasses
import inspect
import pickle
import re

import pytest

import winkler
import winkler as wk
from winkler.public import __all__ as PUBLIC
from winkler.study.language.reading import parse_study
from winkler.values.errors import SYNONYMS, nearest, suggest
from winkler.values.value import value
from winkler.values.vocabulary import GLOSSARY

BED = wk.Foundation(wk.Sphere(0.01), wk.HalfSpace(wk.Elastic(210e9, 0.3)))
CONTACT = wk.Indentation(BED, wk.Force(1.0)).solve()


def test_dir_lists_the_public_names_but_answers():
    import winkler.plot  # a submodule that is loaded is no public name

    assert hasattr(winkler, "plot")
    assert dir(winkler) == sorted(name for name in winkler.__all__ if not name.endswith("Solution"))
    assert "Indentation" in dir(winkler)
    assert "IndentationSolution" not in dir(winkler)
    assert [name for name in dir(winkler) if name.startswith("_")] == ["__version__"]


@pytest.mark.parametrize(
    ("wrong", "right"),
    [
        ("Indentaton", "Indentation"),
        ("sphere", "Sphere"),
        ("Ball", "Sphere"),
        ("JKR", "ShortRange"),
        ("halfspace", "HalfSpace"),
    ],
)
def test_a_wrong_public_name(wrong, right):
    with pytest.raises(AttributeError, match=rf"no attribute '{wrong}' \(did you mean '{right}'\?\)"):
        getattr(winkler, wrong)
    assert not hasattr(winkler, wrong)


ARGUMENTS = [
    (wk.Sphere, {"radius": 0.01}, "curvature_radius"),
    (wk.Sphere, {"R": 0.01}, "curvature_radius"),
    (wk.FlatPunch, {"R": 0.01}, "radius"),
    (wk.Cone, {"half_angel": 1.0}, "half_angle"),
    (wk.Elastic, {"E": 1.0, "poisson": 0.3}, "young"),
    (wk.Elastic, {"young": 1.0, "nu": 0.3}, "poisson"),
    (wk.Elastic, {"young": 1.0, "poisson_ratio": 0.3}, "poisson"),
    (wk.Force, {"load": 1.0}, "force"),
    (wk.Force, {"P": 1.0}, "force"),
    (wk.Depth, {"indentation": 1.0}, "depth"),
    (wk.Depth, {"delta": 1.0}, "depth"),
    (wk.Coulomb, {"mu": 0.3}, "coefficient"),
    (wk.ShortRange, {"gamma": 0.05}, "work"),
    (wk.Foundation, {"shape": wk.Sphere(1.0), "medium": BED.medium}, "profile"),
    (wk.MeasuredBed, {"radii": [1.0], "stiffness": [1.0], "depths": [1.0]}, "stiffnesses"),
]


@pytest.mark.parametrize(("cls", "given", "right"), ARGUMENTS)
def test_a_wrong_argument(cls, given, right):
    known = inspect.signature(cls).parameters
    [wrong] = given.keys() - known
    with pytest.raises(
        TypeError, match=rf"^{cls.__name__}: there is no argument '{wrong}' \(did you mean '{right}'\?\)"
    ):
        cls(**given)


def test_what_else_is_wrong_with_arguments_stays_what_it_was():
    with pytest.raises(TypeError, match="missing 1 required positional argument: 'poisson'"):
        wk.Elastic(1.0)
    with pytest.raises(TypeError, match="takes 2 positional arguments but 3 were given"):
        wk.Sphere(1.0, 2.0)
    with pytest.raises(TypeError, match="'radius' .*'curvature_radius'"):
        dataclasses.replace(wk.Sphere(1.0), radius=2.0)

    @value
    class Raising:
        number: float

        def __post_init__(self):
            raise TypeError("of its own")

    with pytest.raises(TypeError, match="^of its own$"):
        Raising(1.0)


def test_a_wrong_attribute():
    with pytest.raises(
        AttributeError, match=r"'IndentationSolution' object has no attribute 'depht' \(did you mean 'depth'"
    ):
        _ = CONTACT.depht
    with pytest.raises(AttributeError, match=r"\(did you mean 'stiffness'\?\)"):
        _ = CONTACT.stifness
    with pytest.raises(AttributeError, match="no attribute 'zzz'$") as caught:
        _ = CONTACT.zzz
    assert caught.value.name == "zzz"
    assert not hasattr(CONTACT, "indentation")
    assert getattr(CONTACT, "depht", 3) == 3
    assert inspect.getattr_static(CONTACT, "depht", 4) == 4


def test_a_property_that_fails_says_why():
    @value
    class Faulty:
        number: float

        @property
        def half(self) -> float:
            """Half of it."""
            return self.number.halved  # type: ignore[attr-defined, no-any-return]

    with pytest.raises(AttributeError, match="'float' object has no attribute 'halved'"):
        _ = Faulty(1.0).half


def test_copies_and_pickles_know_their_names():
    for other in (copy.copy(CONTACT), copy.deepcopy(CONTACT), pickle.loads(pickle.dumps(CONTACT))):
        assert other == CONTACT
        assert not hasattr(other, "depht")


@pytest.mark.parametrize("wrong", SYNONYMS)
def test_synonyms_lead_to_words_of_winkler(wrong):
    known = {*GLOSSARY, *PUBLIC, "first", "second", "law", "on", "normal", "stroke"}
    assert known.issuperset(SYNONYMS[wrong])
    assert wrong not in SYNONYMS[wrong]


def test_a_study_knows_the_usual_words_too():
    text = """
        title = "a ball"
        problem.kind = "indentation"
        problem.load = { kind = "force", load = "1 N" }
        problem.bed.kind = "foundation"
        problem.bed.profile = { kind = "sphere", radius = "10 mm" }
        problem.bed.medium = { kind = "half_space", first = { kind = "elastic", E = "210 GPa", nu = 0.3 } }
    """
    with pytest.raises(wk.WinklerError) as caught:
        parse_study(text, file="ball.toml")
    found = re.findall(r"(\w+) is not known \(did you mean '(\w+)'\?\)", str(caught.value))
    assert dict(found) == {"load": "force", "radius": "curvature_radius", "E": "young", "nu": "poisson"}
    assert "add it" not in str(caught.value)  # what was meant is not missing as well


def test_a_map_that_rolls_has_a_drive():
    """As `Rolling` has a creepage, and `SurfaceRolling` once had one."""
    with pytest.raises(TypeError, match=r"SurfaceRolling: there is no argument 'creepage' \(did you mean 'drive'\?\)"):
        wk.SurfaceRolling(creepage=wk.Creepage(1e-3))
    text = """
        title = "a wheel"
        problem.kind = "surface_rolling"
        problem.creepage = { kind = "creepages", longitudinal = 1e-3 }
    """
    with pytest.raises(wk.WinklerError, match=r"problem.creepage is not known \(did you mean 'drive'\?\)") as caught:
        parse_study(text, file="wheel.toml")
    assert "no 'drive'" not in str(caught.value)


def test_what_is_like_nothing_gets_no_suggestion():
    assert nearest("xyzzy", ["depth", "force"]) == ""
    assert suggest("xyzzy", ["depth"]) == ""
    assert nearest("R", ["r", "pi"]) == ""  # letters of a formula are not the same in capitals
