"""
A sticky gel: from a force curve to modulus and work of adhesion
================================================================

A glass ball of 5 um on a soft cantilever touches a gel and is pulled off again. Which model does the curve speak for,
what are the numbers, and how sure are they?

The curve of this example is made, not measured: JKR with a modulus of 10 kPa and a work of adhesion of 0.1 mJ/m^2, on
a cantilever of 50 mN/m, with noise that remembers. So the true answer is known.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.fitting.compare import compare
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.elastic.response import response
from winkler.fitting.intervals import profile_interval
from winkler.laws.adhesion import DerjaguinMullerToporov, ShortRange
from winkler.problems.adhesion.indentation import AdhesiveIndentation
from winkler.problems.adhesion.law_states import states_of

YOUNG, WORK, SPRING = 10e3, 0.1e-3, 0.05


def bed(young):
    """The ball over a gel."""
    return wk.Foundation(wk.Sphere(5e-6), wk.HalfSpace.between(wk.Elastic(young, 0.5)))


# %%
# The curve
# ---------
# The stage moves in and out; the ball snaps in at first touch and comes off where the cantilever can no longer hold it.

stage = np.linspace(-1e-6, 1.2e-6, 600)
contact = response(states_of(bed(YOUNG), ShortRange(WORK)), 1.0 / SPRING, stage.max())
inward = np.where(stage >= 0.0, contact.closing(stage).force, 0.0)
outward = np.where(stage >= contact.loss()[0], contact.opening(stage, stage.max()).force, 0.0)

random = np.random.default_rng(5)
noise = np.zeros(1200)
for i in range(1, 1200):
    noise[i] = 0.6 * noise[i - 1] + 0.8 * 60e-12 * random.standard_normal()
curve = ForceCurve(
    position=np.concatenate([stage, stage[::-1]]) + 3.4e-6,
    force=np.concatenate([inward, outward[::-1]]) + 0.2e-9 + noise,
    machine_stiffness=SPRING,
    name="gel",
)

# %%
# Three models
# ------------
# All begin a hundred times too stiff, and with no idea of the contact point.

soft = ["bed.medium.first.young", "contact_point", "baseline"]
found = compare(
    curve,
    {
        "Hertz": (wk.Indentation(bed(1e6), wk.Depth(0.0)), soft),
        "JKR": (AdhesiveIndentation(bed(1e6), ShortRange(0.01), wk.Depth(0.0)), [*soft, "law.work"]),
        "DMT": (AdhesiveIndentation(bed(1e6), DerjaguinMullerToporov(0.01), wk.Depth(0.0)), [*soft, "law.work"]),
    },
)
for name, fitted, evidence in zip(found.models, found.fits, found.evidence, strict=True):
    print(f"{name:6} misfit {fitted.scatter * 1e12:6.1f} pN, less likely than the best by {evidence:.1e}")
assert found.models[0] == "JKR"

# %%
# The numbers
# -----------
# The noise remembers its past, so that the 1200 points are worth about 300: the errors know that. Intervals by the
# profile of the likelihood agree with those by error propagation here, because so many points leave little freedom.

best = found.best
print(f"{best.effective_count:.0f} independent points of {best.curve.count}")
for name, unit, scale in (("bed.medium.first.young", "kPa", 1e-3), ("law.work", "mJ/m^2", 1e3)):
    low, high = (scale * end for end in profile_interval(best, name))
    print(f"{name}: {scale * best.value(name):.4g} {unit}, 95 %: {low:.4g} to {high:.4g}")
for flag in best.flags:
    print(flag)
assert abs(best.value("bed.medium.first.young") - YOUNG) < 4.0 * best.error("bed.medium.first.young")
assert abs(best.value("law.work") - WORK) < 4.0 * best.error("law.work")

figure, (above, below) = plt.subplots(2, 1, figsize=(7.0, 5.5), sharex=True, height_ratios=(3, 1), layout="constrained")
place = (curve.position - best.value("contact_point")) * 1e6
above.plot(place, curve.force * 1e9, ".", color="0.7", markersize=3, label="measured")
for name, color in (("Hertz", "C1"), ("DMT", "C2"), ("JKR", "C0")):
    fitted = found.fits[found.models.index(name)]
    above.plot(place, fitted.predicted * 1e9, color=color, label=name)
    below.plot(place, fitted.residuals * 1e9, color=color, linewidth=0.8)
above.set(ylabel="force [nN]")
above.legend(frameon=False)
below.set(xlabel="position from first touch [µm]", ylabel="misfit [nN]")
plt.show()
