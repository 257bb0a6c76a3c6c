"""The reference solutions of this folder compute with 40 digits, whatever other tests have set."""

from __future__ import annotations

import mpmath as mp
import pytest


@pytest.fixture(autouse=True)
def _forty_digits():
    with mp.workdps(40):
        yield
