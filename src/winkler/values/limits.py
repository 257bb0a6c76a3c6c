"""Limits of what is read and computed: a wrong zero becomes one sentence, not a machine without memory.

What is given is compared with these numbers before anything is read, unpacked or allocated for it.  They are far above
what instruments write: a map of 4096 x 4096 heights has 2^24 pixels.
"""

from __future__ import annotations

TEXT_BYTES = 200_000_000
"""Bytes of a text with numbers."""
TEXT_LINES = 2_000_000
"""Lines of such a text."""
HEADER_LINES = 500
"""Lines among which the header of a table is searched for,"""
HEADER_LETTERS = 100_000
"""characters of all of them,"""
LINE_LETTERS = 20_000
"""and of one of them."""
CELL_LETTERS = 200
"""Characters of the name of a column with its unit."""
UNIT_LETTERS = 100
"""Characters of a unit."""
KEY_LETTERS = 500
"""Characters of a key of a study, and of the name of a quantity."""
STUDY_BYTES = 200_000_000
"""Bytes of a study, of which a packed height map may be nearly all."""
STUDY_MARKS = 1_000_000
"""Signs of a study that separate its entries: commas, equals signs, brackets and ends of lines."""
FILE_BYTES = 1_000_000_000
"""Bytes of a file of an instrument, and of all that is packed in it."""
READING_BYTES = 2_000_000_000
"""Bytes that a library may take to read such a file."""
LIST_BYTES = 50_000_000
"""Bytes of the list of contents of an archive; a map of a million curves needs them."""
MOST_NUMBERS = 2**26
"""Numbers of all arrays of a file, and pixels of a map: 512 MiB."""
PATH_POINTS = 10_000_000
"""Points of a path."""
MADE_PIXELS = 2**24
"""Pixels of a map that is made at random: 4096 x 4096."""
MOST_FILM_PIXELS = 2**22
"""Pixels of a thin film through which a fluid flows: 2048 x 2048, some minutes and 8 GiB."""
MOST_SPRINGS = 2**20
"""Springs, samples and realisations of a problem,"""
RELAXING_SPRINGS = 50_000
"""springs with a history,"""
MOST_TERMS = 1000
"""and how many memories each of them has: terms of a series of relaxation."""
MEASURED_TIMES = 20_000
"""Measured times or frequencies that a series is fitted to,"""
MEASURED_PLACES = 500_000
"""and places at which a shape or a bed was measured."""
LEAST_STEP_RATIO = 1e-4
"""Least exponent of a power of time; the series of a smaller one has no end, and the body hardly relaxes."""
FIELD_PLACES = 2**20
"""Places at which fields are restored in a study."""
MOST_SWEPT_RUNS = 2**24
"""Points of a sweep."""
MOST_HOLES = 500_000
"""Missing heights that are bridged."""
MOST_CURVES = 100_000
"""Files of one fit."""
