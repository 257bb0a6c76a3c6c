"""
Answers for other programs
==========================

A ball of bearing steel on fused silica: its answers as a table, its stresses as a dataset and as a file for ParaView,
and its contact law as a look-up table for a discrete element or multibody code. Units travel with every number.
"""

import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk

holder = tempfile.TemporaryDirectory()  # put your own folder here
folder = Path(holder.name)

# %%
# Materials by name
# -----------------
# The table of materials lists typical numbers at room temperature, each with its source.

steel, silica = wk.material("bearing steel"), wk.material("fused silica")
for figure in silica.figures[:2]:
    print(f"{figure.quantity:8} {figure.number:10.4g}   {figure.source}")
bed = wk.Foundation(wk.Sphere(curvature_radius=3e-3), wk.HalfSpace.between(silica.elastic, steel.elastic))
loads = wk.Indentation(bed, wk.Force(np.geomspace(0.01, 10.0, 7))).solve()

# %%
# A table and a dataset
# ---------------------

table = wk.to_pandas(loads)
print(table[["force", "depth", "radius"]].to_string(float_format="{:.4g}".format))
print(table.attrs["units"])

contact = loads.at(6)
a = contact.radius
r, z = np.linspace(0.0, 2.0 * a, 61), np.linspace(0.02 * a, 2.0 * a, 61)
below = wk.restore(contact, r[:, None], z[None, :])
stresses = wk.to_xarray(below)
print(stresses.von_mises.attrs)

# %%
# The same field for ParaView, turned about the axis into a body
# ---------------------------------------------------------------

path = wk.write_vtk(below, folder / "below.vtk", around=24)
print(f"{path.name}: {path.stat().st_size / 1e6:.1f} MB")

# %%
# The contact law as a look-up table
# ----------------------------------
# Rows lie closer where the force bends more; the error between them is stated, for cubics and for straight lines.

law = wk.ContactLaw(bed, deepest=float(contact.depth), tolerance=1e-5).solve()
wk.write_law(law, folder / "ball.csv")
print(f"{law.depth.size} rows; cubics err by {law.hermite_error:.1e}, straight lines by at most {law.linear_error:.1e}")

figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
shown = left.contourf(stresses.r * 1e6, stresses.z * 1e6, stresses.von_mises.T * 1e-6, levels=12)
figure.colorbar(shown, ax=left, label="von Mises' stress [MPa]")
left.set(xlabel="distance from the axis r [µm]", ylabel="depth z [µm]", aspect="equal")
left.invert_yaxis()
right.plot(law.depth * 1e6, law.force, "o", label="rows of the table")
fine = np.linspace(0.0, law.depth[-1], 200)
right.plot(fine * 1e6, wk.Indentation(bed, wk.Depth(fine)).solve().force, label="the contact")
right.set(xlabel="depth d [µm]", ylabel="force F [N]")
right.legend()
plt.show()
