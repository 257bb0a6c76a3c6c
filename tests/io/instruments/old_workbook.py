"""A writer of the smallest workbooks in the old format (.xls): BIFF5 or BIFF8 records in a compound file.

Layouts: Microsoft, [MS-CFB] Compound File Binary File Format, sections 2.2 to 2.6; OpenOffice.org's Documentation of
the Microsoft Excel File Format, records BOF, BOUNDSHEET, LABEL and NUMBER.
"""

import struct

SECTOR = 512
FREE, END, FAT = 0xFFFFFFFF, 0xFFFFFFFE, 0xFFFFFFFD
GLOBALS, SHEET = 0x0005, 0x0010
BIFF = {5: 0x0500, 8: 0x0600}


def old_workbook(sheets, *, version=5, drawing=b""):
    """Return the bytes of a workbook: name of a sheet -> rows of texts and numbers; in each the record of a drawing."""
    return compound_file(stream_of(sheets, version, drawing), "Workbook" if version == 8 else "Book")


def record(kind, content=b""):
    return struct.pack("<HH", kind, len(content)) + content


def stream_of(sheets, version, drawing):
    wide = b"\x00" * (version == 8)  # letters of one byte
    parts = [sheet_of(rows, version, wide, drawing) for rows in sheets.values()]
    names = [name.encode("latin-1") for name in sheets]
    begin, end = record(0x809, struct.pack("<HHHH", BIFF[version], GLOBALS, 0, 0)), record(0x0A)
    offset = len(begin) + sum(4 + 7 + len(wide) + len(name) for name in names) + len(end)
    bounds = b""
    for name, part in zip(names, parts, strict=True):
        bounds += record(0x85, struct.pack("<IHB", offset, 0, len(name)) + wide + name)
        offset += len(part)
    return begin + bounds + end + b"".join(parts)


def sheet_of(rows, version, wide, drawing):
    cells = record(0x5D, drawing) if drawing else b""
    for i, row in enumerate(rows):
        for j, cell in enumerate(row):
            if isinstance(cell, str) and cell:
                text = cell.encode("latin-1")
                cells += record(0x204, struct.pack("<HHHH", i, j, 0, len(text)) + wide + text)
            elif not isinstance(cell, str):
                cells += record(0x203, struct.pack("<HHHd", i, j, 0, cell))
    return record(0x809, struct.pack("<HHHH", BIFF[version], SHEET, 0, 0)) + cells + record(0x0A)


def compound_file(stream, name):
    stream = stream.ljust(max(4096, -(-len(stream) // SECTOR) * SECTOR), b"\x00")
    count = len(stream) // SECTOR
    tables = 1 + (count + 2) // (SECTOR // 4)
    chain = [FAT] * tables + [END] + [tables + 2 + i for i in range(count - 1)] + [END]
    chain += [FREE] * (tables * (SECTOR // 4) - len(chain))
    head = struct.pack("<8s16xHHHHH6x", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", 0x3E, 3, 0xFFFE, 9, 6)
    head += struct.pack("<9I", 0, tables, tables, 0, 4096, END, 0, END, 0)
    head += struct.pack(f"<{tables}I", *range(tables))
    head = head.ljust(SECTOR, b"\xff")
    folder = entry("Root Entry", 5, END, 0, child=1) + entry(name, 2, tables + 1, len(stream))
    folder += 2 * entry("", 0, 0, 0)
    return head + struct.pack(f"<{len(chain)}I", *chain) + folder + stream


def entry(name, kind, start, size, child=FREE):
    text = name.encode("utf-16-le")
    length = len(text) + 2 if name else 0
    return struct.pack("<64sHBBIII16xI16xIQ", text, length, kind, 1, FREE, FREE, child, 0, start, size)
