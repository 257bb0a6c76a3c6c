r"""
Pressed and pushed at the same time
===================================

Friction remembers. The same load, 100 N across and 15 N along the surface, leads to three different shifts: when the
bodies are pressed first and pushed then, when both grow together, or when part of the pressing comes after the push.
And when both oscillate, what is lost in a cycle depends on the phase between them, most where nothing slides at all.
"""

import math

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

# %%
# Three paths to one load
# -----------------------

MU, ACROSS, ALONG = 0.3, 100.0, 15.0
steel = wk.Elastic(young=210e9, poisson=0.3)
medium = wk.HalfSpace.between(steel, steel)
bed = wk.Foundation(wk.Paraboloid(curvature_radius=10e-3), medium)
share = np.linspace(0.0, 1.0, 11)
paths = {
    "pressed, then pushed": (np.full(11, ACROSS), ALONG * share),
    "both together": (0.5 + (ACROSS - 0.5) * share, ALONG * share),
    "pressed to 60 N, pushed, pressed on": (
        np.concatenate([np.full(11, 60.0), 60.0 + (ACROSS - 60.0) * share[1:]]),
        np.concatenate([ALONG * share, np.full(10, ALONG)]),
    ),
}
figure, (left, right) = plt.subplots(1, 2, figsize=(10.5, 4.0), layout="constrained")
ends = []
for (name, (across, along)), colour in zip(paths.items(), ("C0", "C1", "C2"), strict=True):
    pushed = wk.Tangential(bed, wk.Coulomb(MU), wk.Path.through(wk.Force(across), wk.ShearForce(along))).solve()
    left.plot(pushed.shift * 1e9, pushed.shear_force, color=colour, label=name)
    left.plot(pushed.shift[-1] * 1e9, pushed.shear_force[-1], "o", color=colour)
    ends.append(float(pushed.shift[-1]))
    print(
        f"{name:40s} shift {pushed.shift[-1] * 1e9:7.2f} nm, stick radius {pushed.stick_radius[-1] * 1e6:6.1f} of "
        f"{pushed.radius[-1] * 1e6:.1f} um, lost {pushed.dissipation[-1] * 1e9:6.3f} nJ"
    )
left.set(xlabel="shift $u_x$ [nm]", ylabel="shear force $F_x$ [N]", title=f"paths to {ACROSS:g} N and {ALONG:g} N")
left.legend(frameon=False, fontsize="small", loc="lower right")

# %%
# The loss against the phase
# --------------------------
# Depth and shift oscillate with one frequency. In phase, within the cone of friction, nothing is lost. Without any
# sliding (an infinite coefficient) springs that part still lose what they hold: relaxation damping, :math:`\sin^2` of
# the phase. Finite coefficients come closer to it as they grow.

depth = wk.Indentation(bed, wk.Force(ACROSS)).solve().depth
phase = np.linspace(0.0, math.pi, 21)
shift = 0.15 * depth
for friction, colour in ((0.2, "C0"), (0.5, "C1"), (3.0, "C2"), (math.inf, "k")):
    swing = wk.BimodalDamping(bed, wk.Coulomb(friction), depth, 0.3 * depth, shift, phase).solve()
    name = "no sliding" if math.isinf(friction) else f"coefficient {friction:g}"
    right.plot(np.degrees(phase), swing.loss_per_cycle * 1e9, color=colour, label=name)
    top = int(np.argmax(swing.loss_per_cycle))
    print(f"{name:16s} loses most, {swing.loss_per_cycle[top] * 1e9:.3f} nJ, at {np.degrees(phase[top]):.0f} degrees")
right.set(xlabel="phase between shift and depth [°]", ylabel="loss per cycle [nJ]", title="both oscillate")
right.set(xlim=(0.0, 180.0), ylim=(0.0, None))
right.set_xticks([0, 45, 90, 135, 180])
right.legend(frameon=False, fontsize="small")
plt.show()

# %%
# Check
# -----
# Pressed first, then pushed: :math:`U = \mu (E^*/G^*)(d - d_c)`, where :math:`d_c` is the depth of the stick radius,
# under the force :math:`F - F_x/\mu`. Pressing on changes nothing of that. Both together, below the coefficient of
# friction: nothing slides, and the contact, which is narrow at first, yields more,
# :math:`U = (E^*/G^*)\,d\,F_x/F`. Relaxation in closed form.

ratio = medium.modulus / medium.shear_modulus
for end, force in ((ends[0], ACROSS), (ends[2], 60.0)):
    pressed, stuck = wk.Indentation(bed, wk.Force([force, force - ALONG / MU])).solve().depth
    assert np.isclose(end, MU * ratio * (pressed - stuck), rtol=1e-7)
assert np.isclose(ends[1], ratio * depth * ALONG / ACROSS, rtol=2e-2)
without = swing.loss_per_cycle
small = 16.0 / 3.0 * medium.shear_modulus * shift**2 * 0.3 * depth / (2.0 * math.sqrt(depth / 10e-3))
assert np.allclose(without, small * np.sin(phase) ** 2, rtol=1e-2, atol=1e-6 * small)
