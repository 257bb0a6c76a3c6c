"""What a file is taken for, as a part of a page."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from winkler.study.inspection.inspection import Inspection
from winkler.study.report.markup import number, safe, table
from winkler.study.report.mathml import symbol
from winkler.study.report.thumbnails import thumbnail
from winkler.values.readable import with_unit


def inspection_html(found: Inspection) -> str:
    """Return what the terminal shows, with a thumbnail of each column.

    Parameters
    ----------
    found : Inspection
    """
    name = safe(Path(found.file).name)
    if not found.is_read:
        reason = found.reason.removeprefix(f"{found.file}: ")
        return f"<h3>{name} cannot be read as it is</h3><p>{safe(reason)}</p>"
    many = f", the first of {found.count}" if found.count > 1 else ""
    parts = [
        f"<h3>{name}: {safe(found.taken_for)}{many}</h3><p class='small'>Taken for it by: {safe(found.reason)}</p>"
    ]
    if found.columns:
        rows = [
            f"<tr><td>{safe(one.name)} {symbol(one.symbol)}</td>{number(str(one.values.size))}"
            f"<td>{safe(one.range)}</td>"
            f"<td>{thumbnail([(np.arange(float(one.values.size)), one.values)], f'{one.name} in its order')}</td>"
            f'<td class="text small">{safe(one.meaning)}</td></tr>'
            for one in found.columns
        ]
        parts.append(table(["column", "#numbers", "range", "in the order of the file", "meaning"], rows))
    if found.numbers:
        rows = [
            f"<tr><td>{symbol(one.symbol)}</td>{number(safe(with_unit(one.value, one.unit)))}"
            f'<td class="text small">{safe(one.meaning)}</td></tr>'
            for one in found.numbers
        ]
        parts.append(table(["", "#value", "meaning"], rows))
    for title, lines in (("What was done", found.done), ("What is doubtful", found.doubts)):
        if lines:
            items = "".join(f"<li>{safe(line)}</li>" for line in lines)
            parts.append(f"<h4>{title}</h4><ul>{items}</ul>")
    if not found.doubts:
        parts.append("<p>Nothing is doubtful.</p>")
    return "\n".join(parts)
