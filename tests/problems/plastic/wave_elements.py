"""Finite elements of perfectly plastic half-spaces under any contact of two symmetries, small strains, no friction.

Bricks with the mean dilatation of Hughes (B-bar) stand on an even grid along the surface and on a graded one below it.
The elastic part of the equations is solved wave by wave, with one column of blocks for each; plastic strains, by von
Mises' condition and radial return, are forces on it. The nodal pressures follow by Polonsky and Keer's gradients, and
both together by Anderson's acceleration. Nothing of it is shared with `finite_elements`. Four nodes across are enough
for plane strain.
"""

import numpy as np
from numba import njit
from scipy.fft import irfft2, rfft2

CORNERS = np.array([(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)], dtype=float)
REMEMBERED, MOST_TURNS, LEFT = 8, 200, 2e-3


def _strain_matrices(steps):
    """Strains xx, yy, zz, xy, yz, xz (engineering) at eight places by 24 displacements, and their weight."""
    found = np.zeros((8, 6, 24))
    for q, place in enumerate(CORNERS / np.sqrt(3.0)):
        shape, half = 0.5 * (1.0 + CORNERS * place), 0.5 * CORNERS
        slope = np.stack([half[:, i] * shape[:, (i + 1) % 3] * shape[:, (i + 2) % 3] for i in range(3)], 1)
        slope *= 2.0 / np.array(steps)
        for i in range(3):
            found[q, i, i::3] = slope[:, i]
        for row, (i, j) in enumerate(((0, 1), (1, 2), (0, 2)), 3):
            found[q, row, i::3], found[q, row, j::3] = slope[:, j], slope[:, i]
    dilatation = found[:, :3].sum(1)
    found[:, :3] += ((dilatation.mean(0) - dilatation) / 3.0)[:, None]
    return found, np.prod(steps) / 8.0


@njit(cache=True)
def _columns(inverse, lower, force):
    """Solve block-tridiagonal columns (levels, waves, 3, 3) for forces (levels, 3, waves), in their place."""
    levels, waves = inverse.shape[:2]
    rest = np.empty(3, dtype=np.complex128)
    for k in range(waves):
        for turn in range(2 * levels - 1):
            j = turn if turn < levels else 2 * levels - 2 - turn
            for i in range(3):
                rest[i] = force[j, i, k] if turn < levels else 0.0
                for m in range(3):
                    if turn >= levels:
                        rest[i] += np.conj(lower[j + 1, k, m, i]) * force[j + 1, m, k]
                    elif j > 0:
                        rest[i] -= lower[j, k, i, m] * force[j - 1, m, k]
            for i in range(3):
                moved = inverse[j, k, i, 0] * rest[0] + inverse[j, k, i, 1] * rest[1] + inverse[j, k, i, 2] * rest[2]
                force[j, i, k] = moved if turn < levels else force[j, i, k] - moved


