r"""
A bouncing ball with spin
=========================

Throw a rubber ball with backspin: it comes back. What turns it round is friction, and the springiness of the contact
*along* the surface. This page follows one impact from the inside, draws the law of reflection, lets a ball bounce with
spin, and ends with a grain of dust that does not bounce at all.
"""

import math

import matplotlib.pyplot as plt
import numpy as np

from winkler import AdhesiveImpact, Elastic, Foundation, HalfSpace, Impact, Paraboloid, ShortRange
from winkler.laws.friction import Coulomb

RADIUS, DENSITY = 0.02, 1100.0
mass = 4.0 / 3.0 * math.pi * RADIUS**3 * DENSITY
rubber = HalfSpace.between(Elastic(young=5e6, poisson=0.5))
bed = Foundation(Paraboloid(RADIUS), rubber)
solid = {"mass": mass, "inertia": 0.4 * mass * RADIUS**2, "lever": RADIUS}

# %%
# One impact
# ----------
# The ball comes down with 3 m/s and moves forwards with 2 m/s, without spin. The contact sticks at first, then slides
# at its edge, backwards, while the body still moves forwards: the springs along the surface swing back.

hit = Impact(bed, Coulomb(0.6), velocity=3.0, lateral_velocity=2.0, **solid).solve()
figure, (forces, radii) = plt.subplots(1, 2, figsize=(10.5, 4.2), layout="constrained")
forces.plot(hit.time * 1e3, hit.force, color="0.6", label="normal force")
forces.plot(hit.time * 1e3, hit.shear_force, color="C0", label="shear force")
forces.fill_between(hit.time * 1e3, -0.6 * hit.force, 0.6 * hit.force, color="C0", alpha=0.1, lw=0)
forces.set(xlabel="time t [ms]", ylabel="force [N]")
forces.legend(frameon=False)
radii.plot(hit.time * 1e3, hit.radius * 1e3, color="0.6", label="contact")
radii.plot(hit.time * 1e3, hit.stick_radius * 1e3, color="C0", label="sticks")
radii.set(xlabel="time t [ms]", ylabel="radius [mm]", ylim=(0, None))
radii.legend(frameon=False)
plt.show()
print(f"touches for {hit.duration * 1e3:.2f} ms, {hit.dissipation[-1] * 1e3:.1f} mJ are lost")
print(f"leaves with {hit.lateral_velocity[-1]:.3f} m/s and {hit.angular_velocity[-1]:.1f} rad/s")
assert np.allclose(hit.balance, 1.0, atol=1e-10)

# %%
# The law of reflection
# ---------------------
# Friction and velocities enter in one number, :math:`\psi=(G^*/E^*)\,w/(\mu v)`, of the sliding velocity w of the
# touching points. Steep impacts come back (:math:`\psi_2<0`); flat ones slide throughout, and lose :math:`4\chi`,
# :math:`\chi=\frac74 G^*/E^*`.

ratio = rubber.shear_modulus / rubber.modulus
coefficient, chi = 0.6, 1.75 * ratio
before = np.linspace(0.05, 6.0, 25)
unit = coefficient * 3.0 / ratio
after = [
    Impact(bed, Coulomb(coefficient), velocity=3.0, lateral_velocity=psi * unit, count=2, **solid)
    .solve()
    .sliding_velocity[-1]
    / unit
    for psi in before
]
figure, axes = plt.subplots(figsize=(6.5, 3.8), layout="constrained")
axes.plot(before, after, "o-", ms=3)
axes.plot(before, before - 4.0 * chi, color="0.6", lw=1, label=r"slides throughout, $\psi_1-4\chi$")
axes.axhline(0.0, color="0.8", lw=0.8, zorder=0)
axes.set(xlabel=r"$\psi_1$ of the approach", ylabel=r"$\psi_2$ of the rebound", ylim=(-2.0, 2.0))
axes.legend(frameon=False)
plt.show()
flat = before > 4.0 * chi - 1.0
assert np.allclose(np.array(after)[flat], before[flat] - 4.0 * chi, atol=1e-9)

# %%
# Thrown with backspin
# --------------------
# A rough ball with backspin turns round at the first bounce, its spin at the first and at the second. From then on its
# surface touches the ground almost at rest, and it rolls on from bounce to bounce. It flies under gravity; within an
# impact of milliseconds gravity plays no part.

GRAVITY = 9.81
place, along, spin, fall = 0.0, 1.0, -150.0, 3.0
paths = []
for _ in range(5):
    flight = np.linspace(0.0, 2.0 * fall / GRAVITY, 60)
    paths.append((place + along * flight, fall * flight - 0.5 * GRAVITY * flight**2))
    place += along * flight[-1]
    bounce = Impact(
        bed, Coulomb(3.0), velocity=fall, lateral_velocity=along, angular_velocity=spin, count=2, **solid
    ).solve()
    along, spin = float(bounce.lateral_velocity[-1]), float(bounce.angular_velocity[-1])
    print(f"at {place:+.2f} m: leaves with {along:+.2f} m/s, {spin:+.0f} rad/s")
figure, axes = plt.subplots(figsize=(7.5, 3.2), layout="constrained")
for number, (x, z) in enumerate(paths):
    axes.plot(x, z, color=plt.cm.viridis(number / len(paths)))
axes.set(xlabel="x [m]", ylabel="height [m]", ylim=(0, None))
plt.show()

# %%
# A grain that stays
# ------------------
# Small bodies stick. A silica grain of 1 µm leaves with :math:`e=\sqrt{1-(v_s/v)^2}`, and below :math:`v_s` not at all.

GRAIN, WORK = 0.5e-6, 0.05
silica = Elastic(young=70e9, poisson=0.17)
dust = Foundation(Paraboloid(GRAIN), HalfSpace.between(silica, silica))
weight = 4.0 / 3.0 * math.pi * GRAIN**3 * 2200.0
cost = 7.092195972 * (WORK**5 * GRAIN**4 / dust.medium.modulus**2) ** (1.0 / 3.0)
sticking = math.sqrt(2.0 * cost / weight)
speeds = sticking * np.array([0.6, 0.95, 1.05, 1.2, 1.5, 2.0, 3.0, 5.0])
bounces = [AdhesiveImpact(dust, ShortRange(WORK), weight, speed, count=3).solve() for speed in speeds]
figure, axes = plt.subplots(figsize=(6.5, 3.8), layout="constrained")
fine = np.linspace(1.0, 5.0, 400)
axes.plot(fine * sticking, np.sqrt(1.0 - 1.0 / fine**2), color="0.6", label=r"$\sqrt{1-(v_s/v)^2}$")
axes.plot(speeds, [bounce.restitution for bounce in bounces], "o", label="grain")
axes.set(xlabel="velocity v [m/s]", ylabel="restitution e", ylim=(-0.02, 1.02))
axes.legend(frameon=False)
plt.show()
print(f"below {sticking:.3f} m/s the grain stays")
assert [bounce.captured for bounce in bounces] == [True, True] + [False] * 6
assert np.isclose(bounces[-1].restitution, math.sqrt(1.0 - 1.0 / 25.0), rtol=1e-9)
