"""Axisymmetric or plane-strain finite elements of a yielding body under a rigid one, small strains, no friction.

Bilinear quadrilaterals with the mean dilatation of Hughes (B-bar), von Mises' condition by radial return, linear
hardening, and contact by events: the nodes 0 to k - 1 of the surface are held on the rigid body, and node k just
touches it, so that the depth is an unknown and no contact is searched for.
"""

import copy

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.linalg import LinAlgError, cho_solve_banded, cholesky_banded

GAUSS = np.array([-1.0, 1.0]) / np.sqrt(3.0)
FAR = 30.0
"""Size of the mesh over the contact radius."""


def graded(fine, count, ratio, far=FAR):
    """Places: as many equal steps, then growing ones up to the far end."""
    places, step = list(fine * np.arange(count + 1)), fine
    while places[-1] < far:
        step *= ratio
        places.append(places[-1] + step)
    return np.array(places)


class Body:
    """A body of unit modulus whose upper face is pressed; `cells` cells lie on the greatest contact radius, 1.

    A cylinder about the z axis, or, if `plane`, a block endless along y, half of which is meshed.  `other`, its Young's
    modulus, Poisson's ratio, strength and rise, is a second body that presses it from above; `partner` are then the
    vertical displacements of its surface.
    """

    def __init__(self, cells, poisson, strength, rise=0.0, *, other=None, plane=False, far=FAR):
        r, z = graded(1.0 / cells, int(1.25 * cells), 1.18, far), graded(1.0 / cells, cells, 1.15, far)
        self.plane = plane
        bodies = [(1.0, poisson, strength, rise), *([other] if other else [])]
        heights = np.concatenate([z[::-1], -z]) if other else -z
        grid = np.stack(np.meshgrid(r, heights, indexing="ij"), -1).reshape(-1, 2)
        nodes = np.arange(r.size * heights.size).reshape(r.size, -1)
        low = nodes[:, -z.size :]
        blocks = [low, *([nodes[:, : z.size]] if other else [])]
        cells_of = [np.stack([b[:-1, 1:], b[1:, 1:], b[1:, :-1], b[:-1, :-1]], -1).reshape(-1, 4) for b in blocks]
        each = [np.full((len(part), 1), number) for number, part in enumerate(cells_of)]
        young, ratio, self.strength, self.rise = np.array(bodies).T[:, np.concatenate(each)]
        self.shear, self.bulk = 0.5 * young / (1.0 + ratio), young / (3.0 * (1.0 - 2.0 * ratio))
        cells_of = np.concatenate(cells_of)
        self.r, self.surface = r, 2 * low[:, 0] + 1
        self.partner = self.surface - 2 if other else None
        self.fixed = np.zeros(grid.size, dtype=bool)
        self.fixed[2 * nodes[0]] = self.fixed[2 * low[:, -1] + 1] = True  # axis and bottom
        if other:
            self.fixed[2 * nodes[:, 0] + 1] = True
        self.dofs = np.stack([2 * cells_of, 2 * cells_of + 1], -1).reshape(-1, 8)
        self._strain_matrices(grid[cells_of])
        self.width = 2 * heights.size + (5 if other else 3)
        self.moved, self.plastic = np.zeros(grid.size), np.zeros((*self.weight.shape, 5))

    def _band(self, stiff, same):
        """The lower bands of a matrix, whose rows and columns are numbered by `same`."""
        dofs, size = same[self.dofs], self.moved.size
        row, column = np.repeat(dofs, 8, axis=1).ravel(), np.tile(dofs, (1, 8)).ravel()
        low = row >= column
        place = (row - column)[low] * size + column[low]
        return np.bincount(place, stiff.ravel()[low], (self.width + 1) * size).reshape(-1, size)

    def apart(self, moved):
        """How far the surface has moved up against that of the body above."""
        return moved[self.surface] - (0.0 if self.partner is None else moved[self.partner])

    def _strain_matrices(self, corners):
        matrix, weight = np.zeros((len(corners), 4, 4, 8)), np.zeros((len(corners), 4))
        for q, (x, y) in enumerate((x, y) for x in GAUSS for y in GAUSS):
            shape = 0.25 * np.array([(1 - x) * (1 - y), (1 + x) * (1 - y), (1 + x) * (1 + y), (1 - x) * (1 + y)])
            slopes = 0.25 * np.array([[y - 1, x - 1], [1 - y, -1 - x], [1 + y, 1 + x], [-1 - y, 1 - x]])
            jacobian = np.einsum("eai,aj->eij", corners, slopes)
            gradient = np.einsum("aj,eji->eai", slopes, np.linalg.inv(jacobian))
            radius = corners[:, :, 0] @ shape
            around = 2.0 if self.plane else 2.0 * np.pi * radius
            matrix[:, q, 0, 0::2], matrix[:, q, 1, 1::2] = gradient[:, :, 0], gradient[:, :, 1]
            if not self.plane:
                matrix[:, q, 2, 0::2] = shape / radius[:, None]
            matrix[:, q, 3, 0::2], matrix[:, q, 3, 1::2] = gradient[:, :, 1], gradient[:, :, 0]
            weight[:, q] = np.linalg.det(jacobian) * around
        dilatation = matrix[:, :, :3].sum(2)
        mean = np.einsum("eq,eqk->ek", weight, dilatation) / weight.sum(1)[:, None]
        matrix[:, :, :3] += ((mean[:, None] - dilatation) / 3.0)[:, :, None]
        self.matrix, self.weight = matrix, weight

    def stress(self, moved):
        """Stresses, their tangent, and plastic strains (rr, zz, tt, engineering rz, accumulated)."""
        strain = np.einsum("eqik,ek->eqi", self.matrix, moved[self.dofs]) - self.plastic[..., :4]
        volume = strain[..., :3].sum(-1, keepdims=True)
        deviator = np.concatenate([strain[..., :3] - volume / 3.0, 0.5 * strain[..., 3:]], -1)
        deviator *= 2.0 * self.shear[..., None]
        norm = np.sqrt((deviator[..., :3] ** 2).sum(-1) + 2.0 * deviator[..., 3] ** 2)
        mises = np.sqrt(1.5) * norm
        limit = self.strength + self.rise * self.plastic[..., 4]
        yields = mises > limit
        grown = np.where(yields, (mises - limit) / (3.0 * self.shear + self.rise), 0.0)
        kept = np.where(yields, (limit + self.rise * grown) / np.where(yields, mises, 1.0), 1.0)
        flow = deviator / np.where(norm > 0.0, norm, 1.0)[..., None]
        along = np.sqrt(1.5) * flow * np.array([1.0, 1.0, 1.0, 2.0])
        plastic = self.plastic + grown[..., None] * np.concatenate([along, np.ones((*grown.shape, 1))], -1)
        stress = deviator * kept[..., None]
        stress[..., :3] += self.bulk[..., None] * volume
        one, unit = np.array([1.0, 1.0, 1.0, 0.0]), np.diag([1.0, 1.0, 1.0, 0.5])
        unit[:3, :3] -= 1.0 / 3.0
        tangent = (2.0 * self.shear * kept)[..., None, None] * unit + self.bulk[..., None, None] * np.outer(one, one)
        lost = np.where(yields, kept - self.rise / (3.0 * self.shear + self.rise), 0.0)
        tangent -= (2.0 * self.shear * lost)[..., None, None] * flow[..., :, None] * flow[..., None, :]
        return stress, tangent, plastic

    def forces(self, stress):
        inner = np.einsum("eq,eqik,eqi->ek", self.weight, self.matrix, stress)
        return np.bincount(self.dofs.ravel(), inner.ravel(), self.moved.size)

    def _factor(self, tangent, fixed, count=0):
        """The matrix, and the factors of that whose first nodes of the surface move with those above them."""
        stiff = np.einsum("eq,eqik,eqij,eqjl->ekl", self.weight, self.matrix, tangent, self.matrix, optimize=True)
        same = np.arange(self.moved.size)
        whole = self._band(stiff, same)
        if self.partner is not None:
            same[self.surface[:count]] = self.partner[:count]
        band, held = self._band(stiff, same) if self.partner is not None else whole.copy(), np.flatnonzero(fixed)
        band[:, held] = 0.0
        for m in range(1, self.width + 1):
            band[m, held[held >= m] - m] = 0.0
        band[0, held] = 1.0
        return whole, cholesky_banded(band, lower=True, check_finite=False)

    def _shared(self, forces, count):
        """Forces, with those on the first nodes of the surface on the nodes above that move with them."""
        if self.partner is None:
            return forces
        forces = forces.copy()
        forces[self.partner[:count]] += forces[self.surface[:count]]
        return forces

    def _part(self, moved, change, count, free, before):
        """The part of a step after which least is left."""
        least, best = np.inf, 1.0
        for part in (1.0, 0.5, 0.25, 0.1):
            left = np.linalg.norm(self._shared(self.forces(self.stress(moved + part * change)[0]), count)[free])
            if left < least:
                least, best = left, part
            if left < 0.9 * before:
                break
        return best

    def event(self, k, gap, back=False):
        """Depth and force when node k just touches a rigid body of this gap at the nodes of the surface."""
        held = self.surface[:k]
        fixed = self.fixed.copy()
        fixed[held] = True
        free, moved = ~fixed, self.moved.copy()
        depth = gap[k] - self.apart(moved)[k]
        elastic = self.stress(0.0 * moved)[1] if back else None
        for turn in range(40):
            stress, tangent, plastic = self.stress(moved)
            residual = self.forces(stress)
            left = np.linalg.norm(self._shared(residual, k)[free]) / max(np.linalg.norm(residual[held]), 1e-300)
            missed = abs(gap[k] - self.apart(moved)[k] - depth) / abs(depth)
            if turn and left < 1e-8 and missed < 1e-9:
                self.moved, self.plastic = moved, plastic
                return depth, -float(residual[held].sum())
            tangent = elastic if back and turn < 2 else tangent
            try:
                whole, factor = self._factor(tangent, fixed, k)
            except LinAlgError:
                whole, factor = self._factor(0.9 * tangent + 0.1 * self.stress(0.0 * moved)[1], fixed, k)
            jump, one = np.zeros_like(moved), np.zeros_like(moved)
            jump[held], one[held] = gap[:k] - depth - self.apart(moved)[:k], 1.0
            right = np.stack([-residual - _times(whole, jump), _times(whole, one)], 1)
            right = self._shared(right, k)
            right[fixed] = 0.0
            step = cho_solve_banded((factor, True), right, check_finite=False)
            if self.partner is not None:
                step[held] = step[self.partner[:k]]
            moves = self.apart(step)[k]
            deeper = (gap[k] - depth - self.apart(moved)[k] - moves[0]) / (1.0 + moves[1])
            change = step[:, 0] + deeper * step[:, 1]
            change[held] += jump[held] - deeper
            before = np.linalg.norm(self._shared(residual, k)[free])
            part = 1.0 if turn == 0 else self._part(moved, change, k, free, before)
            moved, depth = moved + part * change, depth + part * deeper
        raise AssertionError(f"no equilibrium when node {k} touches: {left}, {missed}")