class Body:
    """A half-space; `steps` along x and y, `waves` the nodes along both, `levels` the depths of the layers, and `box`
    where it may yield: along x, along y, below."""

    def __init__(self, steps, waves, levels, box, young, poisson, strength):
        self.waves, self.strength = waves, strength
        self.shear = 0.5 * young / (1.0 + poisson)
        self.law = np.zeros((6, 6))
        self.law[:3, :3] = young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson))
        self.law += np.diag([2.0 * self.shear] * 3 + [self.shear] * 3)
        self.nx, self.ny = (int(np.ceil(size / step - 1e-9)) for size, step in zip(box, steps, strict=False))
        self.nz = int(np.searchsorted(levels, box[2]))
        along, across = 2.0 * np.pi * np.fft.fftfreq(waves[0])[:, None], 2.0 * np.pi * np.fft.rfftfreq(waves[1])[None]
        count = waves[0] * across.size
        diagonal, lower = (np.zeros((len(levels), count, 3, 3), complex) for _ in range(2))
        phase = [np.exp(1j * (along * (c[0] > 0) + across * (c[1] > 0))).ravel() for c in CORNERS]
        self.strains, self.weights = [], []
        for level, thick in enumerate(np.diff(levels)):
            strain, weight = _strain_matrices((*steps, thick))
            self.strains.append(strain)
            self.weights.append(weight)
            stiff = weight * np.einsum("qij,ik,qkl->jl", strain, self.law, strain)
            for a in range(8):
                for b in range(8):
                    block = (np.conj(phase[a]) * phase[b])[:, None, None] * stiff[3 * a : 3 * a + 3, 3 * b : 3 * b + 3]
                    if (a >= 4) == (b >= 4):
                        diagonal[level + (a >= 4)] += block
                    elif a >= 4:
                        lower[level + 1] += block
        inverse = np.linalg.inv(diagonal[:1])
        for j in range(1, len(levels) - 1):  # the last level is held
            rest = diagonal[j] - lower[j] @ inverse[j - 1] @ np.conj(np.swapaxes(lower[j], -1, -2))
            inverse = np.concatenate([inverse, np.linalg.inv(rest)[None]])
        self.inverse, self.lower = inverse, lower[:-1].copy()
        unit = np.zeros((len(levels) - 1, 3, count), complex)
        unit[0, 2] = 1.0
        _columns(self.inverse, self.lower, unit)
        self.pressed = unit[: self.nz + 1].reshape(self.nz + 1, 3, waves[0], -1).copy()
        self.compliance = self.pressed[0, 2].real
        self.plastic = np.zeros((self.nz, self.nx * self.ny, 8, 6))

    def sunk(self, plastic):
        """Waves of the displacements of plastic strains at the levels of the box."""
        quarter = np.zeros((self.nz + 1, 3, self.nx + 1, self.ny + 1))
        for level in range(self.nz):
            stress = (plastic[level] @ self.law).reshape(-1, 48)
            force = self.weights[level] * (stress @ self.strains[level].reshape(48, 24))
            for part, view in zip(
                np.moveaxis(force.reshape(self.nx, self.ny, 8, 3), 2, 0), self._at(quarter, level), strict=True
            ):
                view += np.moveaxis(part, -1, 0)
        whole = np.zeros((self.nz + 1, 3, *self.waves))
        x, y = np.arange(self.nx + 1), np.arange(self.ny + 1)
        for over in (1, -1):
            for beside in (1, -1):
                sign = np.array([over, beside, 1.0])[:, None, None]
                whole[:, :, (over * x % self.waves[0])[:, None], (beside * y % self.waves[1])[None]] += sign * quarter
        force = np.zeros((self.inverse.shape[0], 3, self.inverse.shape[1]), complex)
        force[: self.nz + 1] = rfft2(whole).reshape(self.nz + 1, 3, -1)
        _columns(self.inverse, self.lower, force)
        return force[: self.nz + 1].reshape(self.pressed.shape)

    def _at(self, nodes, level):
        """The nodes at each corner of the bricks of a level."""
        for x, y, z in (CORNERS > 0).astype(int):
            yield nodes[level + z, :, x : self.nx + x, y : self.ny + y]

    def returned(self, waves, old):
        """Plastic strains after radial return, from displacements of the whole surface and plastic strains before."""
        moved = irfft2(waves, s=self.waves)[:, :, : self.nx + 1, : self.ny + 1]
        new = old.copy()
        for level in range(self.nz):
            corners = np.stack([np.moveaxis(view, 0, -1) for view in self._at(moved, level)], 2).reshape(-1, 24)
            strain = (corners @ self.strains[level].reshape(48, 24).T).reshape(-1, 8, 6) - old[level]
            strain[..., :3] -= strain[..., :3].mean(-1, keepdims=True)
            stress = 2.0 * self.shear * strain * np.array([1.0, 1.0, 1.0, 0.5, 0.5, 0.5])
            mises = np.sqrt(1.5 * ((stress[..., :3] ** 2).sum(-1) + 2.0 * (stress[..., 3:] ** 2).sum(-1)))
            new[level] += strain * (1.0 - np.minimum(1.0, self.strength / np.maximum(mises, 1e-300)))[..., None]
        return new


