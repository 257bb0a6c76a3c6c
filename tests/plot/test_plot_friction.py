"""Pictures of contacts with friction: what they draw is what the answers say, and every axis has its unit."""

from __future__ import annotations

import dataclasses
import functools
import io
import math

import numpy as np
import pytest

import winkler as wk
from winkler.fields.restoration import restore, restore_body
from winkler.laws.friction import Coulomb
from winkler.loading.loads import Angle, Torque
from winkler.loading.path import Path
from winkler.plot import draw, style
from winkler.plot.friction.curves import loss_text
from winkler.problems.friction.bimodal_damping import BimodalDamping
from winkler.problems.friction.damping import FrictionDamping
from winkler.problems.friction.relaxation_damping import RelaxationDamper
from winkler.problems.friction.tangential import Tangential
from winkler.problems.friction.torsion import Torsion
from winkler.problems.impact.adhesive_impact import AdhesiveImpact
from winkler.problems.impact.impact import Impact

STEEL = wk.Elastic(210e9, 0.3)
PAIR = wk.HalfSpace.between(STEEL, STEEL)
BALL = wk.Foundation(wk.Paraboloid(10e-3), PAIR)
MU, DEPTH = Coulomb(0.3), 3.48e-6
MOST = 0.3 * DEPTH * PAIR.modulus / PAIR.shear_modulus
"""The shift at which all slides [m]."""
SOFT = wk.Foundation(wk.Paraboloid(1e-3), wk.HalfSpace.between(wk.Elastic(1e6, 0.5)))
SOIL = wk.Foundation(wk.Paraboloid(10e-3), wk.GradedHalfSpace.between(wk.PowerLawGraded(1e9, 1e-3, 0.3, 0.3)))
COAT = wk.Foundation(
    wk.Paraboloid(10e-3), wk.CoatedHalfSpace([wk.Layer(wk.Elastic(400e9, 0.2), 50e-6)], on=STEEL)
)  # fmt: skip
TURN = 2.0 * np.pi * np.linspace(0.0, 1.0, 33)
CIRCLE = 0.5 * MOST * np.stack([np.cos(TURN), np.sin(TURN)], axis=-1)


def pushed(bed=BALL, shifts=(0.0, 0.7, -0.5, 0.2), law=MU):
    path = Path(np.arange(float(len(shifts))), wk.Depth(DEPTH), wk.Shift(MOST * np.array(shifts)))
    return Tangential(bed, law, path).solve()


@functools.cache
def loop():
    return pushed()


@functools.cache
def turned():
    return Tangential(BALL, MU, Path(TURN, wk.Depth(DEPTH), wk.Shift(CIRCLE))).solve()


