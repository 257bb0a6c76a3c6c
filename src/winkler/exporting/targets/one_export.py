"""Files of one export belong together: each holds the digest of all, and one that uses another one checks it.

A copy that was broken off, or a file that was taken from an older export, then does not compile, in place of computing
another law.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Mapping

MARK = "@mark@"
"""Stands for the digest in texts."""
DIGITS = 12


def marked(files: Mapping[str, str]) -> dict[str, str]:
    """Return texts with their common digest: in place of `MARK`, in headers, and where these are included.

    Examples
    --------
    >>> files = marked({"a.h": "#ifndef A_H", "b.c": '#include "a.h"'})
    >>> print(files["b.c"])
    #include "a.h"
    #if A_EXPORT != 0x9a0f8963ab5a
    #error "a.h is of another export than this file; export all files again"
    #endif
    """
    digest = hashlib.sha256("\0".join(part for pair in files.items() for part in pair).encode()).hexdigest()[:DIGITS]
    checked = {}
    for name, text in files.items():
        for other in (file for file in files if file.endswith(".h")):
            macro = f"{other.removesuffix('.h').upper()}_EXPORT"
            if other == name:
                text = re.sub(r"^(?=#if)", f"#define {macro} 0x{MARK}\n", text, count=1, flags=re.MULTILINE)
            check = (
                f'#include "{other}"\n#if {macro} != 0x{MARK}\n'
                f'#error "{other} is of another export than this file; export all files again"\n#endif'
            )
            text = re.sub(rf'^#include "{re.escape(other)}"$', check, text, flags=re.MULTILINE)
        checked[name] = text.replace(MARK, digest)
    return checked