def touching(compliance, gap, load, start, near=1e-7):
    """Nodal pressures of a load, and the depth of one body in the other."""
    force, walk, before, kept = start * (load / start.sum()), np.zeros_like(gap), 1.0, 0.0

    def sinking(one):
        return irfft2(compliance * rfft2(one), s=gap.shape)

    for _ in range(400):
        on = force > 0.0
        rest = sinking(force) + gap
        rest -= rest[on].mean()
        now = (rest[on] ** 2).sum()
        walk = np.where(on, rest + kept * now / before * walk, 0.0)
        before, bent = now, sinking(walk)
        bent -= bent[on].mean()
        length = (rest[on] * walk[on]).sum() / (bent[on] * walk[on]).sum()
        last, force = force, np.maximum(np.where(on, force - length * walk, 0.0), 0.0)
        caught = (force == 0.0) & (rest < 0.0)
        kept = 0.0 if caught.any() else 1.0
        force[caught] -= length * rest[caught]
        force *= load / force.sum()
        if np.abs(force - last).sum() < near * load:
            break
    return force, (sinking(force) + gap)[force > 0.0].mean()


def pressed(bodies, gap, loads):
    """Depth, residual depth and nodes in contact under rising loads of bodies with a gap between them.

    What plastic strains move of the surface half a wave away is taken off both depths: bodies without end rest there.
    """
    compliance = sum(body.compliance for body in bodies)
    force, rows = (gap <= np.sort(gap.ravel())[20]).astype(float), []
    for load in loads:
        old = np.concatenate([body.plastic.ravel() for body in bodies])
        ends = np.cumsum([body.plastic.size for body in bodies])[:-1]

        def parts(whole, ends=ends):
            return [part.reshape(body.plastic.shape) for part, body in zip(np.split(whole, ends), bodies, strict=True)]

        guess, places, moves = old, [], []
        for turn in range(MOST_TURNS):
            waves = [body.sunk(part) for body, part in zip(bodies, parts(guess), strict=True)]
            sunk = sum(irfft2(wave[0, 2], s=gap.shape) for wave in waves)
            force, depth = touching(compliance, gap + sunk, load, force, 1e-5 if turn < 4 else 1e-7)
            here = rfft2(force)
            rows_of = zip(bodies, waves, parts(old), strict=True)
            new = np.concatenate(
                [body.returned(wave + body.pressed * here, one).ravel() for body, wave, one in rows_of]
            )
            move = new - guess
            if np.linalg.norm(move) <= LEFT * np.linalg.norm(new - old):
                break
            places, moves = [*places, guess][-REMEMBERED:], [*moves, move][-REMEMBERED:]
            guess = new
            if len(moves) > 1:
                apart = np.array([move - one for one in moves[:-1]])
                square = apart @ apart.T
                share = np.linalg.solve(square + 1e-10 * np.trace(square) * np.eye(len(square)), apart @ move)
                ahead = [place + one for place, one in zip(places, moves, strict=True)]
                guess = ahead[-1] - sum(part * (ahead[-1] - one) for part, one in zip(share, ahead[:-1], strict=True))
        else:
            raise AssertionError(f"no equilibrium under {load}")
        for body, part in zip(bodies, parts(new), strict=True):
            body.plastic = part
        sunk = sum(irfft2(body.sunk(body.plastic)[0, 2], s=gap.shape) for body in bodies)
        away = sunk[tuple(size // 2 for size in gap.shape)]
        rows.append((depth - away, (gap + sunk).min() - away, (force > 0.0).sum()))
    return np.array(rows).T


def levels(fine, even, growth, far):
    """Depths: even steps down to one place, growing ones to the last."""
    places = [0.0]
    while places[-1] < far:
        places.append(places[-1] + fine)
        fine *= growth if places[-1] > even else 1.0
    return np.array(places)
