r"""Does a contact stay elastic?  One statement for every problem whose bodies have a strength.

The greatest von Mises stress L of the frictionless contact bounds from below what friction makes of it: the contact
sheared in the opposite direction is its mirror image, and the stress of their mean is not greater than theirs.  Where
all of the contact slides with the coefficient :math:`\mu` it is U (`winkler.problems.normal.greatest_stress`); under
partial slip the traction is smaller.  So with the strength Y

.. math:: U < Y: \text{elastic}, \qquad L \ge Y: \text{yields}, \qquad L < Y \le U: \text{yields if all of it slides} .
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.foundation.bed import Bed, PressedSprings
from winkler.foundation.footprint import EllipticOutline
from winkler.foundation.foundation import Foundation
from winkler.media.halfspace import HalfSpace
from winkler.media.offers import LayerStack, offers
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.numerics.types import Array
from winkler.problems.normal.greatest_stress import GreatestStress, greatest_stress
from winkler.problems.normal.solve_contact import at_depth, flat_radius
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.problems.normal.unknown_yield import MISES, unknown_yield
from winkler.profiles.power import Paraboloid
from winkler.values.errors import NotConverged, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing

SACKFIELD = "A. Sackfield, D. A. Hills, J. Strain Anal. 18 (1983) 107-110, doi:10.1243/03093247V182107"
HAMILTON = "G. M. Hamilton, Proc. Inst. Mech. Eng. C 197 (1983) 53, doi:10.1243/PIME_PROC_1983_197_076_02"
RADIUS_SHARES = (0.25, 0.5, 0.75, 1.0)
"""Parts of the contact radius that are examined where the profile may fall."""
SLIDING_ROUNDING = 1e-9
"""By which part the shear force may fall short of what friction bears where all slides: rounding."""


class SurfaceFriction(NamedTuple):
    """What is known of the friction in a contact.

    Parameters
    ----------
    coefficient : float
        Greatest traction over pressure [-]; infinite where nothing slips or nothing is known.
    slid : float
        Depth of the deepest contact [m] of which it is known that all of it slid; infinite if it always does.
    kinetic : float
        Traction over pressure where it slid [-]; the coefficient itself if not a number.
    """

    coefficient: float = 0.0
    slid: float = 0.0
    kinetic: float = math.nan


FRICTIONLESS = SurfaceFriction()


def yield_notes_of_bed(
    bed: Bed, depth: Array, radius: Array, rubbing: SurfaceFriction = FRICTIONLESS
) -> tuple[Note, ...]:
    """Return whether the deepest of several contacts stays elastic; nothing where no body has a strength.

    Parameters
    ----------
    bed : Bed
    depth, radius : ndarray, (m,)
        [m].
    rubbing : SurfaceFriction
    """
    depths, radii = np.ravel(depth), np.ravel(radius)
    if not np.any(radii > 0.0):
        return ()
    if not strong_parts(bed.medium):  # the springs of a height map hold only the medium it was pressed into
        return unknown_yield(getattr(bed, "pressed_into", None), "the bed does not define the outline of the contact")
    last = int(np.argmax(depths))
    widest = PressedSprings(bed, float(depths[last]), float(radii[last]))
    contacts = [widest]
    if not bed.rising and widest.radius < bed.rim:  # a falling profile may be stressed more under less load
        earlier = np.array(RADIUS_SHARES[:-1]) * widest.radius
        opened = earlier[earlier > flat_radius(bed)]
        gaps = bed.gap(opened)
        contacts += [PressedSprings(bed, float(d), float(a)) for d, a in zip(gaps, opened, strict=True) if d > 0.0]
    return yield_notes(contacts, rubbing)


def yield_notes(contacts: list[PressedSprings], rubbing: SurfaceFriction = FRICTIONLESS) -> tuple[Note, ...]:
    """Return whether the parts that have a strength stay elastic in all of these contacts of one bed.

    Parameters
    ----------
    contacts : list of PressedSprings
        The deepest first.
    rubbing : SurfaceFriction

    Returns
    -------
    tuple of Note
        One of two half-spaces, that of the body which comes nearer to its strength; one of every part of other media.
    """
    medium = contacts[0].bed.medium
    verdicts = [_verdict(contacts, part, rubbing) for part in strong_parts(medium)]
    if isinstance(medium, HalfSpace):
        order = list(Standing)
        verdicts = [max(verdicts, key=lambda verdict: (order.index(verdict.standing), verdict.share))]
    return tuple(Note(Assumption.ELASTIC, verdict.standing, verdict.statement, verdict.source) for verdict in verdicts)


class _Verdict(NamedTuple):
    standing: Standing
    share: float
    statement: str
    source: str


def _verdict(contacts: list[PressedSprings], part: StrongPart, rubbing: SurfaceFriction) -> _Verdict:
    """Return what is known of one part; the share is that of its strength."""
    try:
        _refuse_relaxing(contacts[0])
        plain = max((greatest_stress(contact, part) for contact in contacts), key=lambda stress: stress.value)
    except (OutsideValidity, NotConverged) as error:
        why = str(error).rstrip(".")
        unknown = f"The onset of yield of the {part.name} is not known because its stresses are not: {why}."
        return _Verdict(Standing.APPROXIMATE, 0.0, unknown, MISES)
    share = plain.value / part.solid.strength
    if share >= 1.0 or rubbing.coefficient == 0.0:
        added = ", and friction adds to it" if rubbing.coefficient > 0.0 else ""
        return _frictionless(contacts[0], part, plain, share, added)
    lower = f"without friction the greatest von Mises stress is {share_of(share, part)}"
    why = _friction_unknown(contacts[0], rubbing)
    if why:
        return _Verdict(Standing.APPROXIMATE, share, f"The onset of yield is not known because {why}; {lower}.", MISES)
    return _rubbed(contacts[0], part, rubbing, share, lower)


def _refuse_relaxing(pressed: PressedSprings) -> None:
    if offers(pressed.bed.medium, RelaxingMedium):
        raise OutsideValidity("the stresses in a relaxing body follow the history of the load.")


def _friction_unknown(pressed: PressedSprings, rubbing: SurfaceFriction) -> str:
    """Return why the stresses under friction are not known, or nothing."""
    medium = pressed.bed.medium
    if not (
        isinstance(medium, HalfSpace) or (offers(medium, LayerStack) and all(layer.bonded for layer in medium.stack))
    ):
        return f"the stresses of a traction inside a {type(medium).__name__} are not computed"
    if math.isinf(rubbing.coefficient):
        return "no coefficient of friction limits the traction"
    return ""


def _resolved(pressed: PressedSprings) -> Standing:
    """Return whether the stresses are known everywhere, or in layers rounded off next to the edge."""
    medium = pressed.bed.medium
    if not offers(medium, LayerStack):
        return Standing.EXACT
    from winkler.media.layered.hankel_waves import blurred  # loaded with layers

    return Standing.ASYMPTOTIC if blurred(medium.layers[0].thickness, pressed.radius) else Standing.EXACT


def _frictionless(
    pressed: PressedSprings, part: StrongPart, largest: GreatestStress, share: float, added: str
) -> _Verdict:
    where = f"{share_of(share, part)}, at r = {largest.x:.3g} m, z = {_signed(part, largest.z):.3g} m"
    load = _onset_of_ball(pressed, share)
    if largest.sharp:
        return _at_sharp(part, largest, share, "")
    if share < 1.0:
        onset = f"yielding begins at {load:.4g} N; " if load else ""
        return _Verdict(
            _resolved(pressed),
            share,
            f"By von Mises' criterion {onset}the contact stays elastic: its greatest stress is {where}.",
            MISES,
        )
    onset = f"began at {load:.4g} N" if load else "has begun"
    return _Verdict(
        Standing.OUTSIDE,
        share,
        f"By von Mises' criterion yielding {onset}: the greatest elastic stress is {where}{added}; "
        f"{'beyond it ' if load else ''}the result is not elastic.",
        MISES,
    )


def _rubbed(pressed: PressedSprings, part: StrongPart, rubbing: SurfaceFriction, plain: float, lower: str) -> _Verdict:
    """Return what is known of a contact with friction that without it would stay elastic."""
    mu = rubbing.coefficient
    source = SACKFIELD if isinstance(pressed.bed.footprint, EllipticOutline) else HAMILTON
    kinetic = mu if math.isnan(rubbing.kinetic) else rubbing.kinetic
    most = greatest_stress(pressed, part, mu)
    bound = most.value / part.solid.strength
    where = f"at x = {most.x:.3g} m, z = {_signed(part, most.z):.3g} m"
    if bound < 1.0 and not most.sharp:
        statement = (
            "By von Mises' criterion the contact stays elastic, and would if all of it slid with the coefficient "
            f"{mu:.3g}: the greatest stress would then be {share_of(bound, part)}, {where}."
        )
        return _Verdict(_resolved(pressed), bound, statement, source)
    slid = most
    if 0.0 < rubbing.slid < pressed.depth:
        radius = float(at_depth(pressed.bed, np.array([rubbing.slid]))[1][0])
        slid = greatest_stress(PressedSprings(pressed.bed, rubbing.slid, radius), part, kinetic)
    elif kinetic != mu:
        slid = greatest_stress(pressed, part, kinetic)
    share = slid.value / part.solid.strength
    if most.sharp:
        return _at_sharp(part, slid if rubbing.slid > 0.0 else most, share if rubbing.slid > 0.0 else plain, "friction")
    if rubbing.slid > 0.0 and share >= 1.0:
        statement = (
            f"By von Mises' criterion yielding has begun: where all slides with the coefficient {kinetic:.3g}, the "
            f"greatest elastic stress is {share_of(share, part)}, at x = {slid.x:.3g} m, z = "
            f"{_signed(part, slid.z):.3g} m; the result is not elastic."
        )
        return _Verdict(Standing.OUTSIDE, share, statement, source)
    statement = (
        f"The onset of yield is not known because it depends on how much of the contact slides: {lower}, if all of it "
        f"slid with the coefficient {mu:.3g} it would be {bound:.3g}, {where}."
    )
    return _Verdict(Standing.APPROXIMATE, bound, statement, source)


def _at_sharp(part: StrongPart, largest: GreatestStress, share: float, friction: str) -> _Verdict:
    """Return what is known where the elastic stress is infinite in a point or along a circle."""
    own = largest.sharp[0].upper() + largest.sharp[1:]
    beyond = f"a tenth of the contact radius away from there the greatest von Mises stress is {share_of(share, part)}"
    if share >= 1.0:
        return _Verdict(Standing.OUTSIDE, share, f"{own}; and {beyond}: the result is not elastic.", MISES)
    unsaid = ", without what friction adds" if friction else ""
    return _Verdict(Standing.APPROXIMATE, share, f"{own}; {beyond}{unsaid}.", MISES)


def share_of(share: float, part: StrongPart) -> str:
    """Return a stress as a share or a multiple of the strength, for a sentence."""
    return f"{share:.3g} {'times' if share >= 1.0 else 'of'} the strength of the {part.name}"


def elastic_note(share: float, where: str, standing: Standing, onset: str = "") -> Note:
    """Return whether bodies stay elastic whose greatest stress is a share of a strength, stated with its place.

    Parameters
    ----------
    share : float
        Of the strength [-].
    where : str
        The stress as a share, and its place.
    standing : Standing
        If it is less than one.
    onset : str
        The load at which yielding begins, where that is known.
    """
    if share < 1.0:
        begins = f"yielding begins at {onset}; " if onset else ""
        text = f"By von Mises' criterion {begins}the contact stays elastic: its greatest stress is {where}."
        return Note(Assumption.ELASTIC, standing, text, MISES)
    began = f"began at {onset}" if onset else "has begun"
    text = (
        f"By von Mises' criterion yielding {began}: the greatest elastic stress is {where}; the result is not elastic."
    )
    return Note(Assumption.ELASTIC, Standing.OUTSIDE, text, MISES)


def _signed(part: StrongPart, depth: float) -> float:
    return depth if part.first else -depth


def _onset_of_ball(pressed: PressedSprings, share: float) -> float:
    """Return the force at which a ball or an ellipse on half-spaces begins to yield [N], as the cube of the stress."""
    bed = pressed.bed
    ball = isinstance(bed, Foundation) and isinstance(bed.profile, Paraboloid)
    if type(pressed) is not PressedSprings or not (ball or isinstance(bed.footprint, EllipticOutline)):
        return 0.0
    if not isinstance(bed.medium, HalfSpace):
        return 0.0
    return 4.0 / 3.0 * bed.medium.modulus * pressed.radius * pressed.depth / share**3


def slid_depth(coefficient: float, depth: Array, force: Array, shear_force: Array) -> float:
    """Return the depth [m] of the deepest contact whose shear force is all that friction bears; zero if there is none.

    Parameters
    ----------
    coefficient : float
    depth, force : ndarray, (m,)
        [m], [N].
    shear_force : ndarray, (m,) or (m, 2)
        [N].
    """
    sheared = np.hypot(*shear_force.T) if shear_force.ndim > force.ndim else np.abs(shear_force)
    if not 0.0 < coefficient < math.inf:
        return 0.0
    slid = (force > 0.0) & (sheared >= (1.0 - SLIDING_ROUNDING) * coefficient * force)
    return float(np.max(np.where(slid, depth, 0.0), initial=0.0))
