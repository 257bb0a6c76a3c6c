r"""Stresses and displacements inside a stack of bonded layers whose surface is dragged along x, by Hankel integrals.

The traction :math:`\tau(r)` along x is a superposition of waves in all directions.  A wave that runs at the angle
:math:`\varphi` to x has the part :math:`\cos\varphi` along its direction, which moves depth and surface together (as a
pressure does, `winkler.media.layered.climb`), and :math:`-\sin\varphi` across it, which shears alone.  With the
amplitudes U, W, T, S of the former per traction of one, V and Q (displacement times :math:`\xi`, traction) of the
latter, :math:`A=nS+cU` the stress along and :math:`B=A-2C_{66}U` across the wave, :math:`D=C_{66}V`, the average over
:math:`\varphi` is

.. math::

    \sigma_{rr} &= -\big[A J_1 - (A-B-2D)J_2/x\big]\cos\theta, &
    \sigma_{\theta\theta} &= -\big[B J_1 + (A-B-2D)J_2/x\big]\cos\theta, \\
    \sigma_{r\theta} &= \big[D J_1 + (A-B-2D)J_2/x\big]\sin\theta, & \sigma_{zz} &= -S J_1\cos\theta, \\
    \sigma_{rz} &= \tfrac12\big[(T+Q)J_0+(Q-T)J_2\big]\cos\theta, &
    \sigma_{\theta z} &= -\tfrac12\big[(T+Q)J_0+(T-Q)J_2\big]\sin\theta,

of :math:`x=\xi r`, and so for the displacements.  In the uppermost layer the field of a homogeneous half-space under
the same traction is known otherwise (`winkler.media.interior.shear_field`), and only what the interfaces add is
integrated, as in `winkler.media.layered.coated_interior`.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from winkler.materials.elastic import Elastic, Rigid
from winkler.media.interior import shear_field
from winkler.media.interior.shear_field_punch import ShearField
from winkler.media.layered.across import AcrossState, across_added, across_inside, climbed_across
from winkler.media.layered.coated_interior import WaveState, reaching, refuse_unknown_places, wave_states
from winkler.media.layered.coated_load import CarriedLoad
from winkler.media.layered.hankel_waves import HankelWaves, RadialWaves, reach_of, waves_of
from winkler.media.layered.stack import StackBody
from winkler.media.layered.wave_constants import constants_of
from winkler.numerics.chunks import chunks
from winkler.numerics.transforms.cosine_transform import DECAY_SPAN
from winkler.numerics.types import Array

SHORT_ARGUMENT = 1e-2
"""Up to this J_2(x)/x is taken from its series."""


def field(load: CarriedLoad, body: StackBody, modulus: float, x: Array, y: Array, z: Array) -> ShearField:
    """Return stresses and displacements inside a stack of bonded layers that is dragged along +x.

    Parameters
    ----------
    load : CarriedLoad
        What the traction is over a modulus.
    body : StackBody
        The stack; no layer slides.
    modulus : float
        Of the uppermost layer and the counterpart [Pa]: E* where the traction is that of a pressure, G* of springs that
        are moved along the surface.
    x, y, z : ndarray
        Of one shape [m]; a point on an interface belongs to the upper layer.

    Raises
    ------
    OutsideValidity
        As of `winkler.media.layered.coated_interior.field`.
    """
    shape = np.shape(x)
    x, y, z = (np.ravel(np.asarray(part, dtype=float)) for part in (x, y, z))
    refuse_unknown_places(body, z)
    result = np.zeros((9, x.size))
    if load.radius > 0.0 and x.size:
        top, upper, r = body.top, z <= body.bottoms[0], np.hypot(x, y)
        waves = waves_of(load, modulus, reach_of(load, r), 2.0 * DECAY_SPAN / load.response.length)
        if isinstance(top, Elastic) and upper.any():
            own = shear_field.field(
                load, x[upper], y[upper], z[upper], modulus=modulus, poisson=top.poisson, shear=top.shear
            )
            result[:, upper] = own
        depths = np.unique(z)
        waves = waves.up_to(max(reaching(body, depths, waves.xi)))
        radial = RadialWaves(waves.xi)
        along = wave_states(body, depths, waves.xi, dragged=True)
        across = across_states(body, depths, waves.xi)
        for (depth, state, end), beside in zip(along, across, strict=True):
            (members,) = np.nonzero(z == depth)
            result[:, members] += _superposed(state, beside, waves.up_to(end), radial, x[members], y[members])
    return ShearField(*(part.reshape(shape) for part in result))


def across_states(body: StackBody, depths: Array, xi: Array) -> Iterator[AcrossState]:
    """Yield, depth by depth, the amplitudes of waves across; in the uppermost layer without those of a half-space."""
    layers, on, bottoms = body.layers, body.on, body.bottoms
    below = climbed_across(layers, on, xi)[1:]
    arrived = [np.full(xi.shape, -1.0)]
    for layer, face in zip(layers, below, strict=True):
        stiff, steep = constants_of(layer.solid).impedance
        x = xi * (layer.thickness * steep)
        arrived.append(arrived[-1] * across_inside(face * stiff, x, x).loaded)
    tops = np.concatenate([[0.0], bottoms])
    for depth in depths:
        index = int(np.searchsorted(bottoms, depth))
        solid = layers[index].solid if index < len(layers) else on
        assert not isinstance(solid, Rigid)
        stiff, steep = constants_of(solid).impedance
        start = xi * ((depth - tops[index]) * steep)
        if index == len(layers):
            fade = np.exp(-start)
            state = AcrossState(fade, fade)
        else:
            crossed = across_inside if index else across_added
            state = crossed(below[index] * stiff, xi * (layers[index].thickness * steep), start)
        # tractions of 1 on the surface are stresses of -1
        yield AcrossState(-arrived[index] * state.moved / stiff, arrived[index] * state.loaded)


def _superposed(
    state: WaveState, beside: AcrossState, waves: HankelWaves, radial: RadialWaves, x: Array, y: Array
) -> Array:
    """Return the nine parts of a `ShearField` at one depth."""
    end, r = waves.xi.size, np.hypot(x, y)
    constants = constants_of(state.solid)
    twice = 2.0 * constants.shear * constants.twist
    lengthwise, crosswise, axial, shear, strain, lift = state.weighted(waves.weights)
    aside, turn = beside.moved[:end] * waves.weights, beside.loaded[:end] * waves.weights
    bend = twice * (strain - aside)
    polar = np.empty((9, r.size))
    for part in chunks(r.size, radial.xi.size):
        phase = np.outer(r[part], waves.xi)
        zeroth, first = (values[:, :end] for values in radial.at(r[part]))
        short = phase < SHORT_ARGUMENT
        divisor = np.where(short, 1.0, phase)
        second = np.where(short, phase**2 / 8.0 * (1.0 - phase**2 / 12.0), 2.0 * first / divisor - zeroth)
        ratio = np.where(short, phase / 8.0 * (1.0 - phase**2 / 12.0 * (1.0 - phase**2 / 32.0)), second / divisor)
        bent = ratio @ bend
        polar[:, part] = (
            bent - first @ lengthwise,
            -(first @ crosswise) - bent,
            -(first @ axial),
            first @ (0.5 * twice * aside) + bent,
            0.5 * (zeroth @ (shear + turn) + second @ (turn - shear)),
            -0.5 * (zeroth @ (shear + turn) + second @ (shear - turn)),
            0.5 * (zeroth @ ((strain + aside) / waves.xi) + second @ ((aside - strain) / waves.xi)),
            -0.5 * (zeroth @ ((strain + aside) / waves.xi) + second @ ((strain - aside) / waves.xi)),
            -(first @ (lift / waves.xi)),
        )
    return _cartesian(polar, x, y, r)


def _cartesian(polar: Array, x: Array, y: Array, r: Array) -> Array:
    """Turn amplitudes of cos and sin of the angle in polar axes into the parts of a `ShearField`."""
    c, s = np.where(r > 0.0, x, 1.0) / np.where(r > 0.0, r, 1.0), y / np.where(r > 0.0, r, 1.0)
    rr, tt, zz, rt, rz, tz, u_r, u_t, u_z = polar
    rr, tt, zz, rz, u_r, u_z = rr * c, tt * c, zz * c, rz * c, u_r * c, u_z * c
    rt, tz, u_t = rt * s, tz * s, u_t * s
    parts = {
        "xx_stress": rr * c * c + tt * s * s - 2.0 * rt * s * c,
        "yy_stress": rr * s * s + tt * c * c + 2.0 * rt * s * c,
        "zz_stress": zz,
        "xy_stress": (rr - tt) * s * c + rt * (c * c - s * s),
        "xz_stress": rz * c - tz * s,
        "yz_stress": rz * s + tz * c,
        "x_displacement": u_r * c - u_t * s,
        "y_displacement": u_r * s + u_t * c,
        "z_displacement": u_z,
    }
    return np.array([parts[name] for name in ShearField._fields])
