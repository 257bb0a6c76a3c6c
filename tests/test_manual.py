"""The manual is whole: no problem is missing from it."""

from __future__ import annotations

import importlib
import importlib.util
import inspect
import itertools
import re

import numpy as np
import pytest
from project_files import project_files

import winkler as wk
from winkler.study.language.build import build
from winkler.study.language.catalogue import CATALOGUE
from winkler.study.language.explain import example_study


@pytest.mark.parametrize("slot", ["problem", "profile", "medium", "bed"])
def test_how_to_choose_names_everything(root, slot):
    page = (root / "docs" / "choosing.md").read_text(encoding="utf-8")
    missing = [
        line.cls.__name__ for line in CATALOGUE[slot].values() if not re.search(rf"\b{line.cls.__name__}\b", page)
    ]
    assert missing == []


@pytest.mark.slow
def test_every_problem_has_a_page_in_the_gallery(root):
    scripts = [path.read_text(encoding="utf-8") for path in project_files(root / "examples", "*.py")]
    problems = [line.cls.__name__ for line in CATALOGUE["problem"].values()] + [
        "Contacts",
        "BallImpacts",
        "OliverPharr",
    ]
    requested = {name for name in problems for script in scripts if re.search(rf"\b{name}(\.\w+)?\(", script)}
    assert [name for name in problems if name not in requested] == []


