"""
A gel that relaxes: how many times does it take, and how sure are they?
=======================================================================

A bead of 5 um is pressed into a gel, held, and drawn out again. The force falls while it is held, and comes back below
itself on the return. Which moduli and which times does the curve give, and when should one stop adding times?

The curve of this example is made, not measured: a gel with two relaxation times on a cantilever of 50 mN/m, from a row
of springs. So the true answer is known.
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

TRUTH = wk.Prony(relaxed_shear=100.0, shears=[300.0, 200.0], relaxation_times=[0.05, 0.8])
SPRING = 0.05


def contact(solid, path):
    """The bead on a gel."""
    bed = wk.Foundation(wk.Paraboloid(5e-6), wk.ViscoelasticHalfSpace(solid))
    return wk.ViscoelasticIndentation(bed, path)


# %%
# The curve
# ---------
# One second in, four seconds held, and out again, a thousand points. The stage moves as far as the bead, and as the
# cantilever bends.

time = np.linspace(-0.5, 6.5, 1000)
depth = 1e-6 * np.where(time < 1.0, time, np.where(time < 5.0, 1.0, 6.0 - time))
force = contact(TRUTH, wk.Path(time, wk.Depth(depth))).solve().force
random = np.random.default_rng(1)
curve = wk.ForceCurve(
    position=depth + force / SPRING + 2.4e-6,
    force=force + 35e-12 + 10e-12 * random.standard_normal(time.size),
    machine_stiffness=SPRING,
    time=time + 0.5,
    direction=np.where(time < 1.0, 1, np.where(time < 5.0, 0, -1)),
    name="gel",
)

# %%
# One time, two, or three
# -----------------------
# The placeholder of the path says what drives: depths, and so the motion drives and forces are fitted. The name of a
# row means all of its numbers.

model = contact(wk.Prony(1e3, [1e3], [1.0]), wk.Path([0.0], wk.Depth(0.0)))
solid = "bed.medium.first."
free = [f"{solid}relaxed_shear", f"{solid}shears", f"{solid}relaxation_times", "contact_point", "baseline"]
found = wk.compare_terms(curve, model, free=free, most=3)
for name, fitted, evidence in zip(found.models, found.fits, found.evidence, strict=True):
    print(f"{name:8} misfit {fitted.scatter * 1e12:6.1f} pN, less likely than the best by {evidence:.1e}")
for sentence in found.refused:
    print(sentence)
assert found.models[0] == "2 terms"

# %%
# The numbers
# -----------
# Every number with its 95 % interval, beside the truth. The last panel shows the relaxation with its own interval, grey
# where the curve cannot determine it, and the two terms.

best = found.best
true_values = {
    f"{solid}relaxed_shear": 100.0,
    f"{solid}shears[0]": 300.0,
    f"{solid}shears[1]": 200.0,
    f"{solid}relaxation_times[0]": 0.05,
    f"{solid}relaxation_times[1]": 0.8,
}
for name, truth in true_values.items():
    low, high = best.interval(name)
    print(f"{name}: {best.value(name):.4g}, 95 %: {low:.4g} to {high:.4g}; true {truth:g}")
    assert abs(best.value(name) - truth) < 4.0 * best.error(name) + 1e-3 * truth
for flag in best.flags:
    print(flag)
draw(best)
plt.show()
