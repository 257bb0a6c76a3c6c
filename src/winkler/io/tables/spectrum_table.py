r"""Measured power spectra in tables: a wave number (or wavelength, or spatial frequency) and a density in every row."""

from __future__ import annotations

import math
import os

import numpy as np

from winkler.io.foreign import in_file, reader
from winkler.io.tables.header import names_columns
from winkler.io.tables.scan_table import is_scan, read_scan
from winkler.io.tables.table import Column, Table, read_table
from winkler.profiles.rough.line_scan import spectrum_of_lines
from winkler.profiles.rough.spectrum import PowerSpectrum
from winkler.values.errors import InvalidInput

WAVE_NUMBER = Column(
    "wave number", ("wave_number", "wave number", "wavenumber", "wavevector", "wave vector", "q"), "1/m", "1/um"
)
ANGULAR_WAVE_NUMBER = Column(WAVE_NUMBER.word, WAVE_NUMBER.names, "rad/m", "rad/um")
WAVELENGTH = Column("wavelength", ("wavelength", "lambda"), "m", "um")
FREQUENCY = Column("spatial frequency", ("spatial_frequency", "spatial frequency", "frequency", "f"), "1/m", "1/um")
DENSITY = Column("density", ("density", "psd", "c", "c(q)", "power spectral density"), "m^4", "um^4")
LINE_DENSITY = Column(DENSITY.word, DENSITY.names, "m^3", "um^3")
COUNTED_PER = ("wave number", "frequency")


@reader("a spectrum")
def read_spectrum(path: str | os.PathLike[str], *, per: str = "") -> PowerSpectrum:
    r"""Read the measured power spectrum of an isotropic surface, or of scans along lines on it, from a table.

    Parameters
    ----------
    path : str or path
        The file, with a column wave_number (q), wavelength (lambda) or spatial_frequency (f), and one of density (psd,
        c).  Its header contains units, as in ``wave_number [1/um], density [um^4]``; rows may rise or fall, and other
        columns are ignored.  A density in m^3, um^3 and so on is that of line scans, two-sided (half of a one-sided
        one); the surface is then assumed isotropic. Where this density rises with wave number, it is set constant.
        Beyond its last value it is extrapolated as a power law, so that the last octave is uncertain.  A table of
        positions and heights is accepted as well (`read_scan`); its spectrum is then computed.
    per : str, optional
        Variable to which the density refers; programs differ by 2 pi for every direction: "wave number", as in
        Persson's papers, or "frequency", which is (2 pi)^2 times as much for a surface, as SurfaceTopography and
        contact.engineering write it, also over wave numbers.  By default it is the variable of the first column.

    Returns
    -------
    PowerSpectrum
        Of the surface, per wave number.

    Raises
    ------
    InvalidInput
        If the file cannot be read, or it does not contain a spectrum.

    Notes
    -----
    Per wave number, :math:`\langle h^2\rangle=\int C\,\mathrm d^2q`; per frequency,
    :math:`\langle h^2\rangle=\int C\,\mathrm d^2f=(2\pi)^{-2}\int C\,\mathrm d^2q`.
    """
    if per and per not in COUNTED_PER:
        raise InvalidInput(f"read_spectrum: per is {per!r}; give 'wave number' or 'frequency'.")
    if is_scan(path):
        return read_scan(path).spectrum
    places = next((column for column in (WAVELENGTH, FREQUENCY) if names_columns(path, (column, DENSITY))), WAVE_NUMBER)
    table, directions = _table(path, places)
    abscissa, density = table.values.T
    if np.any(abscissa <= 0.0):
        line = int(table.lines[np.argmax(abscissa <= 0.0)])
        raise InvalidInput(f"{table.path}, line {line}: the {places.word} is not positive; delete the line.")
    q = abscissa if places is WAVE_NUMBER else 2.0 * math.pi * (1.0 / abscissa if places is WAVELENGTH else abscissa)
    order = np.argsort(q, kind="stable")
    counted = per or ("frequency" if places is FREQUENCY else "wave number")
    density = density[order] / (2.0 * math.pi) ** (directions if counted == "frequency" else 0)
    with in_file(table.path):
        return (PowerSpectrum if directions == 2 else spectrum_of_lines)(q[order], density)


def _table(path: str | os.PathLike[str], places: Column) -> tuple[Table, int]:
    """Return two columns and the number of directions of the density, which follows from its unit."""
    # wave numbers are written in 1/m and in rad/m
    columns = (places, ANGULAR_WAVE_NUMBER) if places is WAVE_NUMBER else (places,)
    reasons = []
    for density, directions in ((DENSITY, 2), (LINE_DENSITY, 1)):
        for column in columns:
            try:
                return read_table(path, (column, density)), directions
            except InvalidInput as error:
                reasons.append(error)
    raise reasons[0] from None
