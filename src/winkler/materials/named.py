"""Common materials by their names: values from tables at room temperature, with the source of every number."""

from __future__ import annotations

import dataclasses
import functools
import math
import re
import tomllib
from importlib import resources
from typing import Any

from winkler.materials.conductor import ElectricalConductor, ThermalConductor
from winkler.materials.elastic import Elastic
from winkler.values.errors import InvalidInput, suggest
from winkler.values.value import value, words

TABLE_FILE = "materials.toml"

SHORE = re.compile(r"(?:rubber )?shore ?([ad]) ?(\d+(?:\.\d+)?)")
SHORE_RANGES = {"a": (20.0, 80.0, 0.0), "d": (30.0, 85.0, 50.0)}
"""Scale -> least and greatest hardness for which its modulus is known, and what makes one of scale A of it."""

QI = (
    "log10 of E in MPa = 0.0235 S - 0.6403, S of scale A or 50 more than that of scale D: H. J. Qi, K. Joyce, "
    "M. C. Boyce, Rubber Chem. Technol. 76 (2003) 419, doi:10.5254/1.3547752"
)
OTHER_ENDS = {
    "a": "A. N. Gent, Rubber Chem. Technol. 31 (1958) 896, doi:10.5254/1.3542351",
    "d": (
        "the cone of 30 degrees and the spring of 0.4445 N a point over 2.5 mm of ASTM D2240, by I. N. Sneddon, "
        "Int. J. Eng. Sci. 3 (1965) 47, doi:10.1016/0020-7225(65)90019-4"
    ),
}
"""Scale -> source of the second relation between hardness and modulus."""
TOLERANCE = 5.0
"""Of the hardness of rubber as it is sold, in points: silicone.pro, tolerance of the trade."""
CONE_ANGLE, CONE_SPRING, CONE_STROKE = math.radians(15.0), 0.4445, 2.5e-3
"""Of the durometer of scale D: half the angle at the tip, force of one point [N], travel from 0 to 100 [m]."""


@value
class TabulatedProperty:
    """One number of a material.

    Parameters
    ----------
    quantity : str
        A word of the glossary, such as ``young``.
    number : float
        In the glossary's SI unit.
    source : str
        Where it stands.
    spread : tuple of float, optional
        The least and the greatest value that sources state, or that treatment and composition give; None where the
        source states none.
    """

    __words__ = words(
        quantity=("", None, "word of the glossary for a number"),
        number=("", None, "a number in the glossary's SI unit"),
        source=("", None, "where a number stands"),
        spread=("", None, "least and greatest value of sources"),
    )

    quantity: str
    number: float
    source: str
    spread: tuple[float, float] | None = None


@value
class NamedMaterial:
    """The properties of a material from tables at room temperature.

    Values have two or three digits, enough for estimates and comparisons. Alloying, heat treatment and curing change
    moduli by a few per cent, but hardness and strength by factors. Ranges are given where sources state them.
    Properties without a source are omitted.

    Parameters
    ----------
    name : str
        Its name.
    sort : str
        The variety of the material, such as its alloy or condition.
    figures : tuple of TabulatedProperty
        The known properties: ``young``, ``poisson``, ``strength``, ``hardness`` [Pa, -], ``density`` [kg/m^3],
        ``heat_capacity`` [J/(kg K)], ``conductivity`` [W/(m K)], ``resistivity`` [ohm m], ``temperature_coefficient``
        [1/K].

    Examples
    --------
    >>> silica = material("fused silica")
    >>> silica.elastic
    Elastic(young=73000000000.0, poisson=0.17, strength=inf)
    >>> silica.number("density")
    2203.0
    """

    __words__ = words(
        name=("", None, "name of the material"),
        sort=("", None, "which sort of the material"),
        figures=("", None, "the numbers that are known, with their sources"),
    )

    name: str
    sort: str
    figures: tuple[TabulatedProperty, ...]

    def number(self, quantity: str) -> float:
        """Return a quantity in its SI unit.

        Raises
        ------
        InvalidInput
            If the table does not contain it.
        """
        numbers = {figure.quantity: figure.number for figure in self.figures}
        if quantity not in numbers:
            raise InvalidInput(
                f"{self.name}: no {quantity} is in the table, which has {', '.join(numbers)}; give your own number."
            )
        return numbers[quantity]

    def _known(self, quantity: str, otherwise: float) -> float:
        return next((figure.number for figure in self.figures if figure.quantity == quantity), otherwise)

    @property
    def elastic(self) -> Elastic:
        """The elastic solid, with its yield strength if known."""
        return Elastic(self.number("young"), self.number("poisson"), self._known("strength", math.inf))

    @property
    def electrical_conductor(self) -> ElectricalConductor:
        """The electrical conductor; with constant resistivity if no temperature coefficient is known."""
        return ElectricalConductor(self.number("resistivity"), self._known("temperature_coefficient", 0.0))

    @property
    def thermal_conductor(self) -> ThermalConductor:
        """The conductor of heat."""
        return ThermalConductor.of(self.number("conductivity"), self.number("density"), self.number("heat_capacity"))


