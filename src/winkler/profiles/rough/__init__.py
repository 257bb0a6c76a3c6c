"""Rough surfaces: height maps, line scans, spectra and random surfaces."""