def _times(band, vector):
    """A symmetric matrix of bands times a vector."""
    found = band[0] * vector
    for m in range(1, len(band)):
        found[m:] += band[m, :-m] * vector[:-m]
        found[:-m] += band[m, :-m] * vector[m:]
    return found


def pressed_and_released(cells, poisson, strength, profile, rise=0.0):
    """Depth, force, residual depth, work spent and given back of a contact of radius 1 under a rigid body f(r)."""
    body = Body(cells, poisson, strength, rise)
    gap = profile(body.r)
    modulus = 1.0 / (1.0 - poisson**2)

    def far(depth, force):  # what the body beyond the mesh yields, about a point force
        return depth + 0.3 * force / (modulus * FAR)

    def states(body, contacts, **how):
        found = [body.event(k, gap, **how) for k in contacts]
        return np.array([(far(depth, force), force) for depth, force in found]).T

    rising, pressing = states(body, range(1, cells + 1))
    depth, force = rising[-1], pressing[-1]
    less, lower = states(copy.copy(body), range(cells - 1, 2, -1), back=True)
    low = lower < 0.3 * force
    residual = np.polyfit(lower[low] ** (2.0 / 3.0), less[low], 1)[-1]
    less, lower = np.append(less[::-1], depth), np.append(lower[::-1], force)
    given = 0.4 * lower[0] * (less[0] - residual) + _work(less, lower)  # the rest as under a ball
    spent = _work(np.append(0.0, rising), np.append(0.0, pressing))
    return depth, force, residual, spent, given


