"""``draw(anything)``: a figure of a shape, a bed, a contact, its fields, or Jaeger's staircase.

Figures are made without pyplot, so nothing is shown or kept behind the scenes: save the figure with ``savefig``, or
let a notebook show it.
"""

from __future__ import annotations

import dataclasses
import functools
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.errors import InvalidInput
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.outcome import Fit
from winkler.fitting.unloading.oliver_pharr import OliverPharrSolution
from winkler.foundation.elliptic import EllipticFoundation
from winkler.foundation.foundation import Foundation
from winkler.foundation.measured import MeasuredBed
from winkler.foundation.plane import PlaneFoundation
from winkler.foundation.sheared_fields import BodyFields, ShearedFields
from winkler.loading import Force
from winkler.media.graded.power_law import GradedHalfSpace
from winkler.media.layered.coated import CoatedHalfSpace
from winkler.media.layered.depth_graded import DepthGradedHalfSpace
from winkler.media.medium import Medium
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.plot import style
from winkler.plot.extent import around, checked_extent, typical
from winkler.plot.fitting.fits import fit_picture
from winkler.plot.fitting.unloading import segments_sheet, unloading_sheet
from winkler.plot.friction.damping import bimodal_sheet, damping_sheet, relaxation_sheet
from winkler.plot.friction.sheets import (
    body_sheet,
    sheared_sheet,
    tangential_sheet,
    tangential_state_sheet,
    torsion_sheet,
    twist_sheet,
)
from winkler.plot.impact.impact import adhesive_impact_sheet, impact_sheet
from winkler.plot.medium import (
    body_is_known,
    draw_makeup,
    draw_spring_stiffness,
    draw_stiffness,
    stiffness_told,
    typical_width,
)
from winkler.plot.method import Contact, draw_bed_makeup, headline
from winkler.plot.normal.body import draw_body, draw_contact
from winkler.plot.normal.curves import (
    draw_curve,
    draw_line_load,
    draw_pressure,
    force_depth,
    load_curves,
)
from winkler.plot.normal.outline import draw_profile
from winkler.plot.normal.punches import draw_pressures, draw_steps
from winkler.plot.normal.springs import at_first_touch, draw_springs
from winkler.plot.normal.stresses import draw_stress
from winkler.plot.particles.elastic_plastic import particle_sheet
from winkler.plot.sheets import SHEETS, contact_sheet
from winkler.problems.adhesion.cycle import AdhesiveCycleSolution
from winkler.problems.adhesion.equilibrium import EquilibriumCurve
from winkler.problems.adhesion.indentation import AdhesiveSolution
from winkler.problems.adhesion.pull_off import PullOffSolution
from winkler.problems.adhesion.shear import AdhesiveShearSolution
from winkler.problems.friction.bimodal_damping import BimodalDampingSolution
from winkler.problems.friction.damping import FrictionDampingSolution
from winkler.problems.friction.relaxation_damping import RelaxationDamperSolution
from winkler.problems.friction.spring_states import SpringState
from winkler.problems.friction.tangential import TangentialSolution
from winkler.problems.friction.tangential_states import TangentialState
from winkler.problems.friction.torsion import TorsionSolution
from winkler.problems.friction.torsion_states import TorsionState
from winkler.problems.impact.adhesive_impact import AdhesiveImpactSolution
from winkler.problems.impact.impact import ImpactSolution
from winkler.problems.normal.indentation import Indentation, IndentationSolution
from winkler.problems.normal.yielding import YieldOnsetSolution
from winkler.problems.particles.elastic_plastic import ParticleSolution
from winkler.profiles.profile import Shape
from winkler.stairs import Staircase

if TYPE_CHECKING:
    from collections.abc import Callable

    from winkler.plot.picture import Picture

__all__ = ["draw"]

DRAWN = (
    "a profile, a Foundation, PlaneFoundation or MeasuredBed, a coated, graded or viscoelastic half-space, a solid "
    "that relaxes, a height map or a spectrum, a solution of a problem, restored fields, a Staircase, a ForceCurve, or "
    "a Fit"
)
CONTRACT = ("height", "gap", "reach", "rim", "size", "kinks")