@functools.cache
def _table() -> dict[str, Any]:
    return tomllib.loads((resources.files("winkler.materials") / TABLE_FILE).read_text(encoding="utf-8"))


def material_names() -> tuple[str, ...]:
    """Return the names of all materials in the table."""
    return tuple(_table()["materials"])


def other_names(name: str) -> tuple[str, ...]:
    """Return what else a material is called, and of which sort it is."""
    row = _table()["materials"][name]
    return (*row["also"], row["sort"])


def materials_called(word: str) -> tuple[str, ...]:
    """Return the materials that have a word in one of their names in English, German or French, such as ``steel``.

    Examples
    --------
    >>> materials_called("carbide")
    ('tungsten carbide', 'silicon carbide')
    """
    sought = re.compile(rf"\b{re.escape(word.strip())}\b", re.IGNORECASE)
    rows = _table()["materials"].items()
    return tuple(name for name, row in rows if word.strip() and any(map(sought.search, (name, *row["also"]))))


def material(name: str) -> NamedMaterial:
    """Return a common material.

    Parameters
    ----------
    name : str
        For example ``"fused silica"``; common synonyms are accepted. Capitals matter only if they distinguish two
        materials (``"tin"`` is the metal, ``"TiN"`` titanium nitride). ``"Shore A 60"`` is a rubber of that hardness
        (20 to 80 of scale A, 30 to 85 of scale D). The spread covers two published relations, and 5 points of
        tolerance of the hardness.

    Raises
    ------
    InvalidInput
        If the table does not contain the name; the message lists the names. If the name is ambiguous, such as
        ``steel``, or a hardness is out of range.

    Examples
    --------
    >>> rubber = material("Shore A 60")
    >>> round(rubber.number("young") / 1e6, 2), rubber.number("poisson")
    (5.88, 0.5)
    """
    if isinstance(name, str) and (found := SHORE.fullmatch(" ".join(name.lower().split()))):
        return _rubber(found[1], float(found[2]))
    told = name.strip() if isinstance(name, str) else ""
    known = [(word, one) for one, row in _table()["materials"].items() for word in (one, *row["also"])]
    called = {one for word, one in known if word in (told, told[:1].lower() + told[1:])}
    called = called or {one for word, one in known if word.lower() == told.lower()}
    meant = sorted(called) or list(materials_called(told))
    if len(meant) > 1:
        raise InvalidInput(f"the material {name!r} may be {', '.join(meant[:-1])} or {meant[-1]}; write one of these.")
    if not called:
        near = f" (did you mean '{meant[0]}'?)" if meant else suggest(told.lower(), [word.lower() for word, _ in known])
        raise InvalidInput(f"the material {name!r} is not in the table{near}; it has {', '.join(material_names())}.")
    return _made(called.pop())


