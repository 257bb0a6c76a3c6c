"""HDF5 files: refuse those whose contents lie in other files.

External links, raw data and virtual data sets of an HDF5 file may point to any file that the user can read, whose
contents would then be disclosed with the results.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from winkler.values.errors import InvalidInput


def refuse_other_files(path: Path) -> None:
    """Refuse an HDF5 file whose contents lie in other files; files of other formats are accepted.

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
