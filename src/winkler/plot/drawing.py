"""``draw(anything)``: a figure of a shape, a bed, a contact, its fields, or Jaeger's staircase.

Figures are made without pyplot, without global state: save the figure with ``savefig``, or
let a notebook show it.
"""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any, overload

import numpy as np

from winkler.fields.punch_staircase import Staircase
from winkler.loading.loads import Force
from winkler.media.halfspace import HalfSpace
from winkler.plot.curves import curves_panel
from winkler.plot.dispatch import sheet_of
from winkler.plot.extent import around, checked_extent, typical
from winkler.plot.normal.body import body_panel
from winkler.plot.normal.curves import (
    curve_panel,
    force_depth,
)
from winkler.plot.normal.outline import profile_panel
from winkler.plot.normal.punches import pressures_panel, steps_panel
from winkler.plot.normal.sliding_onset import sliding_stress_panel
from winkler.plot.normal.stresses import stress_panel
from winkler.plot.panel import Sheet, points, titled
from winkler.plot.series import headline, row_of
from winkler.plot.sheets import contact_sheet
from winkler.problems.adhesion.indentation import AdhesiveSolution
from winkler.problems.normal.indentation import Indentation, IndentationSolution
from winkler.problems.normal.yielding import YieldOnsetSolution
from winkler.profiles.profile import Shape
from winkler.values.errors import InvalidInput

if TYPE_CHECKING:
    from matplotlib.figure import FigureBase

    from winkler.plot.picture import Picture
    from winkler.plot.render import Place


@overload
def draw(item: Any, *, extent: float | None = None, ax: None = None) -> Picture: ...


@overload
def draw(item: Any, *, extent: float | None = None, ax: Place) -> FigureBase: ...


def draw(item: Any, *, extent: float | None = None, ax: Place | None = None) -> Picture | FigureBase:
    """Return a figure of `item`.

    Parameters
    ----------
    item
        What to draw:

        - a profile: the body in three dimensions, its height f(r) and its plane profile g(x)
        - ``Foundation``, ``PlaneFoundation``: the body, and its plane profile over the springs
        - ``MeasuredBed``: the measured stiffness, and the springs that follow from it
        - ``CoatedHalfSpace``, ``SlidingFilm``, ``StackedHalfSpace``, ``DepthGradedHalfSpace``,
          ``GradedHalfSpace``: Young's modulus from the surface down, and the stiffness of the springs
        - a solution for one load: the body in its dent, the springs, their load q(x), the pressure p(r)
        - a solution for many loads: force, contact radius and stiffness over the depth
        - a solution of ``AdhesiveIndentation`` for one load: the body in its dent, the springs, stretched at the edge,
          the pressure, and the states of equilibrium around it; for many loads the curves over the depth
        - solutions of ``Equilibrium``, ``AdhesiveCycle``, ``AdhesiveShear``, ``PullOff``: their curves, branches, jumps
        - a solution of ``Tangential`` or ``Torsion``: the loop, forces and energies along the path, and how the last
          contact sticks and slips; of one state of ``Tangential`` the springs, traction, slip and stress
        - solutions of ``FrictionDamping``, ``BimodalDamping``, ``RelaxationDamper``: the loss over amplitude or phase
        - solutions of ``Impact`` and ``AdhesiveImpact``: forces, velocities, contact and energies over time
        - a solution of ``ElasticPlasticParticle``: force and contact radius over the depth, and where yield begins
        - a solution of ``PlasticIndentation``: the same, and the dent under the greatest load and after it; of
          ``DentLimit`` and ``StrengthFromDent``: this of the load that they name
        - a solution of ``LinePlasticIndentation``: half-width and mean pressure over the force per length, and the dent
        - a solution of ``PlasticImpact``: of one velocity the same; of many restitution, dent and time over it
        - solutions of ``Rolling``, ``SimplifiedRolling``: creep forces, loads of the springs or tractions
        - solutions of ``RollingStart``, ``OscillatingRolling``: force over distance, shift over cycles, and the springs
        - a solid that relaxes, ``ViscoelasticHalfSpace``, ``RelaxingInProportion``: relaxation, creep, storage and loss
        - ``ViscoelasticCoatedHalfSpace``, ``PoroelasticFilm``: creep under waves of pressure that are short or long
          against the layers
        - solutions for them: loops, forces and energies over time, springs that press or recover, curves over frequency
        - a solution of ``YieldOnset``: the stress where yielding begins, and F(d) up to there
        - ``SurfaceFields``, ``SubsurfaceFields``, ``ShearedFields``, ``BodyFields``: restored fields
        - ``Staircase``: Jaeger's picture of flat punches
        - ``Topography``, spectra, solutions for rough surfaces: maps, sections, spectra, results over the load
        - a ``ForceCurve``: its segments with their names; a solution of ``OliverPharr``: the evaluated unloading
        - a ``Fit``: the curve with its model, and the residuals
        - any other solution, also of a problem of your own: its numbers over load, time or distance, or its contact
    extent : float, optional
        Distance from the axis up to which is drawn [m]; chosen automatically if left out.
    ax : matplotlib Axes, list of Axes, Figure or SubFigure, optional
        Where to draw, in the style that it has: one of the axes for each panel of the picture, or a figure or
        sub-figure, which is divided; a figure of its own if left out.

    Returns
    -------
    matplotlib.figure.Figure or SubFigure
        Save it with ``savefig("name.png")`` or ``"name.svg"``; a notebook shows it. If `ax` is given, its figure.

    Raises
    ------
    InvalidInput
        If there is no picture of such an item, or `ax` has another number of axes than the picture has panels.

    Examples
    --------
    >>> from winkler.profiles.sphere import Sphere
    >>> draw(Sphere(curvature_radius=10e-3), extent=2e-3)
    <Picture of 8.8 x 3.3 inches; save it with savefig(path)>
    """
    from winkler.plot.render import render, render_into  # matplotlib is loaded by the first figure

    sheet = sheet_of(item, extent=extent)
    return render(sheet) if ax is None else render_into(sheet, ax)


