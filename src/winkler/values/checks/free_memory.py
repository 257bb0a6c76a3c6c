"""How much memory this machine has, and how much of it is free."""

from __future__ import annotations

import math
import os
from pathlib import Path

MEMINFO = Path("/proc/meminfo")
GROUP_LIMITS = (
    (Path("/sys/fs/cgroup/memory.max"), Path("/sys/fs/cgroup/memory.current")),
    (Path("/sys/fs/cgroup/memory/memory.limit_in_bytes"), Path("/sys/fs/cgroup/memory/memory.usage_in_bytes")),
)
"""Files with the memory that the processes of a container may take, and what they have taken."""


def whole_memory() -> float:
    """Return the memory [byte] of the machine; infinite where the system does not report it."""
    try:
        return float(os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES"))
    except (AttributeError, ValueError, OSError):
        return math.inf


def free_memory() -> float:
    """Return the memory [byte] that can be taken now; that of the whole machine where the system does not report it."""
    free = whole_memory()
    try:
        for line in MEMINFO.read_text(encoding="ascii").splitlines():
            if line.startswith("MemAvailable:"):
                free = 1024.0 * float(line.split()[1])
    except (OSError, ValueError, IndexError):
        pass
    for limit, taken in GROUP_LIMITS:
        try:
            free = min(free, float(limit.read_text(encoding="ascii")) - float(taken.read_text(encoding="ascii")))
        except (OSError, ValueError):  # no container, or one without a limit
            continue
    return free
