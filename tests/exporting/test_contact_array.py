"""Many contacts in arrays: each does what it does alone, and keeps its memory wherever it stands."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest
from exported_laws import GLASS, PROBLEMS, STEEL

import winkler as wk
from winkler.exporting.choose import law_of
from winkler.exporting.many import contact_store
from winkler.exporting.many.contact_array import ContactArray

BEADS = PROBLEMS["beads"]
WORDS = {"motion_x": "motion", "roll_x": "roll"}


def entries(rows, motion, many=1):
    """Return what goes into `step` from the rows of a trace of one law, the same for many contacts."""
    names = [number.name for number in motion]
    for row in rows:
        given = {}
        for place, name in enumerate(names):
            word = WORDS.get(name, name)
            if name.endswith("_y"):
                continue
            wide = name.endswith("_x")
            part = row[place : place + 2] if wide else row[place]
            given[word] = np.full((many, 2) if wide else many, part)
        yield given


def history(seed, many, steps, reach=2e-6):
    rng = np.random.default_rng(seed)
    return (
        rng.uniform(-0.3, 1.0, (steps, many)) * reach,
        rng.normal(scale=0.2 * reach, size=(steps, many, 2)),
        rng.normal(scale=1e-3, size=(steps, many)),
        rng.normal(scale=1e-3, size=(steps, many, 2)),
    )


def beads(size=0, **options):
    return ContactArray(BEADS, size, **options)


def memory_of(array):
    return [np.array(array.memory(name)) for name in ("displaced", "twisted", "rolled", "past")]


# ---------------------------------------------------------------------------------------------------------------------
# forces


def test_balls_of_different_sizes_do_what_contacts_do():
    """The other one has its formulas in arrays of numpy, and goes through all steps of a contact at once."""
    many, steps = 600, 12  # more than a thread takes alone
    rng = np.random.default_rng(3)
    pairs = wk.Contacts.apart(
        GLASS, curvature_radius=rng.uniform(0.5e-3, 2e-3, many), coefficient=rng.uniform(0.0, 0.6, many), reach=2e-6,
        rolling_arm=rng.uniform(0.0, 1e-4, many), count=8,
    )  # fmt: skip
    depth, motion, twist, roll = history(4, many, steps)
    _, trace = pairs.along(depth.T, motion=motion.swapaxes(0, 1), twist=twist.T, roll=roll.swapaxes(0, 1))
    array = ContactArray(pairs, many)
    for t in range(steps):
        array.step(depth[t], motion=motion[t], twist=twist[t], roll=roll[t])
        for name, expected in (
            ("force", trace.force[:, t]), ("shear_x", trace.shear_force[:, t, 0]),
            ("shear_y", trace.shear_force[:, t, 1]), ("torque", trace.torque[:, t]),
            ("rolling_y", trace.rolling_moment[:, t, 1]), ("stored_energy", trace.stored_energy[:, t]),
            ("dissipation", trace.dissipation[:, t]),
        ):  # fmt: skip
            np.testing.assert_allclose(array.answer(name), expected, rtol=0.0, atol=1e-13 * np.max(np.abs(expected)))


@pytest.mark.slow
def test_hertz_of_two_radii_from_tiny_to_the_deepest():
    laws = [wk.Indentation(wk.Foundation(wk.Paraboloid(radius), STEEL), wk.Depth(1e-6)) for radius in (1e-3, 3e-3)]
    depth = np.array([-1e50, -1e-9, 0.0, 5e-324, 1e-60, 1e-20, 1e-9, 1e-6])
    array = ContactArray(laws, 16, kind=np.repeat([0, 1], 8))
    array.step(np.tile(depth, 2))
    pressed = np.maximum(depth, 0.0)
    hertz = [4.0 / 3.0 * STEEL.modulus * math.sqrt(radius) * pressed * np.sqrt(pressed) for radius in (1e-3, 3e-3)]
    np.testing.assert_allclose(array.answer("force"), np.concatenate(hertz), rtol=2e-13)
    assert not np.any(np.isnan(array.answer("stiffness")))
    with pytest.raises(wk.OutsideValidity, match="contact 9 is pressed 1.1e-06 m deep, beyond the 1e-06 m"):
        array.step(np.where(np.arange(16) == 9, 1.1e-6, 0.0))


def test_huge_and_tiny_motions_leave_finite_numbers():
    array = beads(6)
    for depth in ([1e-6, 0.0, 1e-30, 2e-6, -1e40, 1e-6], 0.0, 1e-6, -1e59):
        for size in (0.0, 1e-60, 1e59, 1e-9):
            array.step(depth, motion=(size, -size), twist=size, roll=(-size, size))
            for name in array.names:
                assert np.all(np.isfinite(array.answer(name))), (name, depth, size)
    assert np.all(array.answer("shear_x") == 0.0)


@pytest.mark.slow
def test_in_single_precision_springs_take_half_and_are_off_by_its_rounding():
    depth, motion, twist, roll = history(6, 50, 30)
    double, single = beads(50), beads(50, precision="single")
    for t in range(30):
        for array in (double, single):
            array.step(depth[t], motion=motion[t], twist=twist[t], roll=roll[t])
        off = np.max(np.abs(single.answer("shear_x") - double.answer("shear_x"))) / np.max(double.answer("force"))
        assert off < 3e-7
    assert off > 0.0
    assert double.bytes_for(1) - single.bytes_for(1) == 64


# ---------------------------------------------------------------------------------------------------------------------
# memory


def test_contacts_that_come_go_and_change_places_keep_their_memory():
    """Each one is also stepped where nobody comes or goes."""
    everyone, steps = 60, 24
    rng = np.random.default_rng(8)
    depth, motion, twist, roll = history(9, everyone, steps)
    array, reference = beads(20), beads(everyone)
    who = np.arange(20)
    later = 20
    for t in range(steps):
        here = np.isin(np.arange(everyone), who)
        array.step(depth[t, who], motion=motion[t, who], twist=twist[t, who], roll=roll[t, who])
        reference.step(
            np.where(here, depth[t], 0.0), motion=motion[t] * here[:, None], twist=twist[t] * here,
            roll=roll[t] * here[:, None],
        )  # fmt: skip
        for mine, true in zip(memory_of(array), memory_of(reference), strict=True):
            assert np.array_equal(mine, true[who])
        assert np.array_equal(array.answer("dissipation"), reference.answer("dissipation")[who])
        if t % 4 == 0:
            assert list(array.add(3)) == [who.size, who.size + 1, who.size + 2]
            who, later = np.append(who, np.arange(later, later + 3)), later + 3
        elif t % 4 == 1:
            which = rng.random(who.size) < 0.1
            who = who[array.remove(which if t % 8 == 1 else np.flatnonzero(which))]
        elif t % 4 == 2:
            order = rng.permutation(who.size)[: who.size - 1]
            array.renumber(np.insert(order, 2, -1))
            who, later = np.insert(who[order], 2, later), later + 1
    array.reset(who == who[0])
    assert all(not np.any(part[0]) for part in memory_of(array))
    assert np.any(memory_of(array)[3][1])
    array.remove(np.ones(who.size, dtype=bool))
    array.step(np.zeros(0))
    assert array.size == 0


def test_kinds_go_with_their_contacts(tmp_path):
    pairs = wk.Contacts.apart(GLASS, curvature_radius=[1e-3, 4e-3], coefficient=0.3, reach=2e-6, count=2)
    array = ContactArray(pairs, 3, kind=[0, 1, 0])
    array.add(1, kind=1)
    array.renumber([3, -1, 0], kind=1)
    array.step(1e-6)
    array = ContactArray.restored(pairs, array.save(tmp_path / "kinds"))
    array.step(1e-6)
    assert array.answer("radius") == pytest.approx(np.sqrt(np.array([4e-3, 4e-3, 1e-3]) * 1e-6), rel=1e-14)


def test_the_bytes_are_those_that_are_taken(monkeypatch):
    kept = ("force", "shear_x", "shear_y")
    array = beads(1000, answers=kept)
    taken = sum(part.nbytes for part in (*memory_of(array), np.array([array.answer(name) for name in kept])))
    assert array.bytes_for(1000) == taken + 72  # and nine numbers of the law
    assert beads(answers=kept).bytes_for(10**7) <= 200 * 10**7
    monkeypatch.setattr(contact_store, "free_memory", lambda: 1e9)
    with pytest.raises(wk.InvalidInput, match=r"10000000 contacts take 1.79 GiB, and 0.931 GiB of memory are free"):
        beads(10**7, answers=kept)
    with pytest.raises(wk.InvalidInput, match="GiB"):
        array.add(10**7)
    assert array.size == 1000


# ---------------------------------------------------------------------------------------------------------------------
# files


@pytest.fixture
def saved(tmp_path):
    array = beads(30, precision="single", answers=("force", "dissipation"))
    depth, motion, *_ = history(2, 30, 4)
    for t in range(4):
        array.step(depth[t], motion=motion[t])
    return array, array.save(tmp_path / "run.contacts")


def test_contacts_go_on_from_a_file_with_the_same_numbers(saved, tmp_path):
    array, path = saved
    again = ContactArray.restored(BEADS, path)
    assert (again.size, again.precision, again.answers) == (30, "single", ("force", "dissipation"))
    depth, motion, *_ = history(12, 30, 3)
    for t in range(3):
        for one in (array, again):
            one.step(depth[t], motion=motion[t])
        for mine, true in zip(memory_of(again), memory_of(array), strict=True):
            assert mine.dtype == true.dtype
            assert np.array_equal(mine, true)
        assert np.array_equal(again.answer("dissipation"), array.answer("dissipation"))
    assert [file.name for file in tmp_path.iterdir()] == ["run.contacts"]


def test_files_that_are_broken_or_foreign_get_one_sentence(saved, tmp_path):
    _, path = saved
    whole = path.read_bytes()
    other = wk.Contacts.apart(GLASS, curvature_radius=2e-3, coefficient=0.3, reach=2e-6, count=8)

    def refused(content, match, law=BEADS):
        spoilt = tmp_path / "spoilt"
        spoilt.write_bytes(content)
        with pytest.raises(wk.InvalidInput, match=match) as error:
            ContactArray.restored(law, spoilt)
        assert "\n" not in str(error.value)

    refused(b"", "does not hold 'winkler contact array 1'")
    refused(b"depth,force\n1,2\n", "does not hold")
    refused(b"[" * 100_000, "does not hold")
    refused(whole[:-1], "bytes in place of")
    refused(whole + b"0", "bytes in place of")
    place = len(whole) // 2
    refused(whole[:place] + bytes([whole[place] ^ 1]) + whole[place + 1 :], "checksum")
    refused(whole.replace(b'"size": 30', b'"size": 1' + b"0" * 9, 1), "bytes in place of")
    refused(whole.replace(b'"size": 30', b'"size": -3', 1), "no size")
    refused(whole, "of another law", other)
    refused(whole, "of another law|no precision", PROBLEMS["ball"])
    with pytest.raises(wk.InvalidInput, match="nowhere"):
        ContactArray.restored(BEADS, tmp_path / "nowhere")
    with pytest.raises(wk.InvalidInput, match="cannot be written"):
        beads(2).save(tmp_path / "no folder" / "a")


# ---------------------------------------------------------------------------------------------------------------------
# words


def test_what_is_refused():
    array = beads(3)
    pairs = wk.Contacts.apart(GLASS, curvature_radius=[1e-3, 4e-3], coefficient=0.3, reach=2e-6)
    gel = PROBLEMS["gel"]
    for call, match in (
        (lambda: ContactArray(STEEL), "no contact law"),
        (lambda: ContactArray([]), "no law is given"),
        (lambda: ContactArray([BEADS, PROBLEMS["ball"]]), "law 1 has another form"),
        (lambda: ContactArray(pairs.moved([1e-6, 0.0])), "moved already"),
        (lambda: ContactArray(pairs, 3), "2 laws and 3 new contacts; give kind"),
        (lambda: ContactArray(pairs, 3, kind=[0, 1, 2]), "kind holds 2; give whole numbers from 0 to 1"),
        (lambda: beads(-1), "size"),
        (lambda: beads(2.5), "size"),
        (lambda: beads(2, kind=1), "one law"),
        (lambda: beads(precision="half"), "no precision 'half' here; give double or single"),
        (lambda: ContactArray(PROBLEMS["ball"], precision="single"), "give double"),
        (lambda: beads(answers=("forse",)), "no 'forse'.*force"),
        (lambda: array.answer("torqe"), "torque"),
        (lambda: array.step([1e-6, 0.0]), r"depth has the shape \(2,\); give \(3,\)"),
        (lambda: array.step(0.0, motion=np.zeros((2, 2))), r"motion has the shape \(2, 2\); give \(3, 2\)"),
        (lambda: array.step([0.0, math.nan, 0.0]), "depth is nan at contact 1"),
        (lambda: array.step(0.0, motion=[[0.0, 0.0], [0.0, math.inf], [0.0, 0.0]]), "motion is inf at contact 1"),
        (lambda: array.step("deep"), "holds what is no number"),
        (lambda: array.step(0.0, duration=1.0), "has no input duration; give depth, motion, twist, roll"),
        (lambda: array.step(1e61), "contact 0"),
        (lambda: ContactArray(gel, 2, count=4).step(0.0), "needs the duration"),
        (lambda: ContactArray(gel, 2, count=4).step(0.0, duration=[1.0, -1.0]), "duration is -1 at contact 1"),
        (lambda: ContactArray(gel, 2, count=4).step(0.0, duration=[1.0, 5e-324]), "duration is 4.9.*at contact 1"),
        (lambda: array.remove([3]), "which holds 3; give whole numbers from 0 to 2"),
        (lambda: array.remove([True, False]), r"which has the shape \(2,\) for 3 contacts"),
        (lambda: array.remove([0.5]), "whole numbers"),
        (lambda: array.renumber([0, 0]), "order holds 0 twice"),
        (lambda: array.renumber([-2]), "order holds -2"),
    ):
        with pytest.raises(wk.InvalidInput, match=match) as error:
            call()
        assert str(error.value).count(". ") == 0
    assert array.size == 3
    assert not np.any(array.memory("past"))
    with pytest.raises(ValueError, match="read-only"):
        array.answer("force")[0] = 1.0


# ---------------------------------------------------------------------------------------------------------------------
# all laws


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("name", PROBLEMS)
def test_each_contact_does_what_the_exported_law_does_alone(name):
    """The law alone is plain Python, of which other languages are written."""
    law = law_of(PROBLEMS[name], tolerance=1e-6, count=8)
    expected = law.trace()
    array = ContactArray(PROBLEMS[name], 3, count=8)
    found = []
    for given in entries(law.trial, law.motion, 3):
        array.step(**given)
        found.append(np.array([array.answer(number.name) for number in law.answer]))
    scale = np.max(np.abs(expected), axis=0)
    for k in range(3):
        off = np.abs(np.array(found)[:, :, k] - expected)
        assert np.all(off <= 1e-13 * scale), np.max(off, axis=0) / scale


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("name", PROBLEMS)
def test_no_law_answers_with_what_is_no_number(name):
    law = law_of(PROBLEMS[name], tolerance=1e-6, count=8)
    deepest = np.max(law.trial[:, 0])
    depths = [0.0, deepest, 5e-324, -5e-324, 1e-300, 0.0, -1e59, 1e-60, 1e-9 * deepest, -1e-30, deepest, deepest, -1e59]
    sizes = np.array([0.0, 5e-324, 1e-60, 1e-9, 1.0, 1e59])
    durations = np.where(sizes > 0.0, np.maximum(sizes, 1e-60), 0.0)
    array = ContactArray(PROBLEMS[name], sizes.size, count=8)
    for depth in depths:
        for word, size in (("motion", np.outer(sizes, [1.0, -1.0])), ("twist", sizes), ("duration", durations)):
            names = {WORDS.get(number.name, number.name): None for number in law.motion[1:]}
            taken = {key: size if key == word else 0.0 for key in names if not key.endswith("_y")}
            array.step(depth, **taken)
            for answer in array.names:
                assert np.all(np.isfinite(array.answer(answer))), (answer, depth, word)


HISTORIES, LEGS = 60, 6


def closed_paths(law, rng, many, parts):
    """Return paths, (steps, many, inputs), of straight legs in parts, which begin and end apart."""
    trial = law.trial
    names = [number.name for number in law.motion]
    deepest, widest = np.max(trial[:, 0]), np.abs(trial).max(axis=0)
    ends = rng.uniform(-0.3, 1.0, (LEGS + 2, many)) * deepest
    ends[0] = ends[-1] = -0.5 * deepest
    shares = np.arange(1, parts + 1) / parts
    depth = (ends[:-1, None] + np.diff(ends, axis=0)[:, None] * shares[:, None]).reshape(-1, many)
    path = np.zeros((depth.shape[0], many, len(names)))
    path[:, :, 0] = depth
    for place, number in enumerate(law.motion[1:], start=1):
        legs = rng.normal(size=(LEGS + 1, many)) * widest[place] / parts
        if number.changes:
            legs -= legs.mean(axis=0)  # the bodies return to where they were
        path[:, :, place] = np.repeat(np.abs(legs) if number.name == "duration" else legs, parts, axis=0)
    return path


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("name", PROBLEMS)
def test_closed_histories_create_no_energy(name):
    law = law_of(PROBLEMS[name], tolerance=1e-6, count=8)
    misses = []
    for parts in (96, 384):
        work, least, heat, scale = closed_work(name, law, HISTORIES, 7, parts)
        assert np.all(least >= -1e-14 * scale)
        misses.append(np.sqrt(np.mean(((work - heat) / scale) ** 2)))
    # trapeziums over steps within which edges jump and springs begin to slip; at each turn of the path the force of a
    # dashpot jumps, which they spread over a step: of the first order
    assert misses[1] < (3e-3 if name == "damped" else 3e-4)
    assert misses[1] < 0.5 * misses[0]


def closed_work(name, law, many, seed, parts):
    """Return the work of the forces (trapeziums), the least step of the heat, the heat, and its size."""
    path = closed_paths(law, np.random.default_rng(seed), many, parts)
    array = ContactArray(PROBLEMS[name], many, count=8)
    names = [number.name for number in law.motion]
    pairs = [("force", None)] + [
        (answer, names.index(word))
        for word, answer in (
            ("motion_x", "shear_x"), ("motion_y", "shear_y"), ("twist", "torque"), ("roll_x", "rolling_x"),
            ("roll_y", "rolling_y"),
        )
        if word in names
    ]  # fmt: skip
    work, scale, least, heat = np.zeros((4, many))
    before = {answer: np.zeros(many) for answer, _ in pairs}
    last = path[0, :, 0]
    for rows in path:
        array.step(
            **{
                WORDS.get(word, word): rows[:, place : place + 2] if word.endswith("_x") else rows[:, place]
                for place, word in enumerate(names)
                if not word.endswith("_y")
            }
        )
        for answer, place in pairs:
            moved = rows[:, 0] - last if place is None else rows[:, place]
            now = np.array(array.answer(answer))
            work += 0.5 * (before[answer] + now) * moved
            scale += np.abs(0.5 * (before[answer] + now) * moved)
            before[answer] = now
        last = rows[:, 0]
        if "dissipation" in array.names:
            least = np.minimum(least, array.answer("dissipation") - heat)
            heat = np.array(array.answer("dissipation"))
    if name == "gel":
        heat += array.answer("stored_energy")
    return work, least, heat, scale


@pytest.mark.parametrize("precision", ["half", None, ["double"]])
def test_a_file_of_an_unknown_precision_is_refused(tmp_path, precision):
    """It was read as double."""
    path = beads(2).save(tmp_path / "run.contacts")
    line, _, rest = path.read_bytes().partition(b"\n")
    line = json.dumps(json.loads(line) | {"precision": precision}).encode()
    path.write_bytes(line + b"\n" + rest)
    with pytest.raises(wk.InvalidInput, match=r"its first line states the precision "):
        ContactArray.restored(BEADS, path)
