"""Words and questions of practitioners, written by people who knew the names of the kinds and nothing of the search."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import winkler as wk
from winkler.cli import main
from winkler.materials.named import material_names
from winkler.study.finding.finding import _table, find
from winkler.study.language.catalogue import CATALOGUE, kinds

ASKED = json.loads(Path(__file__).with_name("asked.json").read_text(encoding="utf-8"))
FIRST = 3
LATER = Path(__file__).with_name("asked_later.txt")


def answered(one):
    found = find(one["query"], most=FIRST)
    if not one["answers"]:
        return found.beyond is not None and len(found.hits) > 0
    return found.beyond is None and any(hit.name in one["answers"] for hit in found.hits)


def asked_later():
    """Yield round, language, text and what answers it."""
    number = 0
    for line in LATER.read_text(encoding="utf-8").splitlines():
        if line.startswith("=="):
            number = int(line.strip("= "))
        elif line and not line.startswith("#"):
            language, query, answers = line.split(" | ")
            yield number, language, query, answers.split()


@pytest.mark.few(2)
@pytest.mark.parametrize(
    "language, share, least", [("en", 0.98, 850), ("de", 0.98, 205), ("fr", 0.98, 189), ("beyond", 0.96, 336)]
)
def test_words_that_were_new_when_they_were_asked(language, share, least):
    """Each round was written before the search had seen it, and read by those who then mended the table.

    At first sight the search found, among the first three, of English words and questions 82, 77, 65, 78, 98, 81, 96
    and 92 % (rounds 1 to 8), of German and French ones 74, 83, 83, 90, 100, 74, 90 and 95 %, and said of 85, 77, 67,
    67, 85, 73, 58 and 95 % that they are not covered.  While half of round 8 was still unread by those who
    mended the table, 91, 95 and 92 % of it were found; since then all rounds have been read.
    Rounds 9 and 10, at first sight: 94 % of 50 English and 97 % of 32 German and French ones; of what is not covered,
    with round 11, 62 % of 47, which has no end: what is missing there is shown beside its nearest neighbours.
    Rounds 12 and 13: English 50 of 50 and 28 of 30, German and French 33 of 34 and 27 of 30; of what is not covered
    46 of 60, and, once words that no entry has were named, 44 of 60, two of them with a neighbour far away.
    Rounds 14 and 15, of the half that had mended nothing (but by the same writer as the mends): English 40 of
    42, German and French 18 of 19; of what is not covered 67 of 71 named and 69 said (52 and 65 before), with a doubt
    about 7 of 61 that are covered (10).  On 120 headings of a glossary of mechanical engineering, most of them far
    away, 100 (76); on 19 titles of forums, which nobody here had written, 14 (17, of which 3 by a doubt now given up).
    The shares below are those of today, of words that have been seen: what a new word meets is nearer to the former.
    """
    asked = [one for one in asked_later() if language == ("beyond" if one[3] == ["beyond"] else one[1])]
    missed = []
    for _, _, query, answers in asked:
        found = find(query, most=FIRST)
        names = {hit.name for hit in found.hits} | ({"beyond"} if found.remark or not found.hits else set())
        if not names & set(answers):
            missed.append(query)
    assert len(asked) >= least
    assert len(missed) <= (1.0 - share) * len(asked), missed


def test_what_is_covered_is_seldom_doubted():
    covered = [query for _, _, query, answers in asked_later() if "beyond" not in answers]
    doubted = [query for query in covered if find(query).remark]
    assert len(doubted) <= 0.04 * len(covered), doubted


def test_answers_that_are_expected_exist():
    table = _table()
    there = {*kinds(), *table["task"], *material_names(), "beyond"}
    assert {one for _, _, _, answers in asked_later() for one in answers} <= there


@pytest.mark.few(2)
@pytest.mark.parametrize(
    "language, what, share",
    [("en", "word", 0.95), ("en", "question", 0.9), ("de", "word", 0.95), ("de", "question", 0.9), ("fr", "word", 0.95),
     ("fr", "question", 0.9)],
)  # fmt: skip
def test_words_and_questions_are_among_the_first_three(language, what, share):
    asked = [one for one in ASKED if one["language"] == language and one["type"] == what]
    missed = [one["query"] for one in asked if not answered(one)]
    assert len(asked) >= 20
    assert len(missed) <= (1.0 - share) * len(asked), missed


def test_what_is_not_covered_is_said_with_the_nearest():
    asked = [one for one in ASKED if one["type"] == "beyond"]
    missed = [one["query"] for one in asked if not answered(one)]
    assert len(asked) >= 60
    assert len(missed) <= 0.1 * len(asked), missed


def test_every_problem_is_found_by_its_name_its_class_and_a_word_in_each_language():
    for kind, line in CATALOGUE["problem"].items():
        for text in (kind.replace("_", " "), line.path.split(":")[1]):
            assert find(text).hits[0].name == kind, text
        assert "" not in line.words[:3], kind


def test_the_table_names_what_there_is():
    table = _table()
    known = {*kinds(), *table["task"]}
    for entry in table["beyond"].values():
        assert set(entry["nearest"]) <= known


@pytest.mark.parametrize(
    "words, first",
    [
        ("hot", "friction_heating joule_heating"),
        ("leak", "seal"),
        ("strength", "yield_onset line_yield_onset"),
        ("Rollwiderstand", "sliding_resistance line_rolling_resistance"),
        ("Dichtung undicht", "seal"),
        ("Dichtung undichtt", "seal"),
        ("fuite d’un joint", "seal"),
        ("FrictionDamping", "friction_damping"),
        ("Waelzlager Laufbahn", "elliptic_indentation"),
        ("hysteresys loop of friction", "tangential friction_damping"),
    ],
)
def test_words_of_the_trade(words, first):
    assert {hit.name for hit in find(words, most=FIRST).hits} & set(first.split())


@pytest.mark.parametrize(
    "word, meant",
    [("hot", "friction_heating"), ("temperature", "friction_heating"), ("leak", "seal"),
     ("bearing", "elliptic_indentation"),
     ("AFM", "fit"), ("modulus", "fit"), ("gasket", "seal"), ("hertz", "indentation"), ("strength", "yield_onset"),
     ("gear", "line_indentation"), ("wheel-rail", "profile_pair"), ("bolt", "joint_stiffness"),
     ("wear", "sliding_wear"),
     ("rubber", "viscoelastic_indentation"), ("friction", "tangential"), ("adhesion", "adhesive_indentation"),
     ("roughness", "surface_contact"), ("stress", "contact_stress"), ("hardness", "nanoindentation"),
     ("coating", "coated_half_space"), ("roller", "line_indentation"), ("steel", "materials")],
)  # fmt: skip
def test_a_common_word_means_the_common_problem(word, meant):
    assert meant in [hit.name for hit in find(word, most=FIRST).hits]


@pytest.mark.parametrize(
    "words, beyond, first",
    [
        ("oil film thickness", "lubricant films", "indentation"),
        ("oil film and wear of a bearing", "lubricant films", "sliding_wear"),
        ("fatigue life of a coated ball", "fatigue lives", "yield_onset"),
        ("delamination energy of a tape", "cracks and fracture of the bodies", "viscoelastic_adhesion"),
    ],
)
def test_beside_what_is_not_covered_the_other_words_come_first(words, beyond, first):
    found = find(words, most=FIRST)
    assert found.beyond is not None
    assert found.beyond.what == beyond
    assert found.hits[0].name == first
    assert len(found.hits) == FIRST


@pytest.mark.parametrize("nonsense", ["", "   ", "qqqqxx", "?!", "der die das", "\x00", "x" * 10_000])
def test_nonsense_finds_nothing(nonsense):
    assert find(nonsense)[:2] == ((), None)


@pytest.mark.parametrize("word", ["gear", "wheel-rail", "bolt"])
def test_no_word_is_taken_for_another_by_its_letters(word, capsys):
    assert main(["show", word]) == 0
    out = capsys.readouterr().out
    assert "Nearest to" in out or "does not cover" in out
    assert "did you mean" not in out


@pytest.mark.parametrize("word", ["gaer", "stele", "quark", "xylem"])
def test_letters_alone_suggest_nothing(word, capsys):
    """'gaer' is no 'layer'; only two letters that changed places, or few that are wrong, are a misspelling."""
    assert main(["show", word]) == 2
    assert "did you mean" not in capsys.readouterr().err
    assert main(["show", "fti"]) == 2
    assert "did you mean 'fit'?" in capsys.readouterr().err


@pytest.mark.parametrize(
    "word, first, absent",
    [("gasket", "seal", "relaxation_test"), ("Härte", "nanoindentation", "sliding_resistance"),
     ("gear", "line_indentation", "wear")],
)  # fmt: skip
def test_a_word_does_not_list_what_it_does_not_mean(word, first, absent):
    names = [hit.name for hit in find(word).hits]
    assert names[0] == first
    assert absent not in names


def test_a_question_on_the_command_line(capsys):
    assert main(["show", "does", "my", "gasket", "leak"]) == 0
    out = capsys.readouterr().out
    assert "winkler show seal" in out
    assert main(["show", "oil", "film", "thickness", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["not_covered"] == "lubricant films"
    assert {one["name"] for one in told["found"]} <= set(kinds())
    assert all(one["meaning"] and one["command"].startswith("winkler ") for one in told["found"])


def test_a_new_study_is_offered_what_the_word_means(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["new", "leak"]) == 2
    assert "(did you mean 'seal'?)" in capsys.readouterr().err
    assert main(["new", "oil film"]) == 2
    assert "winkler does not cover lubricant films; nearest come indentation" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


def test_public_names_are_words_too():
    """A class of a kind finds the kind, any other public name itself."""
    classes = {kind: line.path.split(":")[1] for kind, line in kinds().items()}
    for name in wk.__all__:
        if not name.startswith("_"):
            hits = find(name, most=FIRST).hits
            assert any(name.lower() in (hit.name.lower(), classes.get(hit.name, "").lower()) for hit in hits), name
    (solution, *_) = find("sealsolution").hits
    assert solution.name == "SealSolution"
    assert solution.meaning.startswith("The solution of a `Seal`")