@functools.singledispatch
def draw(item: Any, *, extent: float | None = None) -> Picture:
    """Return a figure of `item`.

    Parameters
    ----------
    item
        What to draw:

        - a profile: the body in three dimensions, its height f(r) and its plane profile g(x)
        - ``Foundation``, ``PlaneFoundation``: the body, and its plane profile over the springs
        - ``MeasuredBed``: the measured stiffness, and the springs that follow from it
        - ``CoatedHalfSpace``, ``DepthGradedHalfSpace``, ``GradedHalfSpace``: Young's modulus from the surface down, and
          the stiffness of the springs
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
        - solutions of ``Rolling``, ``SimplifiedRolling``: creep forces, and what springs or the surface bear
        - solutions of ``RollingStart``, ``OscillatingRolling``: force on the way, shift over cycles, and the springs
        - a solid that relaxes, ``ViscoelasticHalfSpace``, ``RelaxingInProportion``: relaxation, creep, storage and loss
        - answers for them: loops, forces and energies over time, springs that press or recover, curves over frequency
        - a solution of ``YieldOnset``: the stress where yielding begins, and F(d) up to there
        - ``SurfaceFields``, ``SubsurfaceFields``, ``ShearedFields``, ``BodyFields``: what was restored
        - ``Staircase``: Jaeger's picture of flat punches
        - ``Topography``, spectra, answers for rough surfaces: maps, cuts, spectra, what they bear over the load
        - a ``ForceCurve``: its segments with their names; a solution of ``OliverPharr``: the unloading that was read
        - a ``Fit``: the curve with its model, and the residuals
    extent : float, optional
        Distance from the axis up to which is drawn [m]; chosen to show what matters if left out.

    Returns
    -------
    matplotlib.figure.Figure
        Save it with ``savefig("name.png")`` or ``"name.svg"``; a notebook shows it.

    Raises
    ------
    InvalidInput
        If there is no picture of such an item.

    Examples
    --------
    >>> from winkler.profiles.sphere import Sphere
    >>> draw(Sphere(curvature_radius=10e-3), extent=2e-3)
    <Picture of 8.8 x 3.3 inches; save it with savefig(path)>
    """
    if all(hasattr(item, name) for name in CONTRACT):
        return _profile(item, extent=extent)
    raise InvalidInput(f"draw: there is no picture of a {type(item).__name__}; give {DRAWN}.")


def _sheet(columns: int, rows: int = 1, **sizes: float) -> tuple[Picture, Any]:
    figure = style.figure(columns, rows, **sizes)
    return figure, figure.subplots(rows, columns, squeeze=False).ravel()


@draw.register(Shape)
def _profile(item: Shape, *, extent: float | None = None) -> Picture:
    end = checked_extent(extent) or typical(item)
    with style.styled():
        figure, (left, right) = _sheet(2, height=3.3)
        draw_body(left, item, end)
        draw_profile(right, item, end)
        left.set_title(type(item).__name__)
        right.set_title("shape and equivalent profile")
    return figure


@draw.register(Foundation)
@draw.register(PlaneFoundation)
def _bed(item: Any, *, extent: float | None = None) -> Picture:
    end = checked_extent(extent) or (1.6 if item.rim <= item.reach else 1.0) * typical(item)
    if not body_is_known(item):
        return _outlined(item, extent)
    shape = item.profile if isinstance(item, Foundation) else item.plane_profile
    relaxes = isinstance(item.medium, RelaxingMedium)
    bed = dataclasses.replace(item, medium=item.medium.elastic) if relaxes else item
    with style.styled():
        figure, (left, right) = _sheet(2, height=3.3)
        draw_body(left, bed, end)
        draw_springs(right, at_first_touch(bed), end)
        left.set_title(type(shape).__name__ if isinstance(item, Foundation) else "the body that belongs to $g(x)$")
        right.set_title(f"springs {'that relax' if relaxes else stiffness_told(bed, end)} under $g(x)$")
    return figure


