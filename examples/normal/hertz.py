"""
A steel ball on steel: Hertz
============================

The contact that everybody knows, as the first thing to check: force over depth, and the pressure in the contact,
against the formulas of Heinrich Hertz (1881). The formulas come from ``winkler.reference``, where closed solutions are
written as plain functions; the solver never sees them.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw
from winkler.reference.hertz import hertz_force, hertz_pressure
from winkler.reference.sphere import sphere_force
from winkler.values.validity import worst

# %%
# The bodies
# ----------
# A ball of 10 mm radius on a plate, both of steel. Two elastic half-spaces enter the normal problem with one number
# only, the effective modulus :math:`1/E^* = (1-\nu_1^2)/E_1 + (1-\nu_2^2)/E_2`.

RADIUS = 10e-3
steel = wk.Elastic(young=210e9, poisson=0.3)
medium = wk.HalfSpace.between(steel, steel)
bed = wk.Foundation(wk.Paraboloid(curvature_radius=RADIUS), medium)
print(f"effective modulus       {medium.modulus / 1e9:.2f} GPa")

# %%
# One force
# ---------
# A force of 100 N. ``draw`` shows all steps of the method: the ball in its dent, the equivalent plane profile
# :math:`g(x) = x^2/R` pressed into a row of springs, the load of the springs, and the pressure that belongs to it.

contact = wk.Indentation(bed, wk.Force(100.0)).solve()
print(f"depth                   {contact.depth * 1e6:.4f} um")
print(f"contact radius          {contact.radius * 1e6:.3f} um")
print(f"stiffness               {contact.stiffness / 1e6:.3f} N/um")

draw(contact)

# %%
# All forces
# ----------
# A load may be an array; the answer then has its shape. The points are :math:`F = 4E^*a^3/3R` and
# :math:`p = p_0\sqrt{1-r^2/a^2}` with :math:`p_0 = 2E^*a/\pi R`.

curve = wk.Indentation(bed, wk.Depth(np.linspace(0.0, 16e-6, 200))).solve()
marks = slice(10, None, 21)

figure, (left, right) = plt.subplots(1, 2, figsize=(9.0, 3.6), layout="constrained")
left.plot(curve.depth * 1e6, curve.force, label="winkler")
closed = hertz_force(curve.radius[marks], curvature_radius=RADIUS, modulus=medium.modulus)
left.plot(curve.radius[marks] ** 2 / RADIUS * 1e6, closed, "o", fillstyle="none", label="Hertz")
left.set(xlabel="depth d [µm]", ylabel="force F [N]", xlim=(0, 16), ylim=(0, None), title="force and depth")
left.legend(frameon=False)

for force, colour in ((100.0, "C0"), (300.0, "C1"), (900.0, "C2")):
    one = wk.Indentation(bed, wk.Force(force)).solve()
    r = np.linspace(0.0, 1.2 * one.radius, 241)
    pressure = wk.restore(one, r).pressure
    right.plot(r * 1e6, pressure / 1e9, color=colour, label=f"{force:.0f} N")
    points = r[::16]
    exact = hertz_pressure(points, one.radius, curvature_radius=RADIUS, modulus=medium.modulus)
    right.plot(points * 1e6, exact / 1e9, "o", fillstyle="none", color=colour)
right.set(xlabel="distance from the axis r [µm]", ylabel="pressure p [GPa]", title="pressure (points: Hertz)")
right.set(xlim=(0, None), ylim=(0, None))
right.legend(frameon=False)
plt.show()

# %%
# How exactly?
# ------------
# To the last digits of the machine, since for bodies of revolution the springs are no approximation.

exact = 4 / 3 * medium.modulus * np.sqrt(RADIUS * curve.depth[1:] ** 3)
force_error = np.max(np.abs(curve.force[1:] / exact - 1.0))
r = np.linspace(0.0, 0.999, 500) * contact.radius
exact = hertz_pressure(r, contact.radius, curvature_radius=RADIUS, modulus=medium.modulus)
pressure_error = np.max(np.abs(wk.restore(contact, r).pressure / exact - 1.0))
print(f"largest deviation of the force      {force_error:.1e}")
print(f"largest deviation of the pressure   {pressure_error:.1e}")
assert force_error < 1e-12
assert pressure_error < 1e-8

# %%
# A ball is no paraboloid
# -----------------------
# Hertz put a paraboloid in the place of the ball. ``Sphere`` is the true ball. At equal contact radius its force is
# :math:`F = E^*\left[\tfrac{R^2+a^2}{2}\ln\tfrac{R+a}{R-a} - aR\right]`; for :math:`a = R/2` that is 12 % more than
# Hertz. (No half-space is that small a body any more: ``validity`` says so.)

unit = wk.HalfSpace.between(wk.Elastic(young=1.0, poisson=0.0))
big = wk.Indentation(wk.Foundation(wk.Sphere(curvature_radius=1.0), unit), wk.Radius(0.5)).solve()
print(f"true ball, a = R/2: F = {big.force:.9f} E*R^2, Hertz {hertz_force(0.5, curvature_radius=1.0, modulus=1.0):.9f}")
print(f"how far to be trusted: {worst(big.validity).value}")
assert np.isclose(big.force, 0.186632680417569, rtol=1e-12)
assert np.isclose(big.force, sphere_force(0.5, curvature_radius=1.0, modulus=1.0), rtol=1e-12)
