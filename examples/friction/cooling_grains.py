"""
A box of grains that cools by friction
======================================

Nine hundred rubber balls of two sizes fly in a plane without an edge, strike and set each other spinning.
`ContactArray` holds the memory of all contacts and moves them in place: each has its own springs that stick and slip.
No energy is created or lost on the way: what the balls lose is heat of friction, contact by contact.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.spatial import cKDTree

import winkler as wk

# %%
# Three kinds of contacts
# -----------------------
# Small on small, small on large, large on large: 1/R = 1/R1 + 1/R2.

sizes = np.array([1.0e-3, 1.4e-3])  # m
rubber = wk.Elastic(young=10e6, poisson=0.45)
kinds = wk.Contacts.apart(
    wk.HalfSpace.between(rubber, rubber),
    curvature_radius=1.0 / (1.0 / sizes[[0, 0, 1]] + 1.0 / sizes[[0, 1, 1]]),
    coefficient=0.4,
    reach=0.4e-3,
    count=8,
)
contacts = wk.ContactArray(kinds, answers=("force", "shear_x", "stored_energy", "dissipation"))
print(f"{contacts.bytes_for(10_000_000) / 2**30:.2f} GiB for ten million contacts")

rng = np.random.default_rng(5)
side, many = 30, 900
box = side * 3.2e-3
places = (np.stack(np.divmod(np.arange(many), side), axis=1) + 0.5) * 3.2e-3
large = rng.random(many) < 0.5
radius = sizes[large.astype(int)]
mass = 1100.0 * 4.0 / 3.0 * np.pi * radius**3
inertia = 0.4 * mass * radius**2
velocity = rng.normal(scale=1.0, size=(many, 2))
velocity -= np.average(velocity, axis=0, weights=mass)
spin = np.zeros(many)

# %%
# Neighbours
# ----------
# Every now and then a new list is made of the pairs that may touch. `renumber` takes for each of them the place that it
# had in the former list, -1 for a new one, and its memory goes with it.


def new_list(old):
    pairs = cKDTree(places % box, boxsize=box).query_pairs(2.0 * sizes[1] + SKIN, output_type="ndarray")
    found = pairs[:, 0] * many + pairs[:, 1]  # one number for a pair; i < j
    former = np.full(len(found), -1)
    if len(old):
        where = np.minimum(np.searchsorted(old, np.sort(found)), len(old) - 1)
        former = np.where(old[where] == np.sort(found), where, -1)
    found = np.sort(found)
    i, j = np.divmod(found, many)
    fresh = former < 0
    contacts.renumber(former, kind=(large[i] * 1 + large[j])[fresh])
    return found, i, j


def forces(step):
    apart = places[j] - places[i]
    apart -= box * np.round(apart / box)
    distance = np.hypot(*apart.T)
    normal = apart / distance[:, None]
    along = np.stack([-normal[:, 1], normal[:, 0]], axis=1)
    sliding = np.sum((velocity[j] - velocity[i]) * along, axis=1) - radius[i] * spin[i] - radius[j] * spin[j]
    motion = np.zeros((len(i), 2))
    motion[:, 0] = step * sliding
    contacts.step(radius[i] + radius[j] - distance, motion=motion)
    force, shear = contacts.answer("force"), contacts.answer("shear_x")
    pushed = -force[:, None] * normal + shear[:, None] * along  # on the first of each pair
    total, torque = np.zeros((many, 2)), np.zeros(many)
    np.add.at(total, i, pushed)
    np.add.at(total, j, -pushed)
    np.add.at(torque, i, radius[i] * shear)
    np.add.at(torque, j, radius[j] * shear)
    pressed = np.maximum(radius[i] + radius[j] - distance, 0.0)
    return total / mass[:, None], torque / inertia, 0.4 * np.sum(force * pressed)


# %%
# Steps of Verlet
# ---------------

SKIN, STEP, STEPS = 0.4e-3, 5e-6, 1800
keys, moved, forgotten = np.zeros(0, dtype=int), np.inf, 0.0
rows = []
for number in range(STEPS):
    if moved > 0.5 * SKIN:
        heat_before = np.sum(contacts.answer("dissipation"))
        keys, i, j = new_list(keys)
        forgotten += heat_before - np.sum(contacts.answer("dissipation"))  # heat of pairs that left the list
        moved = 0.0
        acceleration, turning, _ = forces(0.0)
    velocity += 0.5 * STEP * acceleration
    spin += 0.5 * STEP * turning
    places += STEP * velocity
    moved += STEP * np.max(np.hypot(*velocity.T))
    acceleration, turning, pressed = forces(STEP)
    velocity += 0.5 * STEP * acceleration
    spin += 0.5 * STEP * turning
    if number % 10 == 0:
        flying = 0.5 * np.sum(mass * np.sum(velocity**2, axis=1))
        heat = forgotten + np.sum(contacts.answer("dissipation"))
        stored = pressed + np.sum(contacts.answer("stored_energy"))
        rows.append([number * STEP, flying, 0.5 * np.sum(inertia * spin**2), stored, heat])

time, flying, spinning, stored, heat = np.transpose(rows)
total = flying + spinning + stored + heat
print(f"{contacts.size} pairs in the last list; kinetic energy {flying[0] * 1e3:.2f} to {flying[-1] * 1e3:.2f} mJ")
print(f"heat {heat[-1] * 1e3:.3f} mJ; the sum of all energies is within {np.ptp(total) / total[0]:.1e}")

# %%
# Where the energy goes
# ---------------------

figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4.2), layout="constrained")
left.stackplot(
    time * 1e3,
    np.array([flying, spinning, stored, heat]) * 1e3,
    labels=["flight", "spin", "elastic", "heat of friction"],
)
left.set(xlabel="time / ms", ylabel="energy / mJ")
left.legend(loc="lower left")
middle = places % box * 1e3
speed = np.hypot(*velocity.T)
dots = right.scatter(*middle.T, s=18.0 * (radius / sizes[0]) ** 2, c=speed, cmap="viridis")
touching = contacts.answer("force") > 0.0
for first, second in zip(i[touching], j[touching], strict=True):
    if np.max(np.abs(middle[first] - middle[second])) < 5.0:
        right.plot(*np.stack([middle[first], middle[second]]).T, color="crimson", linewidth=1.5)
right.set(xlabel="x / mm", ylabel="y / mm", aspect="equal")
figure.colorbar(dots, ax=right, label="speed / (m/s)")
plt.show()