def _work(depth, force):
    """The integral of the force over the depth, by cubics."""
    return float(CubicSpline(depth, force).integrate(depth[0], depth[-1]))


def strip_pressed(cells, *solid, **other):
    """Half-widths and forces per length of a strip that grows to one under a parabola x^2 / 2, and the body."""
    body = Body(cells, *solid, **other, plane=True, far=100.0)
    force = [body.event(k, 0.5 * body.r**2)[1] for k in range(1, cells + 1)]
    return body.r[1 : cells + 1], np.array(force), body


def released(body, cells, reverse=1e-3):
    """How deep the middle of a contact lies after its load is gone, and how high its edge stands; of both bodies.

    The release is elastic: what would yield backwards must be less than a part `reverse` of the plastic strain.
    """
    fixed = body.fixed
    left = -body.forces(body.stress(body.moved)[0])
    left[fixed] = 0.0
    fresh = copy.copy(body)
    fresh.plastic = 0.0 * body.plastic
    elastic = fresh.stress(0.0 * body.moved)[1]
    moved = body.moved + cho_solve_banded((body._factor(elastic, fixed)[1], True), left, check_finite=False)
    assert np.max(body.stress(moved)[2][..., 4] - body.plastic[..., 4]) < reverse * np.max(body.plastic[..., 4])
    surface = body.apart(moved)
    return -surface[0], surface[cells]
