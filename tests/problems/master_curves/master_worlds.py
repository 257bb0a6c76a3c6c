"""Sweeps made with closed formulas: a fractional Zener solid, whose times follow a law of temperature, with scatter."""

from __future__ import annotations

import dataclasses
import math

import numpy as np

from winkler.materials.sweeps import DynamicSweeps

REFERENCE = 263.15
WARMTH = np.arange(223.15, 304.0, 10.0)
FIRST, SECOND, ENERGY = 10.0, 120.0, 80e3
GAS = 8.314462618


def ferry(warmth):
    return -math.log(10.0) * FIRST * (warmth - REFERENCE) / (SECOND + warmth - REFERENCE)


def arrhenius(warmth):
    return ENERGY / GAS * (1.0 / warmth - 1.0 / REFERENCE)


def moduli(turns):
    power = turns**0.45
    return 1e6 + 1e9 * power / (1.0 + power)


def sweeps(seed, law=ferry, *, scatter=0.02, factors=None, warmth=WARMTH, count=13, relaxed=True):
    """Isothermal sweeps from 0.1 to 50 Hz; `factors` multiply the moduli of each temperature."""
    rng = np.random.default_rng(seed)
    omega = 2.0 * np.pi * np.geomspace(0.1, 50.0, count)
    rows, at = np.repeat(warmth, count), np.tile(omega, warmth.size)
    modulus = moduli(1j * at * np.exp(law(rows)) * 1e-3) - (0.0 if relaxed else 1e6)
    if factors is not None:
        modulus = modulus * np.repeat(factors, count)
    noise = np.exp(scatter * rng.standard_normal((2, at.size)))
    mixed = rng.permutation(at.size)  # rows may come in any order
    return DynamicSweeps(rows[mixed], at[mixed], (modulus.real * noise[0])[mixed], (modulus.imag * noise[1])[mixed])


def slower_loss(warmth):
    """Logarithm of the shift of the loss over that of the storage."""
    return 0.6 * np.sin((warmth - REFERENCE) / 12.0)


def contradicting(seed, scatter=0.02):
    """Sweeps whose loss is shifted by more than their storage, as those of a body of two parts."""
    own = sweeps(seed, scatter=scatter)
    other = sweeps(seed, lambda warmth: ferry(warmth) + slower_loss(warmth), scatter=scatter)
    return dataclasses.replace(own, loss_shear=other.loss_shear)
