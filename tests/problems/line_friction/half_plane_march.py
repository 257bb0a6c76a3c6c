"""A sheared cylinder by boundary elements in two dimensions, step by step: a reference without winkler.

Elements of even traction on a half-plane, E* = R = 1; each element sticks, slips or is apart, which is found by trying.
The pressure is that of Hertz, averaged over each element.
"""

from __future__ import annotations

import numpy as np

ROUNDING = 1e-12
"""Slip [m] that is none, and part of a bound; contacts are about one wide."""


def lifted(y):
    """Return y ln|y| - y."""
    size = np.where(y == 0.0, 1.0, np.abs(y))
    return y * np.log(size) - y


class HalfPlaneMarch:
    """Elements between edges; on one side only where the other one is its mirror image."""

    def __init__(self, edges, mu, force):
        self.edges, self.mu = edges, mu
        self.x, self.h = 0.5 * (edges[1:] + edges[:-1]), np.diff(edges)
        self.mirrored = edges[0] == 0.0
        self.compliance = self._compliance(self.x)
        if self.mirrored:
            self.compliance += self._compliance(-self.x)
        self.slips, self.traction, self.ahead, self.step = np.zeros((4, self.h.size))
        self.force, self.most = force, self._bound(force)
        self.lost = 0.0

    def _compliance(self, x):
        far = x[:, None] - self.edges[None, :]
        return -2.0 / np.pi * (lifted(far[:, :-1]) - lifted(far[:, 1:]))

    def _bound(self, force):
        """Return mu times Hertz' pressure, averaged over the elements."""
        a = np.sqrt(4.0 * force / np.pi)
        s = np.clip(self.edges / a, -1.0, 1.0)
        borne = 0.25 * a * a * (s * np.sqrt(1.0 - s * s) + np.arcsin(s))  # p0 = a / 2
        return self.mu * np.diff(borne) / self.h

    def go(self, force, shear, strain, turning):
        """Go to the end of a step; a strain of the first body along x is taken up by slip."""
        most, sides = self._bound(force), 2.0 if self.mirrored else 1.0
        touches = most > 0.0
        came = touches & (self.most == 0.0)
        # what comes into contact in the middle of a step was carried along until then
        held = self.ahead + np.where(came & (not turning), 0.5 * self.step, 0.0)
        slips = np.where(touches & (not turning), self.slips, 0.0)
        for _ in range(200):
            stuck = touches & (slips == 0.0)
            traction = np.where(touches, slips * most, 0.0)
            rows, n = np.flatnonzero(stuck), int(stuck.sum())
            free = held + strain * self.x + self.compliance @ traction
            system = np.zeros((n + 1, n + 1))
            system[:n, :n], system[:n, n], system[n, :n] = self.compliance[np.ix_(rows, rows)], -1.0, self.h[rows]
            found = np.linalg.solve(system, np.append(-free[rows], shear / sides - self.h @ traction))
            traction[rows] = found[:n]
            ahead = found[n] - strain * self.x - self.compliance @ traction
            over = stuck & (np.abs(traction) > most * (1.0 + ROUNDING))
            back = touches & (slips != 0.0) & (slips * (ahead - held) < -ROUNDING)
            if not (over.any() or back.any()):
                break
            slips = np.where(over, np.sign(traction), np.where(back, 0.0, slips))
        else:
            raise RuntimeError("stick and slip were not found")
        self.lost += sides * float(np.sum(self.h * 0.5 * (most + self.most) * slips * (ahead - self.ahead)))
        self.force, self.step = force, ahead - self.ahead
        self.slips, self.most, self.traction, self.ahead = slips, most, traction, ahead
