"""
What was done in a force curve
==============================

A file holds rows of position and force, rarely what the machine did in them. The events of a curve are found from its
points alone: loading, holds and unloadings, the points out of contact, snap-in and pull-off, sudden pop-ins, and what
disturbs: interference of light, a clock that differs between both signals, the drag of a liquid.

Both curves are played by closed forms, so that what happened in them is known.
"""

import numpy as np

import winkler as wk
from winkler.fitting.curves import corrections
from winkler.fitting.curves.events.found import interference_in
from winkler.plot import draw

random = np.random.default_rng(4)

# %%
# A ball on rubber, in and out, with reflected light
# --------------------------------------------------
#
# The ball of 5 µm radius is held for 0.4 s, in which the rubber relaxes by a tenth, and comes off at a tension of
# 2.4 nN.

leg = np.linspace(-2e-6, 1e-6, 600)
position = np.concatenate([leg, np.full(400, 1e-6), leg[::-1]])
time = 1e-3 * np.arange(position.size)
depth = np.maximum(position, 0.0)
force = 4.0 / 3.0 * 1.33e4 * np.sqrt(5e-6) * depth**1.5
force *= np.where(time < 0.6, 1.0, 0.9 + 0.1 * np.exp(-np.maximum(time - 0.6, 0.0) / 0.1))
sticking = (time > 1.0) & (position < 0.0) & (position > -0.3e-6)
force += sticking * 2.4e-9 * position / 0.3e-6
force += 2e-10 * np.cos(2.0 * np.pi * position / 350e-9) + 3e-11 * random.standard_normal(time.size)
ball = wk.ForceCurve(position, force, 0.05, time=time, name="ball on rubber")
print(ball)

# %%
# The same as a picture: the phases as bands, and the events where they happened.

draw(ball)

# %%
# The interference is fitted out of contact, and can be subtracted: in a study by ``correct = ["interference"]``.

found = interference_in(ball.record)
assert found is not None
period, error = 1e9 * found.period, 1e9 * found.period_error
print(f"period {period:.1f} +- {error:.1f} nm, amplitude {1e12 * found.amplitude:.0f} pN")
print(corrections.without_interference(ball, found).events.of("interference"))

# %%
# A nanoindenter drives the force, and a crystal yields in jumps
# --------------------------------------------------------------

load = np.linspace(0.0, 1.0, 800)
steps = ((0.12, 6e-9), (0.31, 11e-9), (0.52, 5e-9))
depth = 200e-9 * np.sqrt(load) + sum(size * (load > place) for place, size in steps)
out = depth[-1] - 25e-9 * (1.0 - np.linspace(1.0, 0.0, 400)[1:] ** (2.0 / 3.0))
depth = np.concatenate([depth, np.full(150, depth[-1]), out])
load = np.concatenate([load, np.ones(150), np.linspace(1.0, 0.0, 400)[1:]])
noise = 0.3e-9 * random.standard_normal(depth.size)
crystal = wk.ForceCurve(depth + noise, 2e-3 * load, time=0.01 * np.arange(depth.size), name="crystal")
for event in crystal.events.of("pop-in"):
    print(event)
draw(crystal)

# %%
# Where something is found wrongly, it is stated: ``crystal.with_events([("pop-in", 97, 97)])``, or in a study
# ``events = ["pop-in 0.97 s"]``.
