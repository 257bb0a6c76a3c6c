"""The numbers of a literature case, recomputed in mpmath from its [problem] alone."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any

import mp_solutions as reference
import mpmath as mp

PREFIXES = {"": "1", "m": "1e-3", "u": "1e-6", "n": "1e-9", "k": "1e3", "M": "1e6", "G": "1e9"}
UNITS = {
    "": "1",
    **{f"m^-{power}": "1" for power in range(1, 6)},
    **{prefix + unit: factor for prefix, factor in PREFIXES.items() for unit in ("m", "N", "Pa", "rad")},
}


def si(given: str | float) -> mp.mpf:
    """A quantity as people write it, exact: "0.3 mm", "70.3 deg", 0.5."""
    number, _, unit = str(given).partition(" ")
    if unit == "deg":
        return mp.mpf(number) * mp.pi / 180
    return mp.mpf(number) * mp.mpf(UNITS[unit])


def body(profile: dict[str, Any]) -> reference.Body:
    """The body of revolution of a [problem.bed.profile]."""
    numbers = {name: content for name, content in profile.items() if name != "kind"}
    kind = profile["kind"]
    if kind == "sum":
        return reference.added([body(part) for part in numbers["parts"]])
    if kind == "formula":  # of powers of r: exact by its own terms, the only formula among the cases
        assert numbers["expression"] == "r**2/(2*R) + r**4/(8*R**3)"
        big = si(numbers["constants"]["R"])
        return reference.added([reference.paraboloid(big), reference.power_law(1 / (8 * big**3), mp.mpf(4))])
    if kind == "area_function":  # pi r^2 = C0 h^2 + C1 h is a hyperboloid of revolution
        first, second = (si(item) for item in numbers["coefficients"])
        return reference.hyperboloid(second / (2 * mp.pi), mp.atan(mp.sqrt(first / mp.pi)))
    if kind == "capped_cylinder":
        return reference.capped_cylinder(si(numbers["radius"]), body(numbers["cap"]))
    if kind == "vickers":  # 68 degrees from the axis to the faces: A = 4 tan^2 h^2
        return reference.cone(mp.atan(2 * mp.tan(mp.radians(68)) / mp.sqrt(mp.pi)))
    if kind == "cube_corner":  # tan^2 = 1/2: A = 3 sqrt(3)/2 h^2
        return reference.cone(mp.atan(mp.sqrt(3 * mp.sqrt(3) / (2 * mp.pi))))
    if kind == "berkovich":  # 65.27 degrees: A = 3 sqrt(3) tan^2 h^2
        return reference.cone(mp.atan(mp.tan(mp.radians(mp.mpf("65.27"))) * mp.sqrt(3 * mp.sqrt(3) / mp.pi)))
    return getattr(reference, kind)(**{name: si(content) for name, content in numbers.items()})


def transverse(c11: mp.mpf, c12: mp.mpf, c13: mp.mpf, c33: mp.mpf, c44: mp.mpf) -> tuple[mp.mpf, mp.mpf]:
    """E* and G* of theory 1.1 (proved from elasticity in test_transverse_moduli)."""
    mean = mp.sqrt(c11 * c33)
    modulus = 2 * mp.sqrt(c44) * (c11 * c33 - c13**2)
    modulus /= mp.sqrt(c11) * mp.sqrt((mean - c13) * (c13 + 2 * c44 + mean))
    return modulus, 2 / (mp.sqrt(c33 / c11) / modulus + 1 / (2 * mp.sqrt(c44 * (c11 - c12) / 2)))


def moduli(medium: dict[str, Any]) -> tuple[mp.mpf, mp.mpf]:
    """E* and G* of a [problem.bed.medium]."""
    first = {name: si(content) for name, content in medium["first"].items() if name != "kind"}
    if medium["kind"] == "transversely_isotropic_half_space":
        return transverse(**first)
    normal = tangential = mp.mpf(0)
    for solid in (medium["first"], medium.get("second", {"kind": "rigid"})):
        if solid["kind"] == "elastic":
            young, nu = si(solid["young"]), si(solid["poisson"])
            normal += (1 - nu**2) / young
            tangential += (2 - nu) * (1 + nu) / (2 * young)
    return 1 / normal, 1 / tangential


@dataclass
class ReferenceSolution:
    """The contact of one case."""

    problem: dict[str, Any]

    @cached_property
    def body(self) -> reference.Body:
        bed = self.problem["bed"]
        if bed["kind"] == "plane_foundation":  # g = x^2/(2 R) belongs to the paraboloid of twice the radius
            assert bed["plane_profile"]["kind"] == "paraboloid"
            return reference.paraboloid(2 * si(bed["plane_profile"]["curvature_radius"]))
        return body(bed["profile"])

    @cached_property
    def modulus(self) -> mp.mpf:
        return moduli(self.problem["bed"]["medium"])[0]

    @cached_property
    def shear_modulus(self) -> mp.mpf:
        return moduli(self.problem["bed"]["medium"])[1]

    @cached_property
    def radius(self) -> mp.mpf:
        if self.problem["kind"] == "yield_onset":  # p0 = 2 E* a/(pi R) at the onset, one body yields
            bed = self.problem["bed"]
            peak = si(bed["medium"]["first"]["strength"]) / self._deepest[1]
            return mp.pi * si(bed["profile"]["curvature_radius"]) * peak / (2 * self.modulus)
        load = self.problem["load"]
        kind, given = load["kind"], si(load[load["kind"]])
        if kind == "radius":
            return given
        # Hertz's or a cone's estimate, at least the flat end, is near enough to start a secant
        profile = self.problem["bed"].get("profile", {})
        size = si(profile["curvature_radius"]) if "curvature_radius" in profile else None
        least = mp.mpf("1.1") * si(profile.get("flat_radius", 0.0))
        if kind == "depth":
            return self.body.radius_at_depth(given, max(least, mp.sqrt(size * given) if size else given))
        guess = mp.cbrt(3 * given * size / (4 * self.modulus)) if size else mp.sqrt(given / self.modulus)
        return self.body.radius_at_force(given, self.modulus, max(least, guess))

    @cached_property
    def depth(self) -> mp.mpf:
        load = self.problem.get("load", {"kind": "yield onset"})
        if load["kind"] == "depth":
            return si(load["depth"])
        pinned = mp.mpf(0)
        if load["kind"] == "force":
            more = si(load["force"]) - self.body.force(self.radius, self.modulus)
            pinned = more / (2 * self.modulus * self.radius)
        return self.body.gap(self.radius) + pinned

    @property
    def force(self) -> mp.mpf:
        more = self.depth - self.body.gap(self.radius)
        return self.body.force(self.radius, self.modulus) + 2 * self.modulus * self.radius * more

    @property
    def stiffness(self) -> mp.mpf:
        return 2 * self.modulus * self.radius

    @property
    def energy(self) -> mp.mpf:
        return self.body.energy(self.radius, self.modulus, self.depth)

    @cached_property
    def field(self) -> Callable[[mp.mpf, mp.mpf], dict[str, mp.mpf]]:
        return cache(self._field)

    def _field(self, r: mp.mpf, z: mp.mpf) -> dict[str, mp.mpf]:
        """Stresses below Hertz's contact or a flat punch in the first body."""
        solid = self.problem["bed"]["medium"]["first"]
        nu = si(solid["poisson"])
        shear = si(solid["young"]) / (2 * (1 + nu))
        profile = self.problem["bed"]["profile"]
        if profile["kind"] == "flat_punch":
            transform = reference.punch_transform(self.radius, self.force)
        else:
            peak = 2 * self.modulus * self.radius / (mp.pi * si(profile["curvature_radius"]))
            transform = reference.hertz_transform(self.radius, peak)
            if z == 0:  # Huber, at the edge
                assert r == self.radius
                return {"radial_stress": (1 - 2 * nu) * peak / 3, "hoop_stress": -(1 - 2 * nu) * peak / 3}
        found = reference.hankel_field(transform, r, z, nu, shear, self.radius)
        return {**found, **reference.equivalents(found)}

    @cached_property
    def z(self) -> mp.mpf:
        """Depth of the largest shear stress below Hertz's contact; on the axis von Mises' stress is twice that."""
        return self.radius * self._deepest[0]

    @cached_property
    def _deepest(self) -> tuple[mp.mpf, mp.mpf]:
        """z/a and von Mises' stress over p0 at the place of the largest, on the axis (Johnson 3.45)."""
        nu = si(self.problem["bed"]["medium"]["first"]["poisson"])

        def stress(s: mp.mpf) -> mp.mpf:
            return mp.mpf(3) / 2 / (1 + s**2) - (1 + nu) * (1 - s * mp.acot(s))

        place = mp.findroot(lambda s: mp.diff(stress, s), mp.mpf("0.5"))
        return place, stress(place)

    def quantity(self, expectation: dict[str, Any]) -> mp.mpf:
        """The number that an entry of [[expect]] requests, SI."""
        name = expectation["quantity"].rpartition(".")[2]
        if "z" in expectation:
            return self.field(si(expectation["r"]), si(expectation["z"]))[name]
        if "r" in expectation:
            r = si(expectation["r"])
            sunk = self.body.displacement(r, self.radius, self.depth)
            if name == "displacement":
                return sunk
            if name == "gap":
                return self.body.height(r) - self.depth + sunk
            return self.body.pressure(r, self.radius, self.modulus, self.depth)
        return getattr(self, name)