ITEMS = {
    "loop": (loop, 6),
    "path in the plane": (turned, 6),
    "forces": (
        lambda: Tangential(
            BALL, MU, Path([0.0, 1.0, 2.0], wk.Force([50.0, 100.0, 80.0]), wk.ShearForce([0.0, 20.0, -5.0]))
        ).solve(),
        6,
    ),
    "nothing slides": (lambda: pushed(law=Coulomb(math.inf)), 6),
    "no friction": (lambda: pushed(law=Coulomb(0.0)), 6),
    "flat punch": (
        lambda: Tangential(
            wk.Foundation(wk.FlatPunch(1e-3), PAIR), MU, Path([0.0, 1.0], wk.Force(100.0), wk.ShearForce([0.0, 20.0]))
        ).solve(),
        6,
    ),
    "graded": (lambda: pushed(SOIL), 6),
    "layered: no traction": (lambda: pushed(COAT), 3),
    "contact lost": (
        lambda: Tangential(BALL, MU, Path([0.0, 1.0], wk.Depth([DEPTH, -DEPTH]), wk.Shift([0.0, MOST]))).solve(),
        6,
    ),
    "never in contact": (lambda: Tangential(BALL, MU, Path([0.0], wk.Depth(-DEPTH))).solve(), 3),
    "state": (lambda: loop().at(2), 4),
    "state that slides": (lambda: pushed(shifts=(0.0, 2.0)).at(1), 4),
    "state at rest": (lambda: loop().at(0), 4),
    "state of a graded body": (lambda: pushed(SOIL).at(1), 3),
    "state apart": (lambda: Tangential(BALL, MU, Path([0.0], wk.Depth(-DEPTH))).solve().at(0), 1),
    "torsion": (
        lambda: Torsion(BALL, MU, Path([0.0, 1.0, 2.0], wk.Force(100.0), Angle([0.0, 2e-3, -1e-3]))).solve(),
        4,
    ),
    "pushed on a coating": (
        lambda: wk.Tangential(
            wk.Foundation(wk.Paraboloid(0.01), wk.CoatedHalfSpace([wk.Layer(STEEL, 1e-4)], on=wk.Elastic(70e9, 0.3))),
            MU,
            Path([0.0, 1.0], wk.Depth([DEPTH, DEPTH]), wk.Shift([0.0, 1e-7])),
        ).solve(),
        4,
    ),
    "torsion of a cone": (
        lambda: Torsion(
            wk.Foundation(wk.Cone(1.4), PAIR), MU, Path([0.0, 1.0], wk.Force(100.0), Torque([0.0, 1e-4]))
        ).solve(),
        4,
    ),
    "in the plane, one state": (lambda: turned().at(20), 4),
    "twist": (lambda: Torsion(BALL, MU, Path([0.0, 1.0], wk.Force(100.0), Torque([0.0, 1e-3]))).solve().at(1), 1),
    "damping": (lambda: FrictionDamping(BALL, MU, wk.Force(100.0), wk.ShearForce(np.array([5.0, 20.0]))).solve(), 3),
    "damping, one amplitude": (lambda: FrictionDamping(BALL, MU, wk.Depth(DEPTH), wk.Shift(3.0 * MOST)).solve(), 3),
    "damping at rest": (lambda: FrictionDamping(BALL, MU, wk.Depth(DEPTH), wk.Shift(0.0)).solve(), 3),
    "bimodal": (
        lambda: BimodalDamping(BALL, MU, DEPTH, 0.5 * DEPTH, 0.5 * MOST, np.linspace(0.0, 3.0, 4)).solve(),
        2,
    ),
    "bimodal, one phase": (lambda: BimodalDamping(BALL, MU, DEPTH, 0.2 * DEPTH, 0.5 * MOST, 1.0).solve(), 2),
    "bimodal, amplitudes": (
        lambda: BimodalDamping(BALL, MU, DEPTH, 0.2 * DEPTH, MOST * np.array([0.1, 0.5]), 1.0).solve(),
        2,
    ),
    "relaxation": (lambda: RelaxationDamper(BALL, DEPTH, 0.2 * DEPTH, 1e3).solve(), 1),
    "impact": (
        lambda: Impact(BALL, MU, 0.0327, 0.5, lateral_velocity=0.3, inertia=1.3e-6, lever=10e-3, count=41).solve(),
        4,
    ),
    "normal impact": (lambda: Impact(BALL, MU, 0.0327, 0.5, count=21).solve(), 4),
    "sticky impact": (lambda: AdhesiveImpact(SOFT, wk.ShortRange(0.05), 1e-6, 0.05, count=41).solve(), 4),
    "surface": (lambda: restore(loop().at(2), np.linspace(0.0, 3e-4, 30)), 2),
    "stress": (
        lambda: restore_body(loop().at(2), np.linspace(-1e-4, 1e-4, 9)[:, None], 0.0, np.array([[1e-5, 1e-4]])),
        1,
    ),
}  # fmt: skip


SLOW = ("path in the plane", "layered: no traction", "graded", "state of a graded body", "forces", "no friction",
        "nothing slides", "state at rest", "state that slides", "bimodal, one phase", "bimodal, amplitudes",
        "never in contact", "damping at rest", "torsion of a punch",
        "pushed on a coating", "in the plane, one state")  # fmt: skip
"""Variants of others, or pictures of answers that take long."""
MARKED = [
    pytest.param(name, marks=pytest.mark.slow if name in SLOW[::4] else pytest.mark.long) if name in SLOW else name
    for name in ITEMS
]


@pytest.mark.few(1, slow=4)
@pytest.mark.parametrize("name", MARKED)
def test_every_answer_has_a_picture(name):
    make, count = ITEMS[name]
    figure = draw(make())
    panels = [axes for axes in figure.axes if axes.get_title(loc="left")]
    assert len(panels) == count
    for axes in panels:
        labels = [axes.get_xlabel(), axes.get_ylabel()]
        assert all("[" in label for label in labels) or not axes.axison or "factor" in labels[1]
    if name in SLOW:
        figure.set_layout_engine("none")  # which takes two thirds of a drawing
        figure.savefig(io.BytesIO(), format="png", dpi=30)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("name", [name for name in ITEMS if name not in SLOW])
def test_every_other_picture_can_be_saved(name):
    figure = draw(ITEMS[name][0]())
    figure.set_layout_engine("none")
    figure.savefig(io.BytesIO(), format="png", dpi=30)


