"""What each flag of a fit means, and what to do about it."""

from __future__ import annotations

REFUSING_FLAGS = {
    "disagree": "the curves differ more in shared numbers than their noise allows: fit each, and state the scatter",
    "few_points": "too few points: give the whole curve",
    "no_contact": "the force is nowhere more than its noise: leave the curve out",
    "reversed": "force or position has the wrong sign: change it",
    "saturated": "the detector was at its end: add saturation to correct",
    "units": "longer or stronger than an indenter can be: state the units",
}
"""Flags with which a curve is refused."""
FLAG_MEANINGS = {
    "misfit": "residuals are more than the noise: the model does not explain the curve",
    "memory": "the noise is slow: fewer than five independent points for each number",
    "not_white": "noise was stated to be white, but residuals are slow: leave noise_spectrum out",
    "at_bound": "a number has reached its bound; its error has no meaning: widen the bound, or fix the number",
    "undetermined": "a number is less than its own error: fix it, or give more of the curve",
    "correlated": "two parameters have nearly the same effect: fix one of them",
    "no_baseline": "hardly a point out of contact: contact point and zero of force are uncertain",
    "pop_in": "the depth or force jumps while the tip is pressed in: fit the part before the first pop-in",
    "jump": "a jump-in or pull-off takes time: its points were left out; the work may depend on the speed",
    "too_slow": "a relaxation time is longer than the contact: hold longer, or use one term fewer",
    "too_fast": "a relaxation time is shorter than the sampling: only the viscosity is determined",
    "collapsed": "two relaxation times are one within their errors: use one term fewer",
    "vanished": "a term of the relaxation is negligible: use one term fewer",
    "span": "the series of a power law does not cover the measured times: widen shortest and longest",
    "disagree": "curves fitted together differ by more than their noise: look at each, or share fewer numbers",
    "drag": "approach and retraction differ out of contact: free drag, or correct it",
}
"""Flags that stand beside the numbers of a fit."""