def _rubber(scale: str, hardness: float) -> NamedMaterial:
    """Return the rubber of a Shore hardness."""
    least, greatest, _ = SHORE_RANGES[scale]
    if not least <= hardness <= greatest:
        raise InvalidInput(
            f"the hardness {hardness:g} of scale {scale.upper()} is out of the range of {least:g} to {greatest:g} in "
            "which a modulus is known; give a Young's modulus."
        )
    young = _moduli(scale, hardness)[0]
    ends = min(_moduli(scale, hardness - TOLERANCE)), max(_moduli(scale, hardness + TOLERANCE))
    source = f"{QI}; range: this and {OTHER_ENDS[scale]}, at {TOLERANCE:g} points less and more"
    figures = (TabulatedProperty("young", young, source, ends), _made("natural rubber").figures[1])
    return NamedMaterial(f"Shore {scale.upper()} {hardness:g}", "rubber, by its hardness", figures)


def _moduli(scale: str, hardness: float) -> tuple[float, float]:
    """Return the Young's moduli [Pa] of both relations."""
    young = 1e6 * 10.0 ** (0.0235 * (hardness + SHORE_RANGES[scale][2]) - 0.6403)
    if scale == "a":
        return young, 1e6 * 0.0981 * (56.0 + 7.62336 * hardness) / (0.137505 * (254.0 - 2.54 * hardness))
    depth = CONE_STROKE * (1.0 - hardness / 100.0)
    return young, 0.75 * CONE_SPRING * hardness * math.pi / (2.0 * math.tan(CONE_ANGLE) * depth**2)


def _made(name: str) -> NamedMaterial:
    row, sources = _table()["materials"][name], _table()["sources"]
    figures = []
    for quantity in [key for key in row if key not in ("sort", "also")]:
        number, source, *spread = row[quantity]
        ranged = "; range: " * bool(spread[1:]) + " and ".join(sources[other] for other in spread[1:])
        figures.append(TabulatedProperty(quantity, number, sources[source] + ranged, *map(tuple, spread[:1])))
    return NamedMaterial(name, row["sort"], tuple(figures))


def _fill(named: Any, content: Any) -> None:
    """Give a value the numbers that its name stands for."""
    for field in dataclasses.fields(content):
        object.__setattr__(named, field.name, getattr(content, field.name))


@value
class NamedElastic(Elastic):
    """An elastic solid of the table of materials, by its name.

    Parameters
    ----------
    name : str
        Of the material, as ``winkler show materials`` lists it.

    Raises
    ------
    InvalidInput
        If the table does not contain the name.

    Examples
    --------
    >>> NamedElastic("tungsten").young
    411000000000.0
    """

    __words__ = words(name=("", None, "name in the table of materials"))

    young: float = dataclasses.field(init=False, default=math.nan)
    poisson: float = dataclasses.field(init=False, default=math.nan)
    strength: float = dataclasses.field(init=False, default=math.inf)
    name: str

    def __post_init__(self) -> None:
        _fill(self, material(self.name).elastic)


@value
class NamedElectricalConductor(ElectricalConductor):
    """A conductor of current of the table of materials, by its name.

    Parameters
    ----------
    name : str
        Of the material, as ``winkler show materials`` lists it.

    Raises
    ------
    InvalidInput
        If the table does not contain the name, or no resistivity of it.

    Examples
    --------
    >>> NamedElectricalConductor("silver").resistivity
    1.587e-08
    """

    __words__ = NamedElastic.__words__

    resistivity: float = dataclasses.field(init=False, default=math.nan)
    temperature_coefficient: float = dataclasses.field(init=False, default=0.0)
    name: str

    def __post_init__(self) -> None:
        _fill(self, material(self.name).electrical_conductor)


@value
class NamedThermalConductor(ThermalConductor):
    """A conductor of heat of the table of materials, by its name.

    Parameters
    ----------
    name : str
        Of the material, as ``winkler show materials`` lists it.

    Raises
    ------
    InvalidInput
        If the table does not contain the name, or no conductivity, density or heat capacity of it.

    Examples
    --------
    >>> round(NamedThermalConductor("copper").diffusivity * 1e6, 1)
    116.2
    """

    __words__ = NamedElastic.__words__

    conductivity: float = dataclasses.field(init=False, default=math.nan)
    diffusivity: float = dataclasses.field(init=False, default=math.nan)
    name: str

    def __post_init__(self) -> None:
        _fill(self, material(self.name).thermal_conductor)
