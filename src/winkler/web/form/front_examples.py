"""The examples with which the app invites, and the study with which it begins."""

from __future__ import annotations

from typing import Any, NamedTuple

from winkler.study.language.fit_study import FITTED
from winkler.web.form import fit_form, form
from winkler.web.form.sample_curve import SAMPLE

STEEL = {"kind": "elastic", "young": "210 GPa", "poisson": 0.3}
SECOND = "problem.bed.medium.second"


class FrontExample(NamedTuple):
    """One example of the front page.

    Parameters
    ----------
    title
        A title for the heading of the file.
    question
        What is asked of it.
    kind
        The problem whose example it changes; ``fit`` for a curve to fit.
    changes
        Path -> content.
    """

    title: str
    question: str
    kind: str
    changes: dict[str, Any]

    @property
    def table(self) -> dict[str, Any]:
        """Its study."""
        if self.kind == "fit":
            table = fit_form.initial_table(FITTED[0])
            form.put(table, fit_form.CURVE, SAMPLE)
            return table
        table = form.initial_table(self.kind)
        for path, content in self.changes.items():
            form.put(table, path, content)
        return {**table, "title": self.title}


def first_table() -> dict[str, Any]:
    """Return the study with which the app begins: a ball of steel on steel."""
    table = form.initial_table("indentation")
    form.put(table, SECOND, dict(STEEL))
    return table


QUESTIONS = (
    FrontExample(
        "Will it yield?",
        "At which load does a ball of bearing steel mark a stainless plate?",
        "yield_onset",
        {
            "problem.bed.medium.first": {"kind": "named_elastic", "name": "stainless steel"},
            SECOND: {"kind": "named_elastic", "name": "bearing steel"},
        },
    ),
    FrontExample(
        "How hot?",
        "How warm is a ball of steel that slides over steel?",
        "friction_heating",
        {"problem.contact.bed.medium.second": dict(STEEL)},
    ),
    FrontExample(
        "Does my seal leak?",
        "How much water passes between two rough faces of steel?",
        "seal",
        {
            "problem.contact.medium.second": dict(STEEL),
            "problem.contact.topography.spectrum.shortest": "120 um",  # eight pixels: the grid resolves the leak
            "problem.contact.load": {"kind": "force", "force": "100 N"},
        },
    ),
    FrontExample("What modulus is this curve?", "What are modulus and contact point of a force curve?", "fit", {}),
    FrontExample(
        "How deep does my tip go?",
        "How deep does a blunt silicon tip press into a polymer?",
        "indentation",
        {
            "problem.bed.profile": {"kind": "sphero_conical", "curvature_radius": "30 nm", "half_angle": "20 deg"},
            "problem.bed.medium.first": {"kind": "elastic", "young": "2 GPa", "poisson": 0.4},
            SECOND: {"kind": "named_elastic", "name": "silicon"},
            "problem.load": {"kind": "force", "force": "50 nN"},
        },
    ),
    FrontExample(
        "What does it cost per cycle?",
        "How much energy does a ball of steel lose that is pushed back and forth?",
        "friction_damping",
        {SECOND: dict(STEEL)},
    ),
    FrontExample(
        "How long does it last?",
        "How deep has a sliding ball worn after a given distance?",
        "sliding_wear",
        {SECOND: dict(STEEL)},
    ),
    FrontExample("How stiff is the joint?", "How stiff are two rough faces that are clamped?", "joint_stiffness", {}),
)
"""The questions that users ask first, each with an example to change."""

FRONT_EXAMPLES = (
    *QUESTIONS,
    FrontExample(
        "AFM bead on a gel",
        "How deep does it go, and does it stick?",
        "adhesive_indentation",
        {
            "problem.bed.profile": {"kind": "paraboloid", "curvature_radius": "2.5 um"},
            "problem.bed.medium.first": {"kind": "elastic", "young": "5 kPa", "poisson": 0.5},
            "problem.law": {"kind": "short_range", "work": "20 uJ/m^2"},
            "problem.load": {"kind": "force", "force": "1 nN"},
        },
    ),
    FrontExample(
        "Ball bearing",
        "What is the greatest pressure in the groove?",
        "elliptic_indentation",
        {
            "problem.bodies": {
                "kind": "curved_bodies",
                "longitudinal_curvature_radius": "4 mm",
                "lateral_curvature_radius": "120 mm",
            },
            "problem.medium": {"kind": "half_space", "first": dict(STEEL), "second": dict(STEEL)},
            "problem.load": {"kind": "force", "force": "500 N"},
        },
    ),
    FrontExample(
        "Fretting ball", "How much is worn off in ten thousand cycles?", "fretting_wear", {SECOND: dict(STEEL)}
    ),
    FrontExample(
        "Coated tool",
        "Does the hard layer carry the load?",
        "indentation",
        {
            "problem.bed.profile": {"kind": "sphere", "curvature_radius": "1 mm"},
            "problem.bed.medium": {
                "kind": "coated_half_space",
                "layers": [
                    {
                        "kind": "layer",
                        "thickness": "5 um",
                        "solid": {"kind": "elastic", "young": "450 GPa", "poisson": 0.25},
                    }
                ],
                "on": dict(STEEL),
            },
            "problem.load": {"kind": "force", "force": "5 N"},
        },
    ),
    FrontExample(
        "Wheel on rail",
        "Where do the profiles touch, and how hard?",
        "profile_pair",
        {"problem.medium.second": dict(STEEL)},
    ),
    FrontExample(
        "Relay contact",
        "What is its resistance?",
        "constriction",
        {
            "problem.contact.bed.medium.first": {"kind": "elastic", "young": "82 GPa", "poisson": 0.37},
            "problem.contact.bed.medium.second": {"kind": "elastic", "young": "82 GPa", "poisson": 0.37},
        },
    ),
    FrontExample(
        "Rubber ball, held",
        "How fast does its force relax?",
        "relaxation_test",
        {"problem.bed.profile.curvature_radius": "50 mm"},
    ),
    FrontExample(
        "Rough joint",
        "How much of it really touches?",
        "surface_contact",
        {"problem.topography.shape": [128, 128], "problem.medium.second": dict(STEEL)},
    ),
)
"""In the order of the page."""
