"""
The contact of a relay
======================

A silver rivet is pressed on silver by a spring of a newton, and carries ten amperes. How large is its resistance, how
hot does it get, and when would it weld? Current has to squeeze through a spot sixty micrometres wide: that, not the
length of the rivet, is what it meets.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

silver = wk.Elastic(young=83e9, poisson=0.37)
rivet = wk.Foundation(wk.Paraboloid(curvature_radius=2e-3), wk.HalfSpace.between(silver, silver))
metal = wk.ElectricalConductor(resistivity=15.9e-9, temperature_coefficient=3.8e-3)
clean = wk.ElectricalConductors(metal, metal)

# %%
# Resistance against force
# ------------------------
# The springs in contact conduct side by side, so the resistance of clean metal goes like one over the radius of the
# contact, and that like the cube root of the force. A film of tarnish adds a resistance that goes like one over the
# area: light contacts are ruled by it.

force = np.geomspace(0.01, 20.0, 60)
figure, (left, right) = plt.subplots(1, 2, figsize=(10.5, 4.0), layout="constrained")
for area_resistance, colour in ((0.0, "C0"), (1e-13, "C1"), (1e-12, "C2")):
    pair = wk.ElectricalConductors(metal, metal, wk.SurfaceFilm(area_resistance))
    curve = wk.Constriction(wk.Indentation(rivet, wk.Force(force)), pair, mean_free_path=53e-9).solve()
    name = f"film of $10^{{{np.log10(area_resistance):.0f}}}$ Ω m²" if area_resistance else "clean"
    left.loglog(force, curve.resistance * 1e3, color=colour, label=name)
    power = np.polyfit(np.log(force), np.log(curve.resistance), 1)[0]
    at_one = np.interp(1.0, force, curve.resistance)
    print(f"{name:22s}: {at_one * 1e3:.3f} milliohm at 1 N, falling about like the force to the {-power:.2f}")
left.set(xlabel="force [N]", ylabel="resistance [mΩ]", title="three surfaces")
left.legend(frameon=False, fontsize="small")

# %%
# How hot it gets
# ---------------
# Temperature follows from the voltage over the contact alone, whatever its shape: heat runs along the lines of current.

law = wk.WiedemannFranz()
current = np.geomspace(1.0, 300.0, 25)
hot = [wk.JouleHeating(wk.Indentation(rivet, wk.Force(1.0)), clean, wk.Current(float(one))).solve() for one in current]
temperature = np.array([one.max_temperature for one in hot])
right.semilogx(current, temperature, color="C3", label="hottest place")
for name, kelvin in (("softens", 453.0), ("melts", 1235.0)):
    limit = law.voltage_at(kelvin)
    right.axhline(kelvin, color="0.6", linewidth=0.8)
    right.text(1.1, kelvin + 10.0, f"silver {name}: {limit:.2f} V", color="0.4")
right.set(xlabel="current [A]", ylabel="temperature [K]", title="clean contact under 1 N")
right.legend(frameon=False, loc="center left")
plt.show()

ten = wk.JouleHeating(wk.Indentation(rivet, wk.Force(1.0)), clean, wk.Current(10.0)).solve()
print(f"\n10 A: {ten.voltage * 1e3:.2f} mV, {ten.heat_rate * 1e3:.1f} mW, {ten.rise:.2f} K above its surroundings")
melting = wk.JouleHeating(wk.Indentation(rivet, wk.Force(1.0)), clean, wk.Voltage(law.voltage_at(1235.0))).solve()
print(f"it would melt at {melting.current:.0f} A, if it stayed as it is; softened silver yields, and the spot grows")

# %%
# Around the contact
# ------------------
# Current enters at the edge, where its density is infinite; temperature falls off within a few radii.

picture = draw(wk.JouleHeating(wk.Indentation(rivet, wk.Force(1.0)), clean, wk.Current(100.0)).solve())

# %%
# Check
# -----
# Where the resistivity goes like the absolute temperature, the resistance is v / atan(v) times the cold one.

like_temperature = wk.ElectricalConductor(15.9e-9, temperature_coefficient=1.0 / 293.15)
pair = wk.ElectricalConductors(like_temperature, like_temperature)
driven = wk.JouleHeating(wk.Indentation(rivet, wk.Force(1.0)), pair, wk.Voltage(0.2)).solve()
v = 0.2 / (2.0 * np.sqrt(law.lorenz_number) * 293.15)
assert np.isclose(driven.resistance / driven.cold_resistance, v / np.arctan(v), rtol=1e-12)
assert np.isclose(driven.max_temperature, 293.15 * np.hypot(1.0, v), rtol=1e-13)
