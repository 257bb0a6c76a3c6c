r"""
Dynamic mechanical analysis by indentation
==========================================

A flat punch is pressed into rubber, and shaken a little: the response of the contact in phase and a quarter of a turn
ahead gives storage and loss of the rubber,

.. math:: k' + \mathrm i k'' = 2aE^*(\mathrm i\omega) .

A machine sees three decades of frequency; temperature shifts all times by one factor, so that curves taken warm and
cold, moved sideways, make one master curve of a dozen decades.
"""

import matplotlib.pyplot as plt
import numpy as np

from winkler import (
    AtTemperature,
    Depth,
    FlatPunch,
    Foundation,
    FractionalZener,
    HarmonicIndentation,
    ViscoelasticHalfSpace,
    WilliamsLandelFerry,
)

PUNCH = 0.5e-3
rubber = FractionalZener(
    relaxed_shear=0.5e6, shear=300e6, relaxation_time=20e-6, exponent=0.6, shortest=1e-12, longest=1e4, tolerance=1e-3
)
law = WilliamsLandelFerry(reference_temperature=298.15, first_constant=8.86, second_constant=101.6)
omega = np.geomspace(1.0, 1e3, 16)

figure, (measured, master) = plt.subplots(1, 2, figsize=(10.5, 4.0), layout="constrained", sharey=True)
for number, celsius in enumerate((-20.0, -10.0, 5.0, 25.0, 60.0)):
    solid = AtTemperature(rubber, law, temperature=273.15 + celsius)
    bed = Foundation(FlatPunch(PUNCH), ViscoelasticHalfSpace(solid))
    shaken = HarmonicIndentation(bed, Depth(20e-6), omega).solve()
    # what a user of the machine does: moduli from stiffnesses, E* = 4 G of an incompressible solid
    storage, loss = shaken.storage_stiffness / (8.0 * PUNCH), shaken.loss_stiffness / (8.0 * PUNCH)
    assert np.allclose(storage, rubber.storage(omega * solid.factor), rtol=1e-6)
    assert np.allclose(loss, rubber.loss(omega * solid.factor), rtol=1e-6)
    colour = f"C{number}"
    measured.loglog(omega, storage / 1e6, "o-", color=colour, markersize=3, label=f"{celsius:.0f} °C")
    measured.loglog(omega, loss / 1e6, "s--", color=colour, markersize=3)
    master.loglog(omega * solid.factor, storage / 1e6, "o", color=colour, markersize=3)
    master.loglog(omega * solid.factor, loss / 1e6, "s", color=colour, markersize=3)

# %%
# Moved together
# --------------
# The lines are storage and loss of the rubber itself. Frequencies count as if all had been taken at 25 °C.

every = np.geomspace(1e-2, 1e10, 200)
master.loglog(every, rubber.storage(every) / 1e6, color="k", linewidth=0.8, zorder=3, label="storage")
master.loglog(every, rubber.loss(every) / 1e6, color="k", linewidth=0.8, zorder=3, linestyle="--", label="loss")
measured.set(xlabel="angular frequency [rad/s]", ylabel="shear modulus [MPa]", title="measured")
master.set(xlabel="angular frequency at 25 °C [rad/s]", title="master curve")
measured.set_ylim(bottom=2e-3)
measured.legend(frameon=False, loc="lower center", ncols=3)
master.legend(frameon=False)
plt.show()

worst = every[np.argmax(rubber.loss(every) / rubber.storage(every))]
print(f"the rubber damps best at {worst:.3g} rad/s at 25 degC")
