"""A stack under one wave of pressure or shear, by Navier's equations and matrix exponentials of many digits.

Displacements U sin x, W cos x of x and depth z, the wave number one: the state (U, W, U', W') is carried down from the
surface.  A half-space is a layer 45 lengths thick on a rigid base, 180 if
waves may die out slowly in it.
"""

from __future__ import annotations

import mpmath

import winkler as wk

DEEP = 45


def constants(solid):
    if isinstance(solid, wk.TransverselyIsotropic):
        return [mpmath.mpf(c) for c in (solid.c11, solid.c13, solid.c33, solid.c44)]
    young, nu = mpmath.mpf(solid.young), mpmath.mpf(solid.poisson)
    shear = young / (2 * (1 + nu))
    lame = 2 * shear * nu / (1 - 2 * nu)
    return [lame + 2 * shear, lame, lame + 2 * shear, shear]


def carried(solid, depth):
    """The matrix that carries (U, W, T, S) down, T and S the tractions on a plane z = const."""
    c11, c13, c33, c44 = constants(solid)
    both = c13 + c44
    rows = [[0, 0, 1, 0], [0, 0, 0, 1], [c11 / c44, 0, 0, both / c44], [0, c44 / c33, -both / c33, 0]]
    tractions = mpmath.matrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, -c44, c44, 0], [c13, 0, 0, c33]])
    return tractions * mpmath.expm(mpmath.matrix(rows) * depth) * tractions**-1


def surface(wave, layers, on, load=(0, -1), depths=()):
    """(U, W) of the surface under the tractions `load`, and (U, W, T, S) at depths; lengths are scaled by `wave`.

    Layers are (solid, thickness, bonded); displacements are those times the wave number.
    """
    slow = 4 if isinstance(on, wk.TransverselyIsotropic) else 1
    with mpmath.workdps(50 + 50 * slow):
        parts = [(solid, mpmath.mpf(wave) * mpmath.mpf(h), bonded) for solid, h, bonded in layers]
        if not isinstance(on, wk.Rigid):
            parts.append((on, mpmath.mpf(DEEP * slow), True))
        slips = sum(not bonded for _, _, bonded in parts)
        # columns: the load, U and W of the surface, and the slip at each interface
        state = mpmath.zeros(4, 3 + slips)
        state[2, 0], state[3, 0], state[0, 1], state[1, 2] = load[0], load[1], 1, 1
        rows, tops, slip = [], [], 3
        for number, (solid, h, bonded) in enumerate(parts):
            tops.append((solid, h, state))
            state = carried(solid, h) * state
            if not bonded:
                rows.append(state[2, :])
                state = state.copy()
                if number < len(parts) - 1:
                    state[0, slip] += 1
                    slip += 1
        rows.append(state[1, :])
        if parts[-1][2]:
            rows.append(state[0, :])
        count = len(rows)
        matrix = mpmath.matrix(count, count)
        right = mpmath.matrix(count, 1)
        for i, row in enumerate(rows):
            right[i] = -row[0]
            for j in range(count):
                matrix[i, j] = row[j + 1]
        found = mpmath.lu_solve(matrix, right)
        amplitudes = mpmath.matrix([1, *found, *([0] * (3 + slips - 1 - count))])
        places = []
        for depth in depths:
            left = mpmath.mpf(wave) * mpmath.mpf(depth)
            for solid, h, top in tops:
                if left <= h:
                    places.append([float(one) for one in carried(solid, left) * top * amplitudes])
                    break
                left -= h
        return float(found[0]), float(found[1]), places
