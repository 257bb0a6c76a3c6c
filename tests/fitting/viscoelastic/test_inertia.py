"""The inertia of a probe: a flat punch on a standard solid, linear and therefore in closed form, driven to and fro."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

import winkler as wk

PUNCH, RELAXED, SHEAR, TIME = 1e-3, 1e4, 1e4, 0.05
CONTACT, BASELINE, MASS = 1e-5, 1e-5, 5e-3
SPEED, SCATTER, JITTER = 2e-5, 3e-6, 2e-9
DRIVEN = ((2e-6, 2.0 * np.pi * 4.0), (1e-6, 2.0 * np.pi * 10.0))
FIRST = "bed.medium.first."
FREE = {f"{FIRST}relaxed_shear": RELAXED, f"{FIRST}shear": SHEAR, f"{FIRST}relaxation_time": TIME,
        "contact_point": CONTACT, "baseline": BASELINE}  # fmt: skip


def motion(time):
    """d = v t + sum A (1 - cos w t) from touch on, its rate and its second derivative; free travel at v before."""
    after = np.maximum(time, 0.0)
    depth, rate, bent = SPEED * time, np.full(time.size, SPEED), np.zeros(time.size)
    for size, w in DRIVEN:
        depth = depth + size * (1.0 - np.cos(w * after))
        rate = rate + size * w * np.sin(w * after)
        bent = bent + np.where(time > 0.0, size * w**2 * np.cos(w * after), 0.0)
    return depth, rate, bent


def contact_force(time):
    """8 a int (G + g exp(-(t - s)/tau)) d'(s) ds, each term elementary."""
    t = np.maximum(time, 0.0)
    memory = SPEED * TIME * (1.0 - np.exp(-t / TIME))
    for size, w in DRIVEN:
        faded = np.sin(w * t) / TIME - w * np.cos(w * t) + w * np.exp(-t / TIME)
        memory = memory + size * w * faded / (TIME**-2 + w**2)
    return 8.0 * PUNCH * (RELAXED * np.maximum(motion(t)[0], 0.0) + SHEAR * memory)


def curve(seed, mass=MASS, spring=np.inf, count=400):
    """Newton: the spring bears the contact and the inertia, so that it shows F = F_c + m d''."""
    random = np.random.default_rng(seed)
    time = np.linspace(-0.3, 2.0, count)
    depth, rate, bent = motion(time)
    clean = contact_force(time)
    assert np.all(clean[time > 0.0] > 0.0)
    force = clean + mass * bent
    position = depth + CONTACT + force / spring + JITTER * random.standard_normal(count)
    force = force + BASELINE + SCATTER * random.standard_normal(count)
    return wk.ForceCurve(position, force, spring, time, np.sign(rate), f"seed {seed}")


def start():
    bed = wk.Foundation(wk.FlatPunch(PUNCH), wk.ViscoelasticHalfSpace(wk.StandardSolid(2e4, 5e3, 0.2)))
    return wk.ViscoelasticIndentation(bed, wk.Path([0.0], wk.Depth(0.0)))


def scores(seeds, free):
    rows = []
    for seed in seeds:
        found = wk.fit(curve(seed), start(), free=list(free))
        rows.append([(found.value(name) - truth, *found.interval(name)) for name, truth in free.items()])
    return np.array(rows)


@pytest.mark.slow
def test_numbers_hold_with_inertia_and_not_without():
    with_mass = FREE | {"inertia": MASS}
    rows = scores([0], with_mass)[0]
    for (off, low, high), name in zip(rows, with_mass, strict=True):
        assert abs(off) < 0.9 * (high - low), name
    assert abs(rows[1][0]) < 0.01 * SHEAR
    assert abs(rows[-1][0]) < 0.05 * MASS
    blind = wk.fit(curve(0), start(), free=list(FREE))
    assert blind.value(f"{FIRST}shear") < 0.95 * SHEAR
    assert "misfit" in [flag.name for flag in blind.flags]


@pytest.mark.long
def test_intervals_of_curves_with_inertia():
    free = FREE | {"inertia": MASS}
    rows = scores(range(1, 25), free)
    truth = np.array(list(free.values()))
    assert np.all(np.mean((rows[..., 1] <= truth) & (truth <= rows[..., 2]), axis=0) >= 0.8)
    assert np.all(np.abs(np.median(rows[..., 0], axis=0)) < 0.2 * np.median(rows[..., 2] - rows[..., 1], axis=0))


def test_acceleration_of_a_noisy_sinusoid_within_its_band():
    from winkler.fitting.viscoelastic.acceleration import tip_acceleration

    random, time, w = np.random.default_rng(5), np.linspace(0.0, 2.0, 2001), 2.0 * np.pi * 8.0
    depth = 1e-6 * np.sin(w * time)
    noisy = wk.ForceCurve(
        depth + 1e-9 * random.standard_normal(2001), np.sin(time), np.inf, time, np.sign(np.cos(w * time))
    )
    off = tip_acceleration(noisy) + w**2 * depth
    differences = np.diff(noisy.position, 2) / 1e-6 + (w**2 * depth)[1:-1]
    assert np.std(off[50:-50]) < 0.02 * w**2 * 1e-6
    assert np.std(differences) > 20.0 * np.std(off[50:-50])


@pytest.mark.parametrize(
    ("load", "uneven", "why"), [(wk.Force, False, "acts on the force"), (wk.Depth, True, "evenly")]
)
def test_inertia_that_cannot_be_found_is_refused(load, uneven, why):
    one = curve(0)
    hold = (
        one.chosen(np.arange(200) ** 2 // 200 + np.arange(200))
        if uneven
        else dataclasses.replace(one, direction=np.ones(400))
    )
    bed = start().bed
    with pytest.raises(wk.InvalidInput, match=why):
        wk.fit(hold, wk.ViscoelasticIndentation(bed, wk.Path([0.0], load(0.0))), free=[*FREE, "inertia"])
