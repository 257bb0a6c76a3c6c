"""Profile on profile: the profiles, the problem, and its formulas."""

from __future__ import annotations

from winkler.study.chapters.answer import Caption, Chapter, Equation, PicturedContact, answer
from winkler.study.chapters.kind import kind
from winkler.study.chapters.surface_rolling import COULOMB, PASSED

POINTS = {
    "y": ["-20 mm", "-15 mm", "-10 mm", "-5 mm", "0 mm", "5 mm", "10 mm", "15 mm", "20 mm"],
    "z": ["-0.6674 mm", "-0.3752 mm", "-0.1667 mm", "-0.0417 mm", "0 mm", "-0.0417 mm", "-0.1667 mm", "-0.3752 mm",
          "-0.6674 mm"],
}  # fmt: skip
ARC = {"kind": "cross_profile", **POINTS}
TREAD = {
    "kind": "cross_profile",
    "y": ["-25 mm", "-20 mm", "-15 mm", "-10 mm", "-5 mm", "0 mm", "5 mm", "10 mm", "15 mm", "20 mm", "25 mm"],
    "z": ["-0.0125 mm", "-0.1 mm", "-0.1375 mm", "-0.125 mm", "-0.0813 mm", "0 mm", "0.1188 mm", "0.275 mm",
          "0.4625 mm", "0.675 mm", "0.9125 mm"],
}  # fmt: skip

ALONG_NORMALS = Equation(
    "The gap is measured along the normals of the lower profile; pressures and gaps are never negative, and one of "
    "the two is zero everywhere",
    r"w = g_n+\frac{1}{\pi E^*}\int\frac{p\,\mathrm{d}A}{\rho}, \quad p \ge 0, \; w \ge 0, \; p\,w = 0",
)
SUMS = Equation(
    "The upper body is lowered until the contact carries the vertical force",
    r"F_z = \int p\,n_z\,\mathrm{d}A, \quad F_y = \int p\,n_y\,\mathrm{d}A",
)
CREEPAGES = Equation(
    "Creepages of rigid bodies at the centre of pressure, relative to the mean speed of both",
    r"\xi = \frac{(v_2-v_1)_x}{V}, \quad \eta = \frac{(v_2-v_1)_t}{V}, \quad "
    r"\varphi = -\frac{1}{V}\,\frac{\mathrm{d}(v_2-v_1)_x}{\mathrm{d}s}",
)
SLIP_ALONG_ARC = Equation(
    "They depend on the rolling radii of both bodies along the arc s of a patch, relative to the centre of pressure x₀",
    r"w_x = \xi(s), \quad w_t = \eta(s)+\varphi(s)\,(x-x_0)",
)
BALANCE = Equation(
    "Pressures and friction together carry the vertical force",
    r"F_{2z} = \int (p\,n_z-\tau_t\,t_z)\,\mathrm{d}A, \quad F_{2y} = \int (p\,n_y-\tau_t\,t_y)\,\mathrm{d}A",
)

PROFILE_PAIR = Chapter(
    "rolling",
    kinds={
        "cross_profile": {
            "cross_profile": kind(
                "winkler.profiles.sections.cross_profile:CrossProfile",
                reader="winkler.io.tables.cross_profile_file:read_cross_profile",
                problem="profile_pair",
                y=POINTS["y"],
                z=POINTS["z"],
            ),
        },
    },
    answers={
        "profile_pair": answer(
            "winkler.problems.profile_pair.profile_pair:ProfilePair",
            question="Where do a wheel and a rail, a cam and its follower, or a ball and a groove of given profiles touch?",
            page="chapters/surfaces/profiles.md",
            key="wheel rail",
            en="wheel rail profile contact conformal two-point contact gauge corner measured profiles cam follower groove hollow worn wheel rail head contact patch gauge corner equivalent conicity worn profile s1002 uic60 flange root tram hollow tread groove of crane rail gothic arch",
            de="rad schiene profil zweipunktkontakt berührpunkt gemessene profile spurkranz fahrkante verschleissprofil radprofil schienenprofil",
            fr="profil roue rail double contact profils mesurés boudin congé profil usé",
            headline=("peak_pressure", "area", "depth", "force", "lateral_force"),
            first=ARC,
            second=TREAD,
            second_radius="460 mm",
            load={"kind": "force", "force": "50 kN"},
            yaw="5 mrad",
            pixels=64,
            picture=Caption(
                "profiles",
                "The profiles and their contact patches",
                "Both profiles with the contact patches, the gap between them, and the pressure on the patch with "
                "the highest load.",
            ),
            pictured=PicturedContact.NONE,
            formulas=(ALONG_NORMALS, SUMS, CREEPAGES),
        ),
        "profile_pair_rolling": answer(
            "winkler.problems.profile_pair.pair_rolling:ProfilePairRolling",
            question="Which creep forces does a wheel transmit to a rail when both profiles are given?",
            page="chapters/surfaces/profiles.md#friction-while-they-roll",
            en="wheel rail creep forces of measured profiles rolling contact flange gauge corner curve squeal railway contact algorithm kalker loss wear number gauge corner t-gamma wear number derailment flange contact hollow worn tram saturated creep force corrugation",
            de="rad schiene schlupfkräfte gemessene profile spurkranz bogen rollkontakt",
            fr="roue rail efforts de pseudo-glissement profils mesurés boudin courbe",
            headline=("x_force", "y_force", "loss_per_distance", "peak_pressure"),
            pair={
                "kind": "profile_pair",
                "first": ARC,
                "second": TREAD,
                "second_radius": "460 mm",
                "rolled_radius": "460.2 mm",
                "load": {"kind": "force", "force": "50 kN"},
                "yaw": "1 mrad",
                "pixels": 48,
            },
            picture=Caption(
                "rolling_profiles",
                "Friction of the profiles while they roll",
                "Both profiles with the contact patches, and stick and slip zones with arrows for the traction on "
                "the patches with the highest load.",
            ),
            pictured=PicturedContact.NONE,
            formulas=(ALONG_NORMALS, CREEPAGES, SLIP_ALONG_ARC, PASSED, COULOMB, BALANCE),
        ),
    },
)
