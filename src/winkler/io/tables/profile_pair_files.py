"""Two profiles in files, of a wheel and a rail or of other bodies that touch: read and compared."""

from __future__ import annotations

import os

import numpy as np

from winkler.io.foreign import path_text
from winkler.io.tables.cross_profile_file import read_cross_profile
from winkler.profiles.sections.cross_profile import CrossProfile
from winkler.values.errors import InvalidInput

PLACES = 2001
Path = str | os.PathLike[str]


def read_profile_pair(
    first: Path,
    second: Path,
    *,
    down: bool | tuple[bool, bool] = False,
    mirrored: bool | tuple[bool, bool] = False,
    smoothing: float = 0.0,
    lateral: float = 0.0,
    unit: str = "",
) -> tuple[CrossProfile, CrossProfile]:
    """Read the profiles of two bodies, and refuse them where the upper one would not stand on the lower one.

    Parameters
    ----------
    first, second : str or path
        Of the lower and of the upper body, as in `read_cross_profile`: tables, Simpack's .prr and .prw, MiniProf's
        .ban and .whl.
    down : bool or tuple of bool, optional
        Whether z counts downwards, in both files or in the first and in the second.
    mirrored : bool or tuple of bool, optional
        Whether y is to change its sign, in both or in each.
    smoothing : float, optional
        As in `CrossProfile` [m].
    lateral : float, optional
        Lateral position of y = 0 of the upper profile, as in `ProfilePair` [m].
    unit : str, optional
        Of y and z in both files, where these are two columns without a header, as in `read_cross_profile`.

    Returns
    -------
    tuple of CrossProfile
        The lower and the upper profile.

    Raises
    ------
    InvalidInput
        If a file cannot be read, the profiles stand beside each other, or are nearest at an end of them, as profiles
        that are upside down are.

    Examples
    --------
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> import numpy as np
    >>> with TemporaryDirectory() as folder:
    ...     for name, sign in (("rail.csv", 1.0), ("wheel.csv", -1.0)):
    ...         rows = [f"{y},{sign * y * y / 600.0}" for y in np.linspace(-30.0, 30.0, 31)]
    ...         _ = Path(folder, name).write_text("y [mm],z [mm]" + chr(10) + chr(10).join(rows))
    ...     rail, wheel = read_profile_pair(Path(folder, "rail.csv"), Path(folder, "wheel.csv"), down=True)
    >>> round(float(wheel.height(np.array(0.03))), 4)
    0.0015
    """
    turned, flipped = ((each, each) if isinstance(each, bool) else each for each in (down, mirrored))
    lower, upper = (
        read_cross_profile(file, down=is_down, mirrored=is_mirrored, smoothing=smoothing, unit=unit)
        for file, is_down, is_mirrored in zip((first, second), turned, flipped, strict=True)
    )
    where = f"{path_text(first)} and {path_text(second)}"
    low, high = max(lower.ends[0], lateral + upper.ends[0]), min(lower.ends[1], lateral + upper.ends[1])
    if not low < high:
        raise InvalidInput(
            f"{where}: the profiles do not meet: the lower one goes from {lower.ends[0]:.6g} m to "
            f"{lower.ends[1]:.6g} m, the upper one from {lateral + upper.ends[0]:.6g} m to "
            f"{lateral + upper.ends[1]:.6g} m; give another lateral position, or check the units."
        )
    y = np.linspace(low, high, PLACES)[1:-1]
    nearest = int(np.argmin(upper.height(y - lateral) - lower.height(y)))
    if nearest in (0, y.size - 1):
        raise InvalidInput(
            f"{where}: the profiles are nearest at an end of them, at y = {y[nearest]:.6g} m; if heights count "
            "downwards in a file, give down=True, or down=(first, second); else give another lateral position, or "
            "longer profiles."
        )
    return lower, upper
