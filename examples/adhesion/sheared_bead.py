r"""
Pushing a sticky bead sideways
==============================

A bead that sticks can be sheared without being pressed. The shear loads the same edge that the attraction holds, so
that it peels: the contact shrinks as the force grows, until it lets go at once. How much force it bears at most, and
how much less if somebody pulls on it at the same time?
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

RADIUS, WORK = 5e-6, 1e-3
gel = wk.HalfSpace.between(wk.Elastic(young=20e3, poisson=0.5))
bed = wk.Foundation(wk.Paraboloid(RADIUS), gel)
PULL = 1.5 * np.pi * WORK * RADIUS
"""The pull-off force."""

# %%
# Without load
# ------------
# The limit is :math:`3\pi w R\sqrt{G^*/E^*}`.

law = wk.ShortRange(WORK)
limit = wk.AdhesiveShear(bed, law, wk.Force(0.0), wk.ShearForce(0.0)).solve().limit
sheared = wk.AdhesiveShear(
    bed, law, wk.Force(0.0), wk.ShearForce(limit.shear_force * np.linspace(0.0, 0.999, 200))
).solve()
print(
    f"the bead bears {1e9 * limit.shear_force:.2f} nN, and lets go at a contact radius of {1e6 * limit.radius:.2f} µm"
)
assert np.isclose(limit.shear_force, 3 * np.pi * WORK * RADIUS * np.sqrt(gel.shear_modulus / gel.modulus), rtol=1e-9)

figure, (left, right) = plt.subplots(1, 2, figsize=(10.0, 4.0), layout="constrained")
left.plot(1e9 * sheared.shear_force, 1e6 * sheared.radius, label="contact radius a")
left.plot(1e9 * sheared.shear_force, 1e6 * sheared.shift, label="shift of the bead")
left.plot(1e9 * limit.shear_force, 1e6 * limit.radius, "o", color="C3", label="lets go")
left.set(xlabel="shear force [nN]", ylabel="length [µm]", title="no normal load", xlim=(0, None), ylim=(0, None))
left.legend(frameon=False)

# %%
# Pulled or pressed as well
# -------------------------

loads = np.linspace(-0.999, 2.0, 60)
most = [wk.AdhesiveShear(bed, law, wk.Force(f * PULL), wk.ShearForce(0.0)).solve().limit.shear_force for f in loads]
right.plot(loads, 1e9 * np.array(most))
right.axvline(-1.0, color="0.7", linestyle=":")
right.set(xlabel="normal load over pull-off force [-]", ylabel="greatest shear force [nN]", ylim=(0, None))
right.set_title("pulled (left), pressed (right)")
plt.show()
assert np.all(np.diff(most) > 0.0)
