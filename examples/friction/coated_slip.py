r"""
Partial slip on a hard and on a soft coating
============================================

A ball is pressed on a coating and pushed along the surface. On a homogeneous half-space the difference of two normal
contacts solves that (Cattaneo, Mindlin, Jaeger, Ciavarella), since a stuck contact drags with the same distribution as
a flat punch presses. Layers answer to shear otherwise than to pressure: `Tangential` takes the kernels of the layers,
ring by ring; its method `SPRINGS` scales the normal solution. On a coating ten times as hard as its base the scaling is
wrong by a sixth of the friction.
"""

import matplotlib.pyplot as plt
import numpy as np

from winkler import (
    CoatedHalfSpace,
    Coulomb,
    Depth,
    Elastic,
    Foundation,
    Indentation,
    Layer,
    Method,
    Paraboloid,
    Path,
    Shift,
    Tangential,
    restore,
)

FRICTION, DEPTH = 0.3, 20e-9
layer = Layer(Elastic(young=100e9, poisson=0.3), thickness=3e-6)
figure, axes = plt.subplots(1, 3, figsize=(13.0, 4.8), layout="constrained")
missed = {}
for name, base, color in (("hard coating, base 10 GPa", 10e9, "C0"), ("soft coating, base 1000 GPa", 1e12, "C1")):
    bed = Foundation(Paraboloid(1e-3), CoatedHalfSpace([layer], on=Elastic(young=base, poisson=0.3)))
    contact = Indentation(bed, Depth(DEPTH)).solve()
    most = FRICTION * contact.force
    unit = most / float(bed.medium.punch_shear_stiffness(np.array([contact.radius]))[0])
    shift = np.linspace(0.0, 2.2 * unit, 34)
    path = Path(np.arange(34.0), Depth(np.full(34, DEPTH)), Shift(shift))
    right = Tangential(bed, Coulomb(FRICTION), path).solve()
    scaled = Tangential(bed, Coulomb(FRICTION), path, Method.SPRINGS).solve()
    axes[0].plot(shift / unit, right.shear_force / most, color=color, label=name)
    axes[0].plot(shift / unit, scaled.shear_force / most, "--", color=color, label="scaled normal solution")
    axes[1].plot(shift / unit, 100.0 * (scaled.shear_force - right.shear_force) / most, color=color, label=name)
    state = right.at(12)
    r = np.linspace(0.0, 0.999, 150) * contact.radius
    axes[2].plot(r / contact.radius, state.traction(r) / 1e6, color=color, label=f"traction, {name}")
    axes[2].plot(
        r / contact.radius, FRICTION * restore(contact, r).pressure / 1e6, ":", color=color, label="what friction bears"
    )
    missed[name] = float(np.max(np.abs(scaled.shear_force - right.shear_force)) / most)
axes[0].set(xlabel="shift over that of a stuck contact [-]", ylabel="shear force over coefficient times force [-]")
axes[1].set(xlabel="shift over that of a stuck contact [-]", ylabel="error of the scaled solution [%]")
axes[2].set(xlabel="distance from the axis over contact radius [-]", ylabel="traction [MPa]")
for panel in axes:
    panel.legend(fontsize="small", loc="lower center", bbox_to_anchor=(0.5, 1.0))

# %%
# By how much the scaling misses the shear force, in parts of the friction

for name, part in missed.items():
    print(f"{name:28s} {100.0 * part:.1f} %")
assert missed["hard coating, base 10 GPa"] > 0.1
plt.show()
