r"""
Strips side by side
===================

A ground roller touches a flat on its crests, two rollers on one carrier share a load, and a punch with a groove presses
with four edges: sections that touch in several strips, which do not repeat. ``LineProfileContact`` finds the strips,
and how each of them presses on all others through the half-plane.
"""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

# %%
# Two rollers share a load
# ------------------------
# Each of two rollers side by side lies in the hollow of the other: beside a strip the surface sinks and tilts. They
# lean outwards, and touch in narrower strips than one roller alone under half of the load.

steel = wk.Elastic(young=210e9, poisson=0.3)
pair = wk.HalfSpace.between(steel, steel)
RADIUS, APART, LOAD = 10e-3, 0.5e-3, 200e3
rollers = wk.CylinderRow([RADIUS, RADIUS], [-0.5 * APART, 0.5 * APART], [0.0, 0.0])
both = wk.LineProfileContact(rollers, pair, wk.LineForce(LOAD)).solve()
alone = wk.LineIndentation(wk.LineFoundation(wk.Paraboloid(RADIUS), pair), wk.LineForce(0.5 * LOAD)).solve()
print(f"strips of {np.diff(both.edges)[0, 0] * 1e6:.1f} um, a roller alone {2e6 * alone.half_width:.1f} um")
print(f"greatest pressure {both.peak_pressure / 1e6:.1f} MPa, a roller alone {alone.peak_pressure / 1e6:.1f} MPa")
assert np.isclose(both.strip_forces.sum(), LOAD, rtol=1e-12)

draw(both)

# %%
# A load off the middle
# ---------------------
# On a carrier that is free to tilt, the strips take what balances the line of action of the force.

shifted = wk.LineProfileContact(rollers, pair, wk.LineForce(LOAD), wk.LineOfAction(0.1e-3)).solve()
share = shifted.strip_forces / LOAD
print(f"tilt {shifted.tilt * 1e3:.2f} mrad; the strips bear {100 * share[0]:.1f} and {100 * share[1]:.1f} %")
assert np.isclose(shifted.line_of_action, 0.1e-3, rtol=1e-10)

# %%
# A ground roller, as measured
# ----------------------------
# Crests bear first; as the load grows, strips appear, widen and merge.

here = Path(__file__).parent if "__file__" in globals() else Path.cwd()
trace = wk.read_section(here.parent / "data" / "ground_trace.csv", peak=True, curved=True)
loads = np.geomspace(2e3, 100e3, 12)
ground = wk.LineProfileContact(trace, pair, wk.LineForce(loads)).solve()
smooth = wk.LineIndentation(wk.LineFoundation(wk.Paraboloid(50e-3), pair), wk.LineForce(loads)).solve()
print("strips:", ", ".join(f"{count:.0f}" for count in ground.strip_count))
figure, axes = plt.subplots(layout="constrained")
axes.loglog(loads / 1e3, ground.contact_length * 1e6, label="ground, sum of the strips")
axes.loglog(loads / 1e3, 2e6 * smooth.half_width, "--", label="smooth")
axes.set(xlabel="force per length [N/mm]", ylabel="contact length [µm]")
axes.legend(frameon=False)

draw(ground.at(6))
plt.show()
