"""All caches of winkler for layered media, to be cleared before a round."""

from __future__ import annotations

from winkler.media.layered import (
    coated_interior,
    coated_load,
    depth_recursion,
    depth_response,
    flat_punch,
    punch_facts,
)
from winkler.numerics.transforms import cosine_transform, fredholm, kernel_matrix, punch_tables
from winkler.problems.normal import greatest_stress, single_contact

PAGES = (
    cosine_transform,
    fredholm,
    kernel_matrix,
    punch_tables,
    flat_punch,
    punch_facts,
    coated_interior,
    coated_load,
    depth_recursion,
    depth_response,
    greatest_stress,
    single_contact,
)


def forget() -> None:
    """Empty every table of flat punches, so that each round begins from nothing."""
    for page in PAGES:
        for thing in vars(page).values():
            if hasattr(thing, "cache_clear"):
                thing.cache_clear()