def texts(figure):
    return " ".join(text.get_text() for axes in figure.axes for text in axes.texts)


def titled(figure, word):
    return next(axes for axes in figure.axes if axes.get_title(loc="left").startswith(word))


def test_the_loop_is_that_of_the_answer():
    figure, item = draw(loop()), loop()
    line = next(line for line in titled(figure, "shear").lines if len(line.get_xdata()) == 4)
    np.testing.assert_allclose(np.asarray(line.get_ydata()), item.shear_force)
    np.testing.assert_allclose(np.asarray(line.get_xdata()) * 1e-9, item.shift)
    assert "lost along the path" in texts(figure)


def test_the_traction_stays_between_the_bounds():
    axes = titled(draw(loop()), "traction")
    curves = {line.get_label(): np.asarray(line.get_ydata(), dtype=float) for line in axes.lines}
    assert np.all(np.abs(curves[r"$\tau$"]) <= curves[r"$\pm\mu p$"] * (1.0 + 1e-9) + 1e-9)
    stick = float(loop().stick_radius[-1]) * 1e6
    edges = [patch.get_extents().transformed(axes.transData.inverted()).x1 for patch in axes.patches]
    assert edges == pytest.approx([stick])


@pytest.mark.slow
def test_springs_that_stick_differ_from_those_that_slide():
    def colours(state):
        axes = titled(draw(state), "springs")
        found = [
            tuple(np.round(colour[:3], 3))
            for item in axes.collections
            if hasattr(item, "get_segments")
            for colour in np.broadcast_to(item.get_color(), (len(item.get_segments()), 4))
        ]
        names = {tuple(np.round(_rgb(colour), 3)): colour for colour in (style.RED, style.GREEN, style.MUTED)}
        return [names[colour] for colour in found]  # fmt: skip

    partly, sliding = colours(loop().at(1)), colours(pushed(shifts=(0.0, 2.0)).at(1))
    assert {style.RED, style.GREEN, style.MUTED} == set(partly)
    assert {style.RED, style.MUTED} == set(sliding)
    assert partly == partly[::-1]
    touching = sum(colour != style.MUTED for colour in partly)
    assert touching == pytest.approx(len(partly) / 1.8, abs=1)  # the picture goes to 1.8 contact radii


def _rgb(colour):
    return [int(colour[k : k + 2], 16) / 255.0 for k in (1, 3, 5)]


@pytest.mark.slow
def test_the_greatest_stress_is_written():
    state = loop().at(1)
    peak = wk.peak_stress(state)
    text = texts(draw(state))
    assert f"greatest: {peak.von_mises / 1e6:.4g} MPa" in text


def test_no_loss_is_written_as_none():
    assert loss_text(1e-25, np.array([0.0, 1e-7]), np.array([0.0, 20.0])) == "nothing lost"
    assert loss_text(1e-9, np.array([0.0, 1e-7]), np.array([0.0, 20.0])) == "lost along the path: 1 nJ"


def test_the_loop_of_a_damper_encloses_its_loss():
    item = FrictionDamping(BALL, MU, wk.Depth(DEPTH), wk.Shift(1.5 * MOST)).solve()
    axes = titled(draw(item), "loop")
    x, y = axes.patches[0].get_xy().T
    area = 0.5 * abs(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]))
    units = {"nm": 1e-9, "µm": 1e-6, "mm": 1e-3}
    scale = units[axes.get_xlabel().partition("[")[2].rstrip("]")]
    assert axes.get_ylabel().endswith("[N]")
    assert area * scale == pytest.approx(float(item.loss_per_cycle), rel=1e-3)


@pytest.mark.slow
def test_curves_have_no_extent():
    with pytest.raises(wk.InvalidInput, match="no extent"):
        draw(loop(), extent=1e-3)
    with pytest.raises(wk.InvalidInput, match="extent"):
        draw(loop().at(1), extent=-1.0)
    state = loop().at(1)
    assert titled(draw(state, extent=5e-4), "traction").get_xlim() == pytest.approx((-500.0, 500.0), rel=1e-2)


def test_stresses_off_a_grid_are_refused():
    with pytest.raises(wk.InvalidInput, match="grid"):
        draw(restore_body(loop().at(1), np.linspace(0.0, 1e-4, 5), 0.0, 1e-5))


def test_pictures_change_nothing():
    item = loop()
    before = hash(dataclasses.replace(item))
    draw(item)
    assert hash(item) == before
