"""HDF5 files: whether what stands in one leads to other files.

Links, raw data and virtual data of an HDF5 file may lie in any file that this user can read; whoever sees what is read
would see that file.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from winkler.errors import InvalidInput

__all__ = ["refuse_other_files"]


def refuse_other_files(path: Path) -> None:
    """Refuse an HDF5 file whose contents lie in other files; files of other formats are passed.

    Raises
    ------
    InvalidInput
    """
    import h5py

    def link_out(name: str, link: Any) -> str | None:
        return None if isinstance(link, h5py.HardLink | h5py.SoftLink) else name

    def data_outside(name: str, item: Any) -> str | None:
        return name if isinstance(item, h5py.Dataset) and (item.external or item.is_virtual) else None

    if not h5py.is_hdf5(path):
        return
    with h5py.File(path, "r") as file:
        outside = file.visititems_links(link_out) or file.visititems(data_outside)
    if outside:
        raise InvalidInput(
            f"{path}: {outside[:100]!r} lies in another file; save it with its data inside, as one file."
        )
