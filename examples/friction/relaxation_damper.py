"""
A shaken contact brakes
=======================

Nothing slides, and yet a motion along the surface is damped: while the depth oscillates, springs at the rim leave the
contact with the energy they hold, and come back without it. On the time scale of the slow motion the contact is a
dashpot. How strong is it, and when does it stop being one?
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

steel = wk.Elastic(young=210e9, poisson=0.3)
medium = wk.HalfSpace.between(steel, steel)
shapes = {"ball of 10 mm": wk.Paraboloid(10e-3), "cone, 85 degrees": wk.Cone(half_angle=np.radians(85))}
DEPTH, FREQUENCY = 2e-6, 20e3

# %%
# The dashpot, by how far the depth swings
# ----------------------------------------
# For small swings the coefficient grows with the swing and falls with the frequency. It depends on the shape at the rim
# only: on the slope of g where the contact ends.

swings = DEPTH * np.geomspace(0.01, 0.95, 40)
figure, (left, right) = plt.subplots(1, 2, figsize=(10.0, 4.0), layout="constrained")
for (name, shape), colour in zip(shapes.items(), ("C0", "C1"), strict=True):
    bed = wk.Foundation(shape, medium)
    damped = np.array([wk.RelaxationDamper(bed, DEPTH, swing, FREQUENCY).solve().damping for swing in swings])
    left.loglog(swings / DEPTH, damped, color=colour, label=name)
    small = wk.RelaxationDamper(bed, DEPTH, swings[0], FREQUENCY).solve()
    print(f"{name}: {small.damping:.3g} N s/m at a swing of {1e9 * swings[0]:.0f} nm")
    assert np.all(np.diff(damped) > 0.0)
left.set(
    xlabel="swing of the depth over the depth [-]", ylabel="damping [N s/m]", title=f"at {FREQUENCY / 1e3:.0f} kHz"
)
left.legend(frameon=False)

# %%
# Against a motion of the same frequency
# --------------------------------------
# If both motions have one frequency, the phase between them decides. In phase nothing is lost.

bed = wk.Foundation(shapes["ball of 10 mm"], medium)
phases = np.linspace(0.0, np.pi, 37)
for swing, colour in ((0.1, "C0"), (0.3, "C1")):
    lost = [
        wk.BimodalDamping(
            bed, wk.Coulomb(np.inf), depth=DEPTH, depth_amplitude=swing * DEPTH, shift_amplitude=0.1e-6, phase=phase
        )
        .solve()
        .loss_per_cycle
        for phase in phases
    ]
    right.plot(np.degrees(phases), 1e9 * np.array(lost), color=colour, label=f"{swing:g} of the depth")
    assert max(lost[0], lost[-1]) < 1e-3 * max(lost)
right.set(xlabel="phase [degrees]", ylabel="loss per cycle [nJ]", xlim=(0, 180), ylim=(0, None))
right.legend(frameon=False, title="swing of the depth")
plt.show()