@sheet_of.register(Shape)
def _profile(item: Shape, *, extent: float | None = None) -> Sheet:
    end = checked_extent(extent) or typical(item)
    panels = titled(
        (body_panel(item, end), profile_panel(item, end)), type(item).__name__, "shape and equivalent profile"
    )
    return Sheet(panels, height=3.3)


@sheet_of.register(IndentationSolution)
@sheet_of.register(AdhesiveSolution)
def _indentation(item: IndentationSolution | AdhesiveSolution, *, extent: float | None = None) -> Sheet:
    return contact_sheet(item, extent) if np.ndim(item.depth) == 0 else _curves_sheet(item, extent)


def _curves_sheet(item: IndentationSolution | AdhesiveSolution, extent: float | None) -> Sheet:
    if extent is not None:
        raise InvalidInput(
            "draw: curves over many loads have no extent; leave it out, or pick one load: solution.at(0)."
        )
    names = {"force": "force", "radius": "contact radius"}
    names |= {} if isinstance(item, AdhesiveSolution) else {"stiffness": "stiffness"}
    panels = [curves_panel(row_of(item, "depth"), [(row_of(item, name), "")]) for name in names]
    return Sheet(titled(panels, *(f"{words} over depth" for words in names.values())), width=3.7)


@sheet_of.register(YieldOnsetSolution)
def _onset(item: YieldOnsetSolution, *, extent: float | None = None) -> Sheet:
    contact = Indentation(item.problem.bed, Force(item.force)).solve()
    to = around(contact.pressed, extent)
    plain = item.problem.friction.coefficient == 0.0 and isinstance(item.problem.bed.medium, HalfSpace)
    left = stress_panel(contact, to, item.radius) if plain else sliding_stress_panel(item, contact.pressed, to)
    curve = curve_panel(force_depth(contact.pressed), marker="", name="elastic")
    right = curve.plus(
        points(item.depth, item.force, name="yielding begins"),
        across=dataclasses.replace(curve.across, low=0.0, high=1.15 * item.depth),
        upright=dataclasses.replace(curve.upright, low=0.0, high=1.15 * item.force),
        legend="upper left",
    )
    panels = titled((left, right), "stress where yielding begins", "force over depth")
    return Sheet(panels, width=5.0, height=3.3, title=f"onset of yield:   {headline(item)}")


@sheet_of.register(Staircase)
def _staircase(item: Staircase, *, extent: float | None = None) -> Sheet:
    if item.radii.size == 0:
        raise InvalidInput("draw: the bodies do not touch, so there are no punches to show; increase the load.")
    end = checked_extent(extent) or 1.25 * item.pressed.radius
    panels = steps_panel(item, end), pressures_panel(item, end)
    return Sheet(titled(panels, "a staircase of flat punches", "their pressures add up"), height=3.3)
