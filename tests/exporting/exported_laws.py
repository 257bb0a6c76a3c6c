"""One problem of every kind that is a contact law."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
from compiled_c import compiler

from winkler.foundation.foundation import Foundation
from winkler.laws.adhesion import DerjaguinMullerToporov, ShortRange
from winkler.laws.friction import Coulomb, StaticKinetic
from winkler.loading.loads import Depth, Force, Shift
from winkler.loading.path import Path
from winkler.materials.elastic import Elastic
from winkler.materials.spring_and_dashpot import KelvinVoigt, Maxwell
from winkler.media.halfspace import HalfSpace
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.problems.adhesion.cycle import AdhesiveCycle
from winkler.problems.friction.tangential import Tangential
from winkler.problems.normal.elliptic import EllipticIndentation
from winkler.problems.normal.indentation import Indentation
from winkler.problems.particles.contact_law import ContactLaw
from winkler.problems.particles.contacts import Contacts
from winkler.problems.particles.elastic_plastic import ElasticPlasticParticle
from winkler.problems.plastic.indentation import PlasticIndentation
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.profiles.conical import Cone, RoundedCone
from winkler.profiles.ellipse import CurvedBodies
from winkler.profiles.power import Paraboloid

STEEL = HalfSpace.between(Elastic(210e9, 0.3), Elastic(210e9, 0.3))
GLASS = HalfSpace.between(Elastic(70e9, 0.22), Elastic(70e9, 0.22))
BALL = Foundation(Paraboloid(1e-3), STEEL)
GEL = Foundation(Paraboloid(1e-2), ViscoelasticHalfSpace(Maxwell(shear=1e6, relaxation_time=0.3)))
DAMPED = Foundation(Paraboloid(1e-2), ViscoelasticHalfSpace(KelvinVoigt(shear=1e6, viscosity=2e5)))
RUBBER = Foundation(Paraboloid(1e-3), HalfSpace.between(Elastic(1e6, 0.5)))
THERE_AND_BACK = Path([0.0, 1.0, 2.0], Depth([0.0, 1e-6, 0.5e-6]), Shift([0.0, 2e-7, -2e-7]))
METAL = Elastic(young=210e9, poisson=0.3, strength=1e9)
POWDER = Elastic(young=1e9, poisson=0.3, strength=20e6)

PROBLEMS = {
    "ball": Indentation(BALL, Force(np.array([1.0, 10.0]))),
    "cone": ContactLaw(Foundation(Cone(0.2), GLASS), deepest=1e-6),
    "sheared": Tangential(BALL, Coulomb(0.3), THERE_AND_BACK),
    "two_coefficients": Tangential(Foundation(Cone(0.2), GLASS), StaticKinetic(0.5, 0.3), THERE_AND_BACK),
    "beads": Contacts.apart(GLASS, curvature_radius=1e-3, coefficient=0.3, reach=2e-6, rolling_arm=1e-5, count=8),
    "powder": ElasticPlasticParticle(1e-3, POWDER, Depth([50e-6, 0.0]), work_opening=0.1, work_closing=0.05),
    "sticky": AdhesiveCycle(RUBBER, ShortRange(work_closing=0.02, work_opening=0.05), Depth([10e-6, -1e-5])),
    "pulled": AdhesiveCycle(BALL, DerjaguinMullerToporov(0.05), Depth([3e-8, 0.0])),
    "damped": ViscoelasticIndentation(DAMPED, Path([0.0, 1.0, 1.5], Depth([0.0, 1e-4, 0.5e-4]))),
    "dented": PlasticIndentation(Foundation(Paraboloid(5e-3), HalfSpace(METAL)), Depth([2e-5, 0.0])),
    "dented_tip": PlasticIndentation(Foundation(RoundedCone(1e-5, 1.3), HalfSpace(METAL)), Depth([2e-6, 0.0])),
    "ellipse": EllipticIndentation(CurvedBodies(20e-3, 10e-3), STEEL, Force(100.0)),
    "gel": ViscoelasticIndentation(GEL, Path([0.0, 1.0, 1.5], Depth([0.0, 1e-4, 0.5e-4]))),
}


def built(folder, name, options=("-O0",), language="c"):
    """Compile an exported law in C; return the program."""
    program = folder / f"{name}_{language.strip('+')}"
    standard = "-std=c99" if language == "c" else "-std=c++11"
    warn = ("-Wall", "-Wextra", *(("-Werror=implicit",) if language == "c" else ()))
    command = [*compiler(), standard, *options, *warn, "-x", language, f"-D{name.upper()}_MAIN"]
    made = subprocess.run(
        [*command, str(folder / f"{name}.h"), "-o", str(program), "-lm"], capture_output=True, text=True
    )
    assert made.returncode == 0, made.stderr
    assert "warning" not in made.stderr, made.stderr
    return program


def ran(*command):
    """Run a program; return its exit code and what it wrote."""
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


def python(path):
    """Run a Python file by itself, away from winkler."""
    return ran(sys.executable, "-I", path)


def random_motions(law, histories, steps=24, seed=20260824):
    """Return motions of all sizes, with steps that stay, just touch, and part."""
    rng = np.random.default_rng(seed)
    shape = (histories, steps)
    size = np.max(np.abs(law.trial), axis=0)
    motions = rng.normal(size=(*shape, size.size)) * size * 10.0 ** rng.uniform(-16.0, 4.0, (*shape, 1))
    deepest = np.max(law.trial[:, 0])
    depth = deepest * rng.choice([-1.0, 1.0, 1.0], shape) * 10.0 ** rng.uniform(-9.0, 0.0, (*shape,))
    depth[rng.random(shape) < 0.1] = 0.0
    for k in range(1, steps):  # some stay where they are, and some move by little
        stays = rng.random(histories)
        depth[:, k] = np.where(stays < 0.2, depth[:, k - 1], depth[:, k])
        depth[:, k] = np.where((stays > 0.2) & (stays < 0.4), depth[:, k - 1] * (1.0 - 1e-13), depth[:, k])
    motions[:, :, 0] = depth
    names = [one.name for one in law.motion]
    if "duration" in names:
        motions[:, :, names.index("duration")] = np.abs(motions[:, :, names.index("duration")])
    motions[rng.random(shape) < 0.1, 1:] = 0.0
    if law.every_radius:
        motions[:, :, -1] = law.trial[0, -1]
    return motions