@draw.register(EllipticFoundation)
def _outlined(item: Any, extent: float | None = None) -> Picture:
    """Draw springs that stand for a body that is none of revolution: their load tells no pressure."""
    relaxes = isinstance(item.medium, RelaxingMedium)
    bed = dataclasses.replace(item, medium=item.medium.elastic) if relaxes else item
    end = checked_extent(extent) or typical(bed)
    with style.styled():
        figure, (left, right) = _sheet(2, height=3.3)
        draw_stiffness(left, bed, end)
        draw_springs(right, at_first_touch(bed), end)
        left.set_title("stiffness")
        right.set_title(f"springs {'that relax' if relaxes else stiffness_told(bed, end)} under $g(x)$")
    return figure


@draw.register(MeasuredBed)
def _measured(item: MeasuredBed, *, extent: float | None = None) -> Picture:
    end = checked_extent(extent) or item.reach
    with style.styled():
        figure, (left, middle, right) = _sheet(3, width=3.9, height=3.3)
        draw_bed_makeup(left, middle, item, end)
        draw_springs(right, at_first_touch(item), end)
        left.set_title("measured stiffness")
        middle.set_title("its springs")
        right.set_title("springs under $g(x)$")
    return figure


@draw.register(CoatedHalfSpace)
@draw.register(DepthGradedHalfSpace)
@draw.register(GradedHalfSpace)
def _medium(item: Medium, *, extent: float | None = None) -> Picture:
    end = checked_extent(extent) or typical_width(item)
    with style.styled():
        figure, (left, right) = _sheet(2, height=3.3)
        draw_makeup(left, item, end)
        draw_spring_stiffness(right, item, end)
        left.set_title("the body, from its surface down")
        right.set_title("stiffness of the springs")
    return figure


@draw.register(IndentationSolution)
def _indentation(item: IndentationSolution, *, extent: float | None = None) -> Picture:
    return _one_load(item, extent) if np.ndim(item.depth) == 0 else _many_loads(item, extent)


def _one_load(item: IndentationSolution, extent: float | None) -> Picture:
    end, bed = around(item.pressed, extent), item.pressed.bed
    known = body_is_known(bed)
    with style.styled():
        figure, panels = _sheet(2, 2, height=3.2)
        draw_springs(panels[1], item.pressed, end)
        draw_line_load(panels[2], item, end, float(item.force))
        if known:
            draw_contact(panels[0], item, end)
            draw_pressure(panels[3], item, end, float(item.mean_pressure))
        else:
            draw_stiffness(panels[0], bed, end, float(item.radius))
            _force_curve(panels[3], item)
        for axes, title in zip(
            panels,
            (
                "the contact" if known else "measured stiffness" if isinstance(bed, MeasuredBed) else "stiffness",
                "springs under $g(x) − d$",
                "load of the springs $q(x)$",
                "pressure $p(r)$" if known else "force over depth",
            ),
            strict=True,
        ):
            axes.set_title(title)
        figure.suptitle(headline(item))
    return figure


def _force_curve(axes: Any, item: IndentationSolution) -> None:
    """Draw F(d) up to a contact, and the contact itself as a point."""
    if float(item.depth) <= 0.0:
        style.note(axes, "no contact", where="upper centre")
        return
    curve = force_depth(item.pressed)
    draw_curve(axes, curve, marker="")
    across, upright = curve.along.scale.factor, curve.of.scale.factor
    axes.plot([float(item.depth) / across], [float(item.force) / upright], "o", color=style.RED, clip_on=False)
    axes.set_ylim(0.0, None)


def _many_loads(item: Contact, extent: float | None) -> Picture:
    if extent is not None:
        raise InvalidInput(
            "draw: curves over many loads have no extent; leave it out, or pick one load: solution.at(0)."
        )
    curves = load_curves(item)
    with style.styled():
        figure, panels = _sheet(len(curves), width=3.7)
        for axes, (name, curve), colour in zip(panels, curves.items(), style.CYCLE, strict=False):
            draw_curve(axes, curve, colour)
            axes.set_ylim(min(0.0, axes.get_ylim()[0]) if np.min(curve.of.content) < 0.0 else 0.0, None)
            axes.set_title(f"{name.replace('radius', 'contact radius')} over depth")
    return figure


