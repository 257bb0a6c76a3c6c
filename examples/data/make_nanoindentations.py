"""Make the nanoindentations of the examples: fused silica for the calibration, and a hard steel.

A blunt Berkovich tip, A = 24.5 h^2 + 1.1 um h, on a frame of 2.5 N/um: partial unloadings with holds, thermal drift,
slow
noise, and a hold under a small force at the end.  Under the force F the contact depth follows from F = H A(h_c).
"""

from pathlib import Path

import numpy as np

FOLDER = Path(__file__).parent / "nanoindentation"
COEFFICIENTS, FRAME, RATE = (24.5, 1.1e-6), 2.5e6, 8.0
DIAMOND = (1.0 - 0.07**2) / 1141e9


def area(height):
    return COEFFICIENTS[0] * height**2 + COEFFICIENTS[1] * height


def contact_depth(size):
    return (np.sqrt(COEFFICIENTS[1] ** 2 + 4.0 * COEFFICIENTS[0] * size) - COEFFICIENTS[1]) / (2.0 * COEFFICIENTS[0])


def slow_noise(random, count):
    frequency = np.fft.rfftfreq(8 * count)
    frequency[0] = frequency[1]
    drawn = np.fft.irfft(np.fft.rfft(random.standard_normal(8 * count)) / np.sqrt(frequency))[:count]
    return drawn / np.std(drawn)


def indentation(seed, young, poisson, hardness, peak, levels):
    random = np.random.default_rng(seed)
    modulus = 1.0 / ((1.0 - poisson**2) / young + DIAMOND)
    depth, force, segment = [np.linspace(-40e-9, 0.0, 40)], [np.zeros(40)], [np.zeros(40)]
    before, start, deepest, width = 0.0, 0.0, 0.0, 0.0
    for number, top in enumerate(peak * (np.arange(1.0, levels + 1.0) / levels) ** 2):
        up = start + (top - start) * np.linspace(0.0, 1.0, int(16 * RATE))[1:] ** (1.0 if number else 2.0)
        virgin = contact_depth(up / hardness)
        outer = virgin + 0.75 * up / (2.0 * modulus * np.sqrt(area(virgin) / np.pi))
        back = deepest - width * (1.0 - (up / before) ** (2.0 / 3.0)) if number else outer
        hold = np.arange(1.0, 8 * RATE + 1.0) / RATE
        tip = contact_depth(top / hardness) * (1.0 + 0.015 * np.log1p(hold) / np.log1p(8.0))
        stiffness = 2.0 * modulus * np.sqrt(area(tip) / np.pi)
        held = tip + 0.75 * top / stiffness
        deepest, width, before = held[-1], 1.5 * top / stiffness[-1], top
        start = (0.1 if number == levels - 1 else 0.3) * top
        down = np.linspace(top, start, int(8 * RATE))[1:]
        depth += [np.maximum(outer, back), held, deepest - width * (1.0 - (down / top) ** (2.0 / 3.0))]
        force += [up, np.full(hold.size, top), down]
        segment += [
            np.full(up.size, 3.0 * number),
            np.full(hold.size, 3.0 * number + 1.0),
            np.full(down.size, 3.0 * number + 2.0),
        ]
    rest = int(40 * RATE)
    depth.append(np.full(rest, depth[-1][-1])), force.append(np.full(rest, start))
    depth, force = np.concatenate(depth), np.concatenate(force)
    time = np.arange(depth.size) / RATE
    drift = 0.05e-9 * random.uniform(-1.0, 1.0)
    noise = 0.15e-9 * random.standard_normal(depth.size) + 0.05e-9 * slow_noise(random, depth.size)
    position = depth + force / FRAME + 300e-9 + drift * time + noise
    return time, position, force + 0.3e-6 * random.standard_normal(depth.size)


def main():
    FOLDER.mkdir(exist_ok=True)
    samples = {"silica": (72e9, 0.17, 9.3e9, 30e-3), "steel": (210e9, 0.3, 7.0e9, 20e-3)}
    for place, (name, (young, poisson, hardness, peak)) in enumerate(samples.items()):
        for number in range(1, 4):
            columns = indentation(10 * place + number, young, poisson, hardness, peak, 4)
            rows = [f"{t:.3f},{1e9 * d:.2f},{1e3 * f:.5f}" for t, d, f in zip(*columns, strict=True)]
            text = "\n".join(["time [s],depth [nm],force [mN]", *rows]) + "\n"
            (FOLDER / f"{name}_{number}.csv").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
