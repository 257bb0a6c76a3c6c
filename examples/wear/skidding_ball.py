r"""
A skidding ball
===============

A ball of a bearing that does not turn skids along the groove of its ring. The contact is an ellipse, nine times as long
across the groove as along it. What does the ball lose, and how deep is the track that it leaves?
"""

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import draw

# %%
# One metre along the groove
# --------------------------
# The ball is the first body: the contact stays where it is on the ball. The ring is 26 mm in radius, and so a metre is
# six times around. The ball is harder than the ring, and wears a hundred times slower.

steel = wk.Elastic(young=208e9, poisson=0.3)
ball_in_groove = wk.CurvedPair(5e-3, 5e-3, 26e-3, -5.2e-3)
ball, ring = 1e-17, 1e-15
skidding = wk.EllipticWear(
    ball_in_groove,
    wk.HalfSpace.between(steel, steel),
    wk.PairWear(wk.Archard(ball), wk.Archard(ring)),
    wk.Force(50.0),
    distance=1.0,
    passes=1.0 / (2.0 * np.pi * 26e-3),
)
worn = skidding.solve()
draw(worn)
print(f"ball: {1e9 * worn.worn_depth:.1f} nm deep; track: {1e9 * worn.track_depth:.2f} nm deep")
print(f"that is {100 * worn.worn_share:.2g} % of the approach")

# %%
# The section of the track
# ------------------------
# The pressure is a half-ellipsoid, and its projection along the sliding a parabola: narrow and deep across the groove,
# wide and shallow along it. The section, :math:`n\kappa F`, is the same in all directions.

figure, axes = plt.subplots(figsize=(6.0, 3.6), layout="constrained")
for degrees in (0, 60, 90):
    turned = wk.EllipticWear(
        ball_in_groove, skidding.medium, skidding.wear, skidding.load, 1.0, np.radians(degrees), skidding.passes
    ).solve()
    t = np.linspace(-1.2, 1.2, 241) * turned.track_half_width
    axes.plot(1e6 * t, -1e9 * turned.track(t), label=f"{degrees} degrees to the groove")
    assert np.isclose(turned.track_area, skidding.passes * ring * 50.0, rtol=1e-12)
axes.set(xlabel="across the sliding [µm]", ylabel="surface of the ring [nm]")
axes.legend()
plt.show()
