"""The app's own folder: uploaded files under plain names; nothing outside it can be named."""

from __future__ import annotations

import contextlib
import io
import re
import shutil
import tempfile
import zipfile
from pathlib import Path
from typing import Any

from winkler.io.archive_file import archive, member
from winkler.io.foreign import reason_of
from winkler.values.errors import InvalidInput
from winkler.web.form.sample_curve import SAMPLE, SAMPLES
from winkler.web.form.sample_folder import sample_folder

LARGEST = 20_000_000
"""Greatest size of an upload [bytes]."""
CURVE_KEY = "fit.curve"
"""The key of a study that names a measured curve."""
MOST_FILES = 50
"""Most files of a page."""
CURVES, SAMPLE_CURVES = "curves", "sample_curves"
"""Folders of curves that are fitted together: uploaded ones, and made ones."""
MOST_CURVES = 2000
"""Most files of one of these folders."""
MOST_BYTES = 100_000_000
"""Most bytes of all files of a page."""


def plain_name(name: str) -> str:
    """Return the name of an upload without folders, and without anything but letters, digits, ``.``, ``-`` and ``_``.

    Examples
    --------
    >>> plain_name("../../etc/passwd"), plain_name("My tip (2).CSV"), plain_name("..")
    ('passwd', 'My_tip_2_.CSV', 'file')
    """
    last = re.split(r"[/\\\\]", name)[-1]
    plain = re.sub(r"[^A-Za-z0-9._-]+", "_", last).lstrip("._-")
    return plain[-100:] or "file"


def files_in(content: Any, key: str = "") -> list[tuple[str, Any]]:
    """Return ``(key, name)`` of every file that the tables of a study name."""
    files: list[tuple[str, Any]] = []
    if isinstance(content, dict):
        for name, item in content.items():
            where = f"{key}.{name}" if key else str(name)
            files += [(where, item)] if name == "file" or where == CURVE_KEY else files_in(item, where)
    elif isinstance(content, list):
        for place, item in enumerate(content):
            files += files_in(item, f"{key}[{place}]")
    return files


class UploadFolder:
    """The folder of one page, removed with it.

    Parameters
    ----------
    inside
        The folder of the app; by default the folder for temporary files.
    """

    def __init__(self, inside: Path | None = None) -> None:
        self.folder = Path(tempfile.mkdtemp(prefix="winkler-page-", dir=inside))

    @property
    def names(self) -> tuple[str, ...]:
        """The files that are there."""
        return tuple(sorted(path.name for path in self.folder.iterdir() if path.is_file()))

    def curves_in(self, name: str) -> tuple[str, ...]:
        """Return the curves of one of the folders of curves; none where there is no such folder."""
        place = self.folder / name
        if name not in (CURVES, SAMPLE_CURVES) or not place.is_dir():
            return ()
        return tuple(sorted(path.name for path in place.iterdir() if path.is_file()))

    @property
    def folders(self) -> dict[str, int]:
        """Folder of curves -> how many files are in it."""
        counts = {name: len(self.curves_in(name)) for name in (CURVES, SAMPLE_CURVES)}
        return {name: count for name, count in counts.items() if count}

    def members(self, name: str) -> tuple[str, ...]:
        """Return the files that a name in a study means: one, or those of a folder of curves; none if unknown."""
        if name in self.names:
            return (name,)
        return tuple(f"{name}/{one}" for one in self.curves_in(name))

    def remove_curves(self) -> None:
        """Remove the uploaded folder of curves."""
        shutil.rmtree(self.folder / CURVES, ignore_errors=True)

    def keep(self, name: str, content: bytes, inside: str = "") -> str:
        """Store an upload, in a folder of curves if `inside` names one, and return its plain name.

        Raises
        ------
        InvalidInput
            If it is too large, empty, there are too many or too large ones already, or it cannot be written.
        """
        if len(content) > LARGEST:
            raise InvalidInput(
                f"'{name}' has {len(content) / 1e6:.1f} MB; at most {LARGEST / 1e6:.0f} MB are accepted. Thin it out."
            )
        if not content and not inside:  # in a folder it gets a row that says so
            raise InvalidInput(f"'{name}' is empty; give a file with numbers.")
        plain = plain_name(name)
        others, most = (self.curves_in(inside), MOST_CURVES) if inside else (self.names, MOST_FILES)
        if plain not in others and len(others) >= most:
            raise InvalidInput(f"there are {most} files already; reload the page to begin with none.")
        place = self.folder / inside / plain
        kept = sum(path.stat().st_size for path in self.folder.rglob("*") if path.is_file() and path != place)
        if kept + len(content) > MOST_BYTES:
            raise InvalidInput(
                f"'{name}': with it the files of this page would have more than {MOST_BYTES / 1e6:.0f} MB, the limit; "
                "reload the page to begin with none."
            )
        try:
            place.parent.mkdir(exist_ok=True)
            place.write_bytes(content)
        except OSError as error:
            place.unlink(missing_ok=True)
            raise InvalidInput(
                f"'{name}' cannot be stored ({reason_of(error).lower()}); free space on the disk."
            ) from None
        return plain

    def unpack(self, content: bytes, study: str) -> bytes:
        """Store the files of an archive, and return the study in it.

        Raises
        ------
        InvalidInput
            If there is no study in it, or it is damaged or too large.
        """
        remedy = "open one that this app has made"
        with archive(content, "the upload", remedy=remedy, members=MOST_FILES + MOST_CURVES + 1, size=LARGEST) as pack:
            inside = [one for one in pack.infolist() if not one.is_dir()]
            if study not in [one.filename for one in inside]:
                raise InvalidInput(f"the archive holds no {study}; {remedy}.")
            for one in inside:
                if one.filename != study:
                    folder, _, name = one.filename.rpartition("/")
                    self.keep(name, member(pack, one), folder if folder in (CURVES, SAMPLE_CURVES) else "")
            return member(pack, study)

    def packed(self, text: str, study: str, names: tuple[str, ...]) -> bytes:
        """Return a study and the files and folders of curves that it reads as one archive."""
        store = io.BytesIO()
        with zipfile.ZipFile(store, "w", zipfile.ZIP_DEFLATED) as pack:
            pack.writestr(study, text)
            for name in names:
                for one in self.members(name):
                    pack.write(self.folder / one, one)
        return store.getvalue()

    def check(self, table: Any) -> None:
        """Raise InvalidInput if a study names a file outside this folder.

        Raises
        ------
        InvalidInput
            With one sentence for every such file.
        """
        wrong = [
            f"{key} is {name!r}; the app reads uploaded files only: upload it, and give its plain name."
            if name
            else f"{key} is left out; upload a measured curve, or choose one."
            for key, name in files_in(table)
            if isinstance(name, str) and (name != plain_name(name) or not self.members(name))
        ]
        if wrong:
            raise InvalidInput(*wrong)

    def close(self) -> None:
        """Remove everything."""
        shutil.rmtree(self.folder, ignore_errors=True)


def keep_samples(uploads: UploadFolder) -> None:
    """Write the curves with which a fit begins, when the first one is asked for; a full disk leaves them out."""
    if SAMPLE in uploads.names:
        return
    with contextlib.suppress(InvalidInput):
        for name, made in SAMPLES.items():
            uploads.keep(name, made())
        for name, content in sample_folder():
            uploads.keep(name, content, SAMPLE_CURVES)
