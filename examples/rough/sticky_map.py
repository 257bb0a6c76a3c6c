r"""
A rough stamp snaps in and is torn off
======================================

A soft rough stamp is brought to a flat surface that attracts it, pressed on, and pulled off. Summits snap in
one after the other on the way there and hold longer on the way back. Between the branches lies the energy that
the jumps lose, and a smoother stamp holds harder.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

rubber = wk.HalfSpace(wk.Elastic(young=1e6, poisson=0.5))
law = wk.ExponentialAttraction(work=50e-3, range=0.8e-6)


def stamp(rms_height):
    spectrum = wk.SelfAffine(hurst=0.8, rms_height=rms_height, longest=0.2e-3, shortest=60e-6)
    return wk.random_topography(spectrum, (48, 48), lengths=(0.4e-3, 0.4e-3), seed=4)


def there_and_back(surface):
    """Return displacements from apart until the mean planes nearly meet, and back until all has come off."""
    pressed = float(np.mean(surface.gaps)) - 0.1e-6
    there, back = np.linspace(-2.5e-6, pressed, 8), np.linspace(pressed, -2.5e-6, 12)
    return wk.Depth(np.concatenate((there, back[1:])))


# %%
# One touch. Every jump is named: at which displacement, with which change of the force, at which loss.

rough = stamp(0.7e-6)
touch = wk.SurfaceAdhesion(rough, rubber, law, there_and_back(rough)).solve()
for jump in touch.jumps:
    kind = "snap-in " if jump.closing else "pull-off"
    print(
        f"{kind} near {jump.depth * 1e6:5.2f} um: {jump.force_before * 1e3:6.2f} to {jump.force_after * 1e3:6.2f} mN, "
        f"{jump.loss * 1e9:.3f} nJ lost"
    )
print(f"pull-off force {-touch.pull_off_force * 1e3:.2f} mN, lost in all {touch.dissipation[-1] * 1e9:.3f} nJ")
draw(touch)

# %%
# The same touch of a smoother stamp.

smooth = stamp(0.5e-6)
smoother = wk.SurfaceAdhesion(smooth, rubber, law, there_and_back(smooth)).solve()

figure, axes = plt.subplots(figsize=(6.5, 4.2), layout="constrained")
for loop, name in ((touch, "0.7 µm rms"), (smoother, "0.5 µm rms")):
    axes.plot(loop.depth * 1e6, loop.force * 1e3, marker=".", label=name)
axes.axhline(0.0, color="0.7", linewidth=0.8)
axes.set(xlabel="displacement d [µm]", ylabel="force F [mN]")
axes.legend(frameon=False, title="stamp")

plt.show()