@draw.register(AdhesiveSolution)
def _adhesive(item: AdhesiveSolution, *, extent: float | None = None) -> Picture:
    return contact_sheet(item, extent) if np.ndim(item.depth) == 0 else _many_loads(item, extent)


@draw.register(EquilibriumCurve)
@draw.register(AdhesiveCycleSolution)
@draw.register(AdhesiveShearSolution)
@draw.register(PullOffSolution)
def _sticking(item: Any, *, extent: float | None = None) -> Picture:
    if extent is not None:
        raise InvalidInput(f"draw: the curves of a {type(item).__name__} have no extent; leave it out.")
    return SHEETS[type(item)](item)


WITHOUT_EXTENT: dict[type, Callable[[Any], Picture]] = {
    TangentialSolution: tangential_sheet,
    TorsionSolution: torsion_sheet,
    TorsionState: twist_sheet,
    FrictionDampingSolution: damping_sheet,
    BimodalDampingSolution: bimodal_sheet,
    RelaxationDamperSolution: relaxation_sheet,
    ImpactSolution: impact_sheet,
    AdhesiveImpactSolution: adhesive_impact_sheet,
    ParticleSolution: particle_sheet,
    ShearedFields: sheared_sheet,
    BodyFields: body_sheet,
    ForceCurve: segments_sheet,
    OliverPharrSolution: unloading_sheet,
}
"""Sheets that have no extent."""


def _without_extent(item: Any, *, extent: float | None = None) -> Picture:
    if extent is not None:
        raise InvalidInput(f"draw: the curves of a {type(item).__name__} have no extent; leave it out.")
    return WITHOUT_EXTENT[type(item)](item)


for _kind in WITHOUT_EXTENT:
    draw.register(_kind)(_without_extent)


@draw.register(TangentialState)
@draw.register(SpringState)
def _dragged(item: TangentialState | SpringState, *, extent: float | None = None) -> Picture:
    return tangential_state_sheet(item, checked_extent(extent))


@draw.register(YieldOnsetSolution)
def _onset(item: YieldOnsetSolution, *, extent: float | None = None) -> Picture:
    contact = Indentation(item.problem.bed, Force(item.force)).solve()
    with style.styled():
        figure, (left, right) = _sheet(2, width=5.0, height=3.3)
        draw_stress(left, contact, around(contact.pressed, extent), item.radius)
        left.set_title("stress where yielding begins")
        curve = force_depth(contact.pressed)
        draw_curve(right, curve, marker="", label="elastic")
        across, upright = curve.along.scale.factor, curve.of.scale.factor
        right.plot([item.depth / across], [item.force / upright], "o", color=style.RED, label="yielding begins")
        right.set_xlim(0.0, 1.15 * item.depth / across)
        right.set_ylim(0.0, 1.15 * item.force / upright)
        style.framed_legend(right, loc="upper left")
        right.set_title("force over depth")
        figure.suptitle(f"onset of yield:   {headline(item)}")
    return figure


@draw.register(Staircase)
def _stairs(item: Staircase, *, extent: float | None = None) -> Picture:
    if item.radii.size == 0:
        raise InvalidInput("draw: the bodies do not touch, so there are no punches to show; give more load.")
    end = checked_extent(extent) or 1.25 * item.pressed.radius
    with style.styled():
        figure, (left, right) = _sheet(2, height=3.3)
        draw_steps(left, item, end)
        draw_pressures(right, item, end)
        left.set_title("a staircase of flat punches")
        right.set_title("their pressures add up")
    return figure


@draw.register(Fit)
def _fit(item: Fit, *, extent: float | None = None) -> Picture:
    if extent is not None:
        raise InvalidInput("draw: a Fit is drawn over all its positions; leave extent out.")
    return fit_picture(item)
