"""Names that instruments give to position, depth, force, time and stiffness, in lower case.

Where a file has several of them, a name of two or more words counts before one of a single word, then the order here.
"""

from __future__ import annotations

from collections.abc import Sequence

CROSSHEAD_NAMES = (
    "extension",
    "standard travel",
    "crosshead displacement",
    "standardweg",
    "traversenweg",
    "course standard",
    "recorrido estándar",
    "corsa standard",
    "stroke",
    "course traverse",
)
"""Travel of a testing machine, which has no cantilever."""
POSITION_NAMES = (
    "position",
    "piezo",
    "stage",
    "z",
    "displacement",
    "travel",
    "z-piezo",
    "calc ramp",
    "calc_ramp",
    *CROSSHEAD_NAMES,
    "weg",
    "allongement",
    "déplacement",
    "verschiebung",
    "desplazamiento",
    "spostamento",
    "位移",
    "変位",
)
"""Travel of a machine whose cantilever bends."""
DEPTH_NAMES = (
    "depth",
    "indentation",
    "penetration",
    "d",
    "h",
    "pd",
    "disp",
    "displacement into surface",
    "indentation depth",
    "penetration depth",
    "sample displacement",
    "sample displace",
    "indent disp.",
    "eindringtiefe",
    "tiefe",
    "profondeur",
    "profundidad",
    "压入深度",
    "压痕深度",
    "深度",
    "押込み深さ",
    "押し込み深さ",
    "深さ",
)
"""Travel of the tip."""
FORCE_NAMES = (
    "force",
    "load",
    "f",
    "p",
    "fn",
    "fz",
    "normal force",
    "load on sample",
    "force on surface",
    "real force",
    "indent load",
    "indent act. load",
    "force a",
    "standard force",
    "kraft",
    "normalkraft",
    "standardkraft",
    "last",
    "charge",
    "fuerza",
    "carga",
    "force standard",
    "fuerza estándar",
    "forza standard",
    "载荷",
    "力",
    "荷重",
    "試験力",
)
TIME_NAMES = (
    *(
        "time",
        "t",
        "time on sample",
        "time in contact",
        "test time",
        "step time",
        "zeit",
        "prüfzeit",
        "temps",
        "temps d'essai",
    ),
    *("tiempo", "tiempo de ensayo", "tempo", "tempo di prova", "时间", "時間"),
)
STIFFNESS_NAMES = (
    "stiffness",
    "harmonic contact stiffness",
    "dynamic contact stiffness",
    "real stiffness",
    "contact stiffness",
    "storage stiff.",
    "s=dp/dh",
)


def by_preference(names: Sequence[str]) -> list[str]:
    """Return names in the order in which they are looked for.

    Examples
    --------
    >>> by_preference(["load", "p", "load on sample"])
    ['load on sample', 'load', 'p']
    """
    return sorted(names, key=lambda name: " " not in name)