@pytest.fixture(scope="module")
def conf(root):
    """What makes the pages."""
    pytest.importorskip("sphinx_gallery", reason="the extra docs is not installed")
    spec = importlib.util.spec_from_file_location("manual_conf", root / "docs" / "conf.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_no_docstring_of_the_interface_holds_a_substitution(conf):
    """The size of s, written between bars, stopped the manual: a word there is a name that a page must define."""
    records = [importlib.import_module(p.rpartition(".")[0]) for p in conf.shared_records()]
    items = [getattr(module, p.rpartition(".")[2]) for module, p in zip(records, conf.shared_records(), strict=True)]
    items += [getattr(wk, name) for name in wk.__all__ if not name.startswith("__")]
    texts = [(item, name, inspect.getdoc(getattr(item, name, None)) or "") for item in items for name in vars(item)]
    texts += [(item, "", inspect.getdoc(item) or "") for item in items]
    literal = re.compile(r":math:`[^`]*`|``[^`]*``|^\.\. math::.*\n(?:\n| .*\n)*", re.MULTILINE)
    wrong = [
        (item, name) for item, name, text in texts if re.search(r"(?<!\w)\|\w[^|\n]*\|(?!\w)", literal.sub("", text))
    ]
    assert wrong == []


def test_the_interface_lists_all_public_names(conf):
    page = conf.public_names_page()
    documented = re.findall(r"^\.\. (?:autoclass|autofunction|py:data):: winkler\.(\w+)$", page, re.MULTILINE)
    assert sorted(documented) == sorted(name for name in wk.__all__ if not name.startswith("__"))
    for solution, number in ((wk.TangentialSolution, "shear_force"), (wk.SurfaceTangentialSolution, "misfit")):
        (record,) = [base for base in solution.__mro__[1:] if number in vars(base).get("__annotations__", {})]
        assert f".. autoclass:: {record.__module__}.{record.__name__}\n" in page
        assert number in record.__doc__


def test_each_chapter_opens_with_a_picture_that_an_example_draws(root):
    pages = [*project_files(root / "docs" / "chapters", "*.md"), *project_files(root / "docs" / "tutorials", "*.md")]
    pages = [page for page in pages if page.name != "index.md"]
    assert len(pages) > 35
    without = []
    for page in pages:
        opening = "\n".join(page.read_text(encoding="utf-8").split("\n")[:16])
        drawn = re.search(r"!\[[^\]]{20,}\]\(((?:\.\./)+)gallery/(\w+)/images/sphx_glr_(\w+)_\d{3}\.png\)", opening)
        beside = re.search(r"!\[[^\]]{20,}\]\(((?:\.\./)+figures/\w+\.png)\)", page.read_text(encoding="utf-8"))
        if drawn:
            up, folder, script = drawn.groups()
            found = (page.parent / up).resolve() == root / "docs" and (
                root / "examples" / folder / f"{script}.py"
            ).exists()
        else:
            found = bool(beside) and (page.parent / beside.group(1)).exists()
        if not found:
            without.append(page.name)
    assert without == []


@pytest.fixture
def media(root):
    """Return what writes the table of media and problems."""
    spec = importlib.util.spec_from_file_location("tabulate_media", root / "docs" / "tabulate_media.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def cells(media):
    """Return what docs/media/cells.toml states."""
    return media.read()


HINT = "run python docs/tabulate_media.py --kinds KIND,..., and write what it asks for"


LAYERED = ["graded_half_space", "coated_half_space", "depth_graded_half_space"]
OTHERS = sorted(set(CATALOGUE["medium"]) - set(LAYERED))


def test_the_pages_and_the_list_of_cells_are_as_their_script_writes_them(media, cells):
    assert media.CELLS.read_text(encoding="utf-8") == media.written(cells), HINT
    assert media.PAGE.read_text(encoding="utf-8") == media.page(cells), "run python docs/tabulate_media.py"
    assert media.STUDIES.read_text(encoding="utf-8") == media.studies_page(), "run python docs/tabulate_media.py"


def test_each_kind_has_a_cell_on_each_medium_that_could_take_it(media, cells):
    assert {medium for _, medium in cells.cells} == set(CATALOGUE["medium"]), HINT
    for group in cells.media():
        rows = cells.kinds(group)
        assert [(kind, m) for kind in rows for m in group if (kind, m) not in cells.cells] == [], HINT
    without = set(CATALOGUE["problem"]) - {kind for kind, _ in cells.cells}
    assert [kind for kind in without for m in CATALOGUE["medium"] if media.made(kind, m)[0].word == media.TAKEN] == []


def test_each_refused_cell_has_a_physical_reason_or_what_would_open_it(media, cells):
    """Before this list 67 were counted, of which 2 were opened, and those of five notes: 41 without a physical reason.

    Here are counted besides: greatest stresses 6, rolling on springs 16, bodies that relax 8.
    """
    assert media.to_be_written(cells) == []
    assert set(cells.physical).isdisjoint(cells.opens)
    assert len(media.refused(cells, cells.opens)) <= 67 - 2 + 41 + 30
    refused = [cell for cell in cells.cells.values() if cell.word == "refused"]
    assert len(refused) == len(media.refused(cells, cells.opens)) + len(media.refused(cells, cells.physical))
    assert all(not cell.reason for cell in cells.cells.values() if cell.word != "refused")


def test_a_refused_cell_without_a_reason_is_named(media, cells):
    """The script can fail: a new note has no reason yet, and a kind without a place no note."""
    place, bare = ("line_adhesion", "coated_half_space"), ("roller_contact", "coated_half_space")
    texts = {}
    key = media.key_of("It is not known.", texts, set())
    changed = cells.cells | {place: media.Cell("refused", (key,)), bare: media.Cell("refused")}
    first, second = media.to_be_written(cells._replace(stated=cells.stated | texts, cells=changed))
    assert "roller_contact on coated_half_space has no place" in first + second
    assert "line_adhesion on coated_half_space is refused" in first + second


def test_exact_is_what_notes_declare_of_each_assumption_of_the_method(media, cells):
    """Of those that are stated; those that a number checks have a note only where the number is near its limit."""
    for (kind, medium), cell in cells.cells.items():
        if cell.word == "exact":
            declared = CATALOGUE["problem"][kind].cls.assumptions & media.OF_METHOD
            stated = {assumption.name.lower() for assumption in declared if not assumption.checked}
            assert "response" in stated <= set(cell.rests), (kind, medium)
            assert set(cell.rests) <= {assumption.name.lower() for assumption in declared}, (kind, medium)
        else:
            assert cell.rests, (kind, medium)


def test_what_a_medium_leaves_out_is_left_out_by_each_problem_on_it(cells):
    """Forces of attracted maps on gradings were said to be exact."""
    left_out = {medium: cells.cells["indentation", medium].rests for medium in cells.media()[0]}
    left_out = {m: rests for m, rests in left_out.items() if cells.cells["indentation", m].word == "approximate"}
    assert sorted(left_out) == ["depth_graded_half_space", "graded_half_space"]
    for (kind, medium), cell in cells.cells.items():
        if cell.word != "refused":
            for rest in left_out.get(medium, ()):  # lines say it in sentences of their own
                assert any(one.startswith(rest) for one in cell.rests), (kind, medium)


@pytest.mark.parametrize("medium", [*LAYERED, *(pytest.param(medium, marks=pytest.mark.slow) for medium in OTHERS)])
def test_cells_without_a_problem_are_as_stated(media, cells, medium):
    for kind in CATALOGUE["problem"]:
        found, stated = media.made(kind, medium)[0], cells.cells.get((kind, medium))
        if stated is None:
            assert found.word != media.TAKEN, (kind, HINT)
        else:
            assert cells.agrees(stated, found), (kind, HINT)


QUICK_CELLS = [
    ("indentation", "half_space", "exact"),
    ("rolling_start", "half_space", "approximate"),
    ("rough_contact", "graded_half_space", "approximate"),
    ("sliding_wear", "graded_half_space", "approximate"),
    ("surface_rolling", "half_space", "approximate"),
    ("surface_adhesion", "graded_half_space", "approximate"),
    ("tangential", "transversely_isotropic_half_space", "approximate"),
    ("torsion", "stacked_half_space", "approximate"),
    ("torsion", "coated_half_space", "exact"),
    ("elliptic_indentation", "coated_half_space", "exact"),
    ("roller_contact", "coated_half_space", "exact"),
    ("tangential", "viscoelastic_coated_half_space", "approximate"),
    ("sliding_resistance", "viscoelastic_coated_half_space", "refused"),
    ("surface_tangential", "viscoelastic_half_space", "approximate"),
]


@pytest.mark.parametrize(("kind", "medium", "word"), QUICK_CELLS)
def test_some_cells_are_what_their_problems_answer(media, cells, kind, medium, word):
    written = cells.cells[kind, medium]
    assert written.word == word
    assert cells.agrees(written, media.answer(kind, medium)), HINT


def test_a_change_of_an_example_that_finds_no_place_is_named(media, monkeypatch):
    monkeypatch.setitem(media.SHORT["changed"], "seal", {"contact.topograhpy.shape": [16, 16]})
    with pytest.raises(ValueError, match=r"the example of seal on half_space has no 'contact\.topograhpy'"):
        media.example("seal", "half_space")
    heated = media.example("surface_friction_heating", "viscoelastic_coated_half_space")  # of another contact
    assert "longitudinal" not in str(heated)


def test_a_cell_that_answers_otherwise_is_found(media, cells):
    found = media.answer("indentation", "half_space")
    refused = cells.cells["periodic_indentation", "graded_half_space"]
    for written in (cells.cells["indentation", "graded_half_space"], refused):
        assert not cells.agrees(written, found)
    assert not cells.agrees(refused, media.Cell(media.TAKEN)), "it was opened"
    assert not cells.agrees(cells.cells["indentation", "half_space"], media.Cell(media.NO_PLACE))


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize(
    "medium",
    [
        pytest.param(medium, marks=pytest.mark.slow) if medium == "stacked_half_space" else medium  # the most problems
        for medium in CATALOGUE["medium"]
    ],
)
def test_each_cell_is_what_its_problem_answers(media, cells, medium):
    """Those of which the problem is built; of the others the test above knows all."""
    for (kind, column), written in cells.cells.items():
        if column == medium and media.made(kind, medium)[0].word == media.TAKEN:
            assert cells.agrees(written, media.answer(kind, medium)), (kind, HINT)


def test_pages_lead_on_to_pages_that_are_there(root):
    docs = root / "docs"
    broken = []
    for path in project_files(docs, "*.md"):
        for target in re.findall(r"\]\(([\w./-]+)(?:#[\w-]*)?\)", path.read_text(encoding="utf-8")):
            place = (path.parent / target).resolve()
            if "gallery" in place.parts:  # made from the examples
                place = root / "examples" / place.relative_to(docs / "gallery").with_suffix(".py")
                if drawn := re.fullmatch(r"sphx_glr_(\w+)_\d{3}", place.stem):
                    place = place.parent.parent / f"{drawn.group(1)}.py"
                place = place if place.stem != "index" else root / "examples"
            if not place.exists():
                broken.append(f"{path.name}: {target}")
    assert broken == []


SUPPORTS = re.compile(r"\b(?:do(?:es)? not|also|is|are)? ?(?:not )?(?:support(?:s|ed)?|accepts?)\b")


def test_what_a_page_says_of_a_problem_and_a_medium_is_what_the_cells_say(root, cells):
    """Friction on layers that relax was opened, and three pages said for another day that it was not supported."""
    problems = {CATALOGUE["problem"][kind].cls.__name__: kind for kind, _ in cells.cells}
    media = {line.cls.__name__: kind for kind, line in CATALOGUE["medium"].items() if kind != "stacked_half_space"}
    wrong, seen = [], 0
    for path in project_files(root / "docs", "*.md"):
        text = " ".join(re.sub(r"(?ms)^```.*?^```", "", path.read_text(encoding="utf-8")).split())
        for sentence in re.split(r"(?<=[.;:])\s|\|", text if "changelog" not in path.parts else ""):
            sides = [re.findall(r"`(\w+)", side) for side in SUPPORTS.split(sentence)]
            for one, other in [*itertools.pairwise(sides), *itertools.pairwise(sides[::-1])] if len(sides) == 2 else ():
                for kind, medium in itertools.product(problems.keys() & one, media.keys() & other):
                    if cell := cells.cells.get((problems[kind], media[medium])):
                        seen += 1
                        if (cell.word == "refused") != (" not support" in sentence):
                            wrong.append(f"{path.name}: {sentence}")
    assert seen >= 25, "too few sentences are found"
    assert wrong == []


def test_the_items_of_a_list_count_without_a_gap(root):
    """The fourth step of a list stood within the third."""
    for path in [*project_files(root / "docs", "*.md"), *root.glob("*.md")]:
        text = re.sub(r"(?ms)^```.*?^```", "", path.read_text(encoding="utf-8"))
        numbers = [0, *(int(number) for number in re.findall(r"(?m)^\s*(\d+)\. ", text))]
        assert all(after in (1, before + 1) for before, after in itertools.pairwise(numbers)), path.name


def test_the_puzzle_is_the_first_page(root):
    index = (root / "docs" / "index.md").read_text(encoding="utf-8")
    trees = re.findall(r"```\{toctree\}\n(?::[^\n]*\n)*\n(.*?)```", index, re.DOTALL)
    listed = [page for tree in trees for page in tree.split()]
    assert listed[0] == "puzzle"
    pages = {path.stem for path in project_files(root / "docs", "*.md") if path.parent == root / "docs"} - {"index"}
    assert pages == {page for page in listed if "/" not in page}


PROMISES = re.compile(
    r"\b(?:any|every|all)\s+(?:histor|profile|shape|medium|media|speed|amplitude|solid|law)\w*", re.IGNORECASE
)
ALLOWED = {
    "choosing.md": {"any shape": "a note of SurfaceConstriction, see conduction.md"},
    "conduction.md": {
        "any shape": "Barber's analogy, tests/problems/conduction/test_constriction.py presses an ellipse"
    },
}


def test_no_page_promises_more_than_was_tested(root):
    """A page names the shapes, media and histories that it means; what is left of "any" and "every" has a test."""
    docs = root / "docs"
    found = []
    for path in [
        root / "README.md",
        *(path for path in project_files(docs, "*.md") if path.parent == docs),
        *project_files(docs / "chapters", "*.md"),
        *project_files(docs / "tutorials", "*.md"),
    ]:
        text = {" ".join(words.split()).lower() for words in PROMISES.findall(path.read_text(encoding="utf-8"))}
        found += [f"{path.name}: {words}" for words in text - set(ALLOWED.get(path.name, ()))]
    assert found == []


@pytest.mark.few(3, slow=2)
@pytest.mark.parametrize("medium", sorted(CATALOGUE["medium"]))
def test_elastic_media_are_pressed_stick_and_wear_to_a_limit(medium):
    """As adhesion.md and wear.md state: half-spaces, layers and gradings; bodies that relax are refused.

    A film that slides on its base bears no shear, so that it has no limit to which it wears.
    """
    bed = wk.Foundation(wk.Paraboloid(0.01), build(example_study(medium)["problem"]).bed.medium)
    requested = (
        lambda: wk.Indentation(bed, wk.Depth(1e-6)),
        lambda: wk.AdhesiveIndentation(bed, wk.ShortRange(0.05), wk.Depth(1e-6)),
        lambda: wk.LimitingProfile(bed, wk.Coulomb(0.5), wk.Depth(1e-6), wk.Shift(0.2e-6)),
    )
    for problem in requested:
        if hasattr(CATALOGUE["medium"][medium].cls, "relaxation"):
            with pytest.raises(wk.OutsideValidity, match="changes? in time"):
                problem()
        elif medium in {"sliding_film", "stacked_half_space"} and problem is requested[-1]:
            with pytest.raises(wk.OutsideValidity, match="carries no shear"):
                problem().solve()
        else:
            assert problem().solve().radius > 0.0


@pytest.mark.parametrize(("softer", "low", "high"), [(None, 0.08, 0.13), (10.0, -0.35, -0.28), (100.0, -0.75, -0.695)])
def test_when_a_coating_matters(softer, low, high):
    """What choosing.md states of the stiffness at a tenth of the thickness, from nu = 0 to 0.5."""
    changes = []
    for poisson in (0.0, 0.3, 0.5):
        layer = wk.Elastic(1e9, poisson)
        base = wk.Rigid() if softer is None else wk.Elastic(1e9 / softer, poisson)
        film = wk.CoatedHalfSpace([wk.Layer(layer, 1.0)], on=base)
        a = np.array(0.1)
        changes.append(float(film.punch_stiffness(a) / wk.HalfSpace(layer).punch_stiffness(a)) - 1.0)
    assert low <= min(changes)
    assert max(changes) <= high
