"""
A film that relaxes on a body that does not
===========================================

A ball is pressed into a film of rubber on an elastic body, held at its depth, and taken back. The film is stiffer than
its base at first and softer after all time, so that the equivalent profile changes: at one and the same depth the
contact widens. No body of one solid does that.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

film = wk.Prony(relaxed_shear=0.5e6, shears=[2e6, 1e6], relaxation_times=[0.02, 0.5], poisson=0.45)
base = wk.Elastic(young=6e6, poisson=0.49)
ball = wk.Paraboloid(10e-3)
THICKNESS, DEPTH = 100e-6, 20e-6
coated = wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(film, THICKNESS)], on=base)
figure, (left, right) = plt.subplots(1, 2, figsize=(10.0, 4.0), layout="constrained")

# %%
# Held at a depth
# ---------------
# Right after the step, and after all time, the body is an elastic stack.

time = np.geomspace(1e-4, 20.0, 30)
held = wk.RelaxationTest(wk.Foundation(ball, coated), DEPTH, time).solve()
first, last = (
    wk.Indentation(wk.Foundation(ball, each), wk.Depth(DEPTH)).solve() for each in (coated.glassy, coated.relaxed)
)
left.semilogx(time, 1e6 * held.radius)
for elastic, name, place, side in (
    (first, "elastic, at first", 20.0, "right"),
    (last, "elastic, after all time", 1e-4, "left"),
):
    left.axhline(1e6 * elastic.radius, color="0.6", linestyle="--")
    left.annotate(name, (place, 1e6 * elastic.radius), ha=side, va="bottom")
left.set(xlabel="time since the step [s]", ylabel="contact radius [µm]")
assert abs(held.radius[-1] / last.radius - 1.0) < 2e-3
print(f"at one depth the contact widens by {held.radius[-1] / held.radius[0] - 1.0:.0%}")

# %%
# In, hold, out
# -------------
# The base loses nothing: the thinner the film, the less is lost.

path = wk.Path([0.0, 0.1, 0.3, 0.4], wk.Depth([0.0, DEPTH, DEPTH, 0.0]))
times = np.concatenate([np.linspace(0.0, 0.1, 20), np.linspace(0.1, 0.3, 10)[1:], np.linspace(0.3, 0.4, 40)[1:]])
path = wk.Path(times, wk.Depth(np.interp(times, path.time, path.across)))
for thickness in (20e-6, THICKNESS, 1e-3):
    stack = wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(film, thickness)], on=base)
    loop = wk.ViscoelasticIndentation(wk.Foundation(ball, stack), path, count=120).solve()
    lost = loop.dissipation[-1] / loop.work.max()
    right.plot(1e6 * loop.depth, 1e3 * loop.force, label=f"{1e6 * thickness:g} µm: {lost:.0%} lost")
right.set(xlabel="depth [µm]", ylabel="force [mN]")
right.legend(frameon=False, title="film")
plt.show()
