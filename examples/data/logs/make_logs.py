"""Make fretting_loops.csv, contact_resistance.csv, pin_on_disc.csv and bounces.csv: logs of tests, with scatter.

The logs are not real ones.  What they should give is known, so that what comes out of winkler can be checked.

- fretting_loops.csv: a steel ball (radius 5 mm, E = 210 GPa, nu = 0.3) on a steel plate under 20 N, moved to
  and fro by a drive behind a frame of 50 nm/N; the coefficient runs in from 0.3 to 0.62.  The contact follows Mindlin's
  closed form.  Force and displacement scatter by 0.05 N and 5 nm.
- contact_resistance.csv: a ball of gold (radius 2 mm, E = 79 GPa, nu = 0.42) on a plate of the same, 24 nohm m,
  leads of 0.2 mohm; pressed up to 1 N.  Resistances scatter by 1 %.
- pin_on_disc.csv: a pin with a face of 20 mm^2 under 10 N, 1e-15 1/Pa behind running-in, coefficient 0.55.
- bounces.csv: a steel ball dropped on a plate, restitution 0.91, times scatter by 0.2 ms.

The numbers follow from closed forms, written out here, not from winkler.  The scatter is seeded, so that the files are
the same every time.

Run it in the folder where the files are wanted:  python make_logs.py
"""

from pathlib import Path

import numpy as np

SEED = 1953
HEADER = "# NOT a real measurement: made by examples/data/logs/make_logs.py from known numbers, with seeded scatter.\n"


def write(name: str, header: str, columns: list[np.ndarray], formats: list[str]) -> None:
    """Write a table."""
    rows = "".join(
        ", ".join(form.format(number) for form, number in zip(formats, row, strict=True)) + "\n"
        for row in zip(*columns, strict=True)
    )
    Path(name).write_text(HEADER + header + "\n" + rows, encoding="utf-8")


def loops(random: np.random.Generator) -> None:
    """Write 60 cycles of Mindlin's ball behind a frame, 80 points each."""
    radius, load, frame, stroke = 5e-3, 20.0, 50e-9, 6e-6
    modulus = 210e9 / (2.0 * 0.91)  # E* of steel on steel
    shear = 210e9 / 2.6 / (2.0 * 1.7)  # G* of steel on steel
    contact = np.cbrt(0.75 * load * radius / modulus)
    stiffness = 8.0 * contact * shear
    ways, forces = [], []
    angles = np.linspace(-np.pi, np.pi, 80, endpoint=False)  # from the least displacement
    for cycle in range(60):
        friction = 0.62 - 0.32 * np.exp(-cycle / 6.0)
        most = 1.5 * friction * load / stiffness  # the way after which a ball slides all over

        def first_way(shift: np.ndarray, friction: float = friction, most: float = most) -> np.ndarray:
            return friction * load * (1.0 - np.clip(1.0 - shift / most, 0.0, None) ** 1.5)

        shift = np.linspace(0.0, 0.5 * stroke, 4000)
        drive = shift + frame * first_way(shift)
        way = 0.5 * stroke * np.cos(angles)
        up = np.arange(80) < 40
        half = 0.5 * np.where(up, way + 0.5 * stroke, 0.5 * stroke - way)
        end = np.interp(0.5 * stroke, drive, first_way(shift))
        branch = 2.0 * np.interp(half, drive, first_way(shift)) - end
        ways.append(way)
        forces.append(np.where(up, branch, -branch))
    way, force = np.concatenate(ways), np.concatenate(forces)
    way = way + 5e-9 * random.standard_normal(way.size)
    force = force + 0.05 * random.standard_normal(way.size)
    pressed = load + 0.1 * random.standard_normal(way.size)
    write(
        "fretting_loops.csv",
        "displacement [um], friction force [N], normal force [N]",
        [1e6 * way, force, pressed],
        ["{:.4f}", "{:.3f}", "{:.2f}"],
    )


def resistance(random: np.random.Generator) -> None:
    """Write 60 resistances of a ball."""
    force = np.geomspace(5e-3, 1.0, 60)
    contact = np.cbrt(0.75 * force * 2e-3 / (79e9 / (2.0 * (1.0 - 0.42**2))))
    ohm = (24e-9 / (2.0 * contact) + 0.2e-3) * np.exp(0.01 * random.standard_normal(force.size))
    write(
        "contact_resistance.csv",
        "force [mN], contact resistance [mohm]",
        [1e3 * force, 1e3 * ohm],
        ["{:.3f}", "{:.5f}"],
    )


def pin(random: np.random.Generator) -> None:
    """Write a log of a kilometre with slow noise."""
    distance = np.linspace(0.0, 1000.0, 500)
    slow = random.standard_normal((2, 500))
    for row in range(1, 500):
        slow[:, row] = 0.6 * slow[:, row - 1] + 0.8 * slow[:, row]
    friction = 0.55 - 0.25 * np.exp(-distance / 50.0) + 0.015 * slow[0]
    loss = 1e-15 * 10.0 / 20e-6 * distance + 0.4e-6 * (1.0 - np.exp(-distance / 50.0)) + 0.02e-6 * slow[1]
    write(
        "pin_on_disc.csv",
        "distance [m], cof, wear depth [um]",
        [distance, friction, 1e6 * loss],
        ["{:.1f}", "{:.4f}", "{:.4f}"],
    )


def bounces(random: np.random.Generator) -> None:
    """Write the times of a ball dropped from 20 cm."""
    fall = np.sqrt(2.0 * 0.2 / 9.81)
    flights = 2.0 * fall * 0.91 ** np.arange(1, 16)
    times = 0.5 + np.concatenate([[0.0], np.cumsum(flights)]) + 0.2e-3 * random.standard_normal(16)
    write("bounces.csv", "bounce time [s]", [times], ["{:.5f}"])


if __name__ == "__main__":
    random = np.random.default_rng(SEED)
    loops(random)
    resistance(random)
    pin(random)
    bounces(random)
