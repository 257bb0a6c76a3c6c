r"""
A cell that relaxes by a power of time
======================================

Cells soften as :math:`G(t)=G_0(t/t_0)^{-\alpha}`. Pressed with a bead and withdrawn at the same speed, such a cell lets
go early and leaves a loop in the force curve. While the bead goes in, the force is a closed form; on the return the
contact is as wide as it was at Ting's time :math:`t_1=t-2^{1/(1-\alpha)}(t-t_m)`.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.special import beta

from winkler import Depth, Foundation, Paraboloid, Path, PowerLawSolid, ViscoelasticHalfSpace, ViscoelasticIndentation

RADIUS, DEEPEST, SPEED, EXPONENT = 2.5e-6, 1e-6, 5e-6, 0.2
turn = DEEPEST / SPEED
cell = PowerLawSolid(shear=300.0, time_scale=1.0, exponent=EXPONENT, shortest=1e-5, longest=10.0)
bed = Foundation(Paraboloid(RADIUS), ViscoelasticHalfSpace(cell))
print(f"{cell.series.times.size} terms; the series is the power law to {cell.series_error:.1e}")

# %%
# Approach and retraction
# -----------------------

time = np.linspace(0.0, 2.0 * turn, 401)
depth = SPEED * np.where(time < turn, time, 2.0 * turn - time)
contact = ViscoelasticIndentation(bed, Path(time, Depth(depth))).solve()

inward = (time > 0.1 * turn) & (time <= turn)
factor = 2.0 * np.sqrt(RADIUS) * SPEED**1.5 * 4.0 * 300.0 * beta(1.0 - EXPONENT, 1.5)
assert np.allclose(contact.force[inward], factor * time[inward] ** (1.5 - EXPONENT), rtol=1e-3)
back = time[(time > turn) & (time < 1.2 * turn)]
same = back - 2.0 ** (1.0 / (1.0 - EXPONENT)) * (back - turn)
found = contact.radius[(time > turn) & (time < 1.2 * turn)]
assert np.allclose(found, np.sqrt(RADIUS * SPEED * same), rtol=2e-3)

figure, (forces, radii) = plt.subplots(1, 2, figsize=(10.5, 4.0), layout="constrained")
forces.plot(depth * 1e6, contact.force * 1e9)
forces.set(xlabel="depth [µm]", ylabel="force [nN]")
radii.plot(time, contact.radius * 1e6, label="contact radius")
radii.plot(back, np.sqrt(RADIUS * SPEED * same) * 1e6, "k--", label="Ting")
radii.set(xlabel="time [s]", ylabel="contact radius [µm]")
radii.legend(frameon=False)
plt.show()

# %%
# What the loop costs: most of the work is lost.

work = np.sum(0.5 * (contact.force[1:] + contact.force[:-1]) * np.diff(depth))
lost, stored = contact.dissipation[-1], contact.stored_energy[-1]
print(f"lost {lost:.3g} J, stored where the cell has not yet recovered {stored:.2g} J")
assert np.isclose(work, lost + stored, rtol=2e-3)
