r"""
A glass bead sinks into a gel
=============================

A bead that lies on a gel sinks at once, then slowly, then flows. As long as its contact only grows, the elastic answer
stays true with the load replaced by its hereditary integral (Lee and Radok): with :math:`C(t)` the creep of the pair,

.. math:: a^3(t) = \tfrac34\,F R\,C(t) .

A gel that lets go of the bead again has another story, which the springs tell.
"""

import matplotlib.pyplot as plt
import numpy as np

from winkler import (
    Arrhenius,
    AtTemperature,
    CreepTest,
    Force,
    Foundation,
    GeneralisedKelvin,
    Paraboloid,
    Path,
    ViscoelasticHalfSpace,
    ViscoelasticIndentation,
)

RADIUS, WEIGHT = 1e-3, 0.2e-3
gel = GeneralisedKelvin(
    glassy_compliance=0.5e-3, compliances=[0.3e-3, 0.2e-3], retardation_times=[0.5, 20.0], fluidity=2e-7
)
law = Arrhenius(reference_temperature=293.15, activation_energy=60e3)

# %%
# At three temperatures
# ---------------------
# Warm, the same gel does the same things earlier: the law of Arrhenius multiplies all its times by one factor.

time = np.geomspace(0.01, 1000.0, 61)
figure, (sinking, loaded) = plt.subplots(1, 2, figsize=(10.5, 4.0), layout="constrained")
for celsius in (20.0, 30.0, 40.0):
    solid = AtTemperature(gel, law, temperature=273.15 + celsius)
    bed = Foundation(Paraboloid(RADIUS), ViscoelasticHalfSpace(solid))
    sunk = CreepTest(bed, WEIGHT, time).solve()
    assert np.allclose(sunk.radius**3, 0.75 * WEIGHT * RADIUS * 0.25 * solid.creep(time), rtol=1e-9)
    sinking.semilogx(time, sunk.depth * 1e6, label=f"{celsius:.0f} °C, $a_T$ = {solid.factor:.2f}")
sinking.set(xlabel="time [s]", ylabel="depth [µm]")
sinking.legend(frameon=False)

# %%
# Lifted off and put back
# -----------------------
# A minute of rest, most of the weight taken off for a minute, and put back. Where the contact shrinks the closed form
# ends; the springs go on, under forces with steps in time that are chosen by their error.

bed = Foundation(Paraboloid(RADIUS), ViscoelasticHalfSpace(gel))
stage = np.array([0.0, *np.geomspace(0.1, 60.0, 25)])
moments = np.concatenate([stage, 60.0 + stage, 120.0 + stage])
force = np.repeat([WEIGHT, 0.4 * WEIGHT, WEIGHT], stage.size)
rest = ViscoelasticIndentation(bed, Path(moments, Force(force)), count=150, tolerance=1e-6).solve()
stayed = CreepTest(bed, WEIGHT, moments[1:]).solve()
assert np.allclose(rest.depth[1:26], stayed.depth[:25], rtol=1e-3)

loaded.plot(rest.time, rest.depth * 1e6, label="lifted and put back")
loaded.plot(stayed.time, stayed.depth * 1e6, "k--", linewidth=1.0, label="had it stayed")
loaded.set(xlabel="time [s]", ylabel="depth [µm]", ylim=(0.0, None))
loaded.legend(frameon=False, loc="lower right")
plt.show()

light = rest.depth[27:52]
print(f"after a minute {rest.depth[25] * 1e6:.1f} um deep; the lighter bead rises to {light.min() * 1e6:.1f} um")
assert np.all(np.diff(light) < 0.0)
assert np.isclose(rest.depth[-1], stayed.depth[-1], rtol=0.02)
