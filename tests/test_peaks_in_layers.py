"""The greatest stress in layered bodies: layer by layer, on both sides of each face, finite below smooth bodies."""

import numpy as np
import pytest

import winkler as wk
from winkler.fields.peaks import peak_stress
from winkler.plot.marks import Map, Rule
from winkler.plot.normal.stresses import stress_panel

STEEL, BALL = wk.Elastic(210e9, 0.3), wk.Paraboloid(1e-3)


def pressed(medium, force):
    return wk.Indentation(wk.Foundation(BALL, medium), wk.Force(force)).solve()


def coated(young, base, thickness=5e-6):
    return wk.CoatedHalfSpace([wk.Layer(wk.Elastic(young, 0.25), thickness)], on=wk.Elastic(base, 0.3))


@pytest.mark.slow
def test_the_surface_of_a_stiff_coating_has_no_apex_in_its_middle():
    """What the tables of layers leave of a slope at the axis is rounding: the stress there is finite."""
    contact = pressed(coated(300e9, 3e9), 1.0)
    on, below = wk.restore(contact, [0.0], [[0.0], [1e-9]]).von_mises.ravel()
    assert on == pytest.approx(below, rel=1e-3)
    assert below == pytest.approx(1.1168e9, rel=1e-3)


@pytest.mark.slow
@pytest.mark.parametrize("force", [1.0, 2.0])
def test_a_stiff_coating_on_a_polymer_is_stressed_finitely(force):
    """At 1 N `restore` gives 1.1168 GPa a nanometre below the middle; bending adds 4e-4 of it up to the surface."""
    contact = pressed(coated(300e9, 3e9), force)
    found = peak_stress(contact)
    assert found.z == 0.0
    assert found.r < 1e-3 * contact.radius
    near = float(wk.restore(contact, [0.0], [1e-9]).von_mises[0])
    assert near <= found.von_mises < 1.001 * near
    if force == 1.0:
        assert found.von_mises == pytest.approx(1.1168e9, rel=1e-3)


def test_the_lower_face_of_a_stiff_layer_is_found():
    """2.487 GPa at 5 um, inside the layer; below it the greatest is 2.476 GPa at 11 um."""
    contact = pressed(coated(450e9, 210e9), 5.0)
    found = peak_stress(contact)
    assert (found.r, found.z) == (0.0, 5e-6)
    assert found.von_mises == pytest.approx(2.487e9, rel=1e-4)
    assert float(wk.restore(contact, [0.0], [11e-6]).von_mises[0]) == pytest.approx(2.476e9, rel=1e-3)


STACKS = {
    "two layers": wk.CoatedHalfSpace(
        [wk.Layer(wk.Elastic(180e9, 0.22), 2e-6), wk.Layer(wk.Elastic(500e9, 0.21), 0.5e-6)], on=STEEL
    ),
    "soft on hard": coated(70e9, 400e9),
    "film that slides": wk.SlidingFilm([wk.Layer(wk.Elastic(100e9, 0.3), 5e-6)], on=STEEL),
    "rigid base": wk.CoatedHalfSpace([wk.Layer(STEEL, 2e-5)], on=wk.Rigid()),
}


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("name", STACKS)
def test_no_place_beside_a_face_is_stressed_more(name):
    contact = pressed(STACKS[name], 3.0)
    found = peak_stress(contact)
    faces = np.cumsum([layer.thickness for layer in STACKS[name].layers])
    z = np.unique(np.concatenate([[0.0], faces * (1.0 - 1e-9), faces, 0.5 * faces]))
    if not isinstance(STACKS[name].on, wk.Rigid):
        z = np.unique(
            np.concatenate([z, faces * (1.0 + 1e-9), faces[-1] + contact.radius * np.linspace(0.01, 1.0, 25)])
        )
    r = contact.radius * np.linspace(0.0, 1.2, 25)
    assert np.max(wk.restore(contact, r[:, None], z[None, :]).von_mises) <= found.von_mises * (1.0 + 1e-7)


@pytest.mark.slow
def test_a_pushed_contact_is_searched_on_both_sides_of_a_face():
    medium, law = coated(450e9, 210e9), wk.Coulomb(0.3)
    path = wk.Path(time=[0.0, 1.0], normal=wk.Force(np.array([5.0, 5.0])), lateral=wk.Shift([0.0, 1e-9]))
    state = wk.Tangential(wk.Foundation(BALL, medium), law, path).solve().at(1)
    found = peak_stress(state)
    z = np.array([0.0, 2.5e-6, 5e-6, 5e-6 * (1.0 + 1e-9), 8e-6, 11e-6, 14e-6])
    x = state.radius * np.linspace(-1.1, 1.1, 23)
    seen = wk.restore_body(state, x[:, None], 0.0, z[None, :]).von_mises
    assert np.max(seen) <= found.von_mises * (1.0 + 1e-6)
    assert found.z <= 5e-6


def test_the_picture_draws_each_layer_by_itself():
    """Contours do not cross the jump: it is marked, and each map ends at it."""
    contact = pressed(coated(450e9, 210e9), 5.0)
    panel = stress_panel(contact, 1.5 * contact.radius, contact.radius)
    upper, lower = (mark for mark in panel.marks if isinstance(mark, Map))
    assert np.max(upper.y) < 5e-6 < np.min(lower.y) < 5e-6 * (1.0 + 1e-6)
    assert upper.y.shape[1] >= 5
    assert (upper.place, lower.place) == ("inset", "")
    assert np.array_equal(upper.levels, lower.levels)
    assert 5e-6 in [mark.at for mark in panel.marks if isinstance(mark, Rule)]
