"""Small logs as test benches write them, and a reader without the child's cost."""

import struct
import zipfile
from pathlib import Path

import h5py
import numpy as np
from scipy.io import savemat

from pipeline.rig_logs.child import open_source
from pipeline.rig_logs.source import CsvOptions, Limits

TIME = np.arange(400) / 1000.0
Q = 9.0 * np.sin(7.0 * TIME)
V = np.where(TIME < 0.2, 0.0, 3000.0)


def open_here(path: Path, csv: CsvOptions | None = None, limits: Limits | None = None):
    """The format's reader in this process; only for files that the tests wrote themselves."""
    return open_source(path, csv or CsvOptions(), limits or Limits())


def read_here(path: Path, csv: CsvOptions | None = None):
    """Name → samples of every channel, read in this process."""
    source = open_here(path, csv)
    return {entry.name: load(source, entry.name) for entry in source.entries()}


def load(source, name: str):
    """All samples of one channel."""
    return np.concatenate([np.empty(0), *(part for _, part in source.parts([name]))])


def text(value: str):
    """A MATLAB text in HDF5."""
    return np.array([ord(character) for character in value], dtype=np.uint16)[:, None]


def write_text(group, name: str, value: str):
    if value:
        item = group.create_dataset(name, data=text(value))
        item.attrs["MATLAB_int_decode"] = np.int32(2)
    else:
        item = group.create_dataset(name, data=np.zeros(2, dtype=np.uint64))
        item.attrs["MATLAB_empty"] = np.uint8(1)
    item.attrs["MATLAB_class"] = np.bytes_("char")
    return item


def write_numbers(group, name: str, values):
    item = group.create_dataset(name, data=np.atleast_2d(np.asarray(values)).T)
    item.attrs["MATLAB_class"] = np.bytes_("double")
    return item


def write_matlab73(path: Path, axes: list[dict], channels: list[dict], variable: str = "anything") -> None:
    """A ControlDesk recording as MATLAB saves it in version 7.3; structs of one element hold no references."""
    with h5py.File(path, "w", userblock_size=512) as file:
        references = file.create_group("#refs#")
        record = file.create_group(variable)
        for part, elements in (("X", axes), ("Y", channels)):
            group = record.create_group(part)
            group.attrs["MATLAB_class"] = np.bytes_("struct")
            for field in elements[0]:
                target = group if len(elements) == 1 else references
                items = []
                for i, element in enumerate(elements):
                    name = field if len(elements) == 1 else f"{part}{field}{i}"
                    write = write_text if isinstance(element[field], str) else write_numbers
                    items.append(write(target, name, element[field]))
                if len(elements) > 1:
                    data = group.create_dataset(field, (len(items), 1), dtype=h5py.ref_dtype)
                    for i, item in enumerate(items):
                        data[i, 0] = item.ref
    with path.open("r+b") as file:
        file.write(b"MATLAB 7.3 MAT-file, Platform: GLNXA64".ljust(116) + b"\0" * 8 + b"\0\x02IM")


def _element(number: int, content: bytes) -> bytes:
    return struct.pack("<II", number, len(content)) + content + b"\0" * (-len(content) % 8)


def matlab_object(name: str, kind: str) -> bytes:
    """An object of a class as version 5 has it: name, "MCOS", class, a key to a nameless variable."""
    texts = b"".join(_element(1, text.encode()) for text in (name, "MCOS", kind))
    numbers = _element(5, struct.pack("<ii", 6, 1)) + _element(1, b"") + _element(6, struct.pack("<6I", *[1] * 6))
    key = _element(14, _element(6, struct.pack("<II", 13, 0)) + numbers)
    return _element(14, _element(6, struct.pack("<II", 17, 0)) + texts + key)


def old_matlab_object(name: str, kind: str, field: str, numbers: list[float]) -> bytes:
    """An object of a class of the old kind (iddata): a struct with the class before its fields, here a single one."""
    shape = _element(5, struct.pack("<ii", 1, len(numbers)))
    value = _element(
        14,
        _element(6, struct.pack("<II", 6, 0))
        + shape
        + _element(1, b"")
        + _element(9, struct.pack(f"<{len(numbers)}d", *numbers)),
    )
    head = _element(6, struct.pack("<II", 3, 0)) + _element(5, struct.pack("<ii", 1, 1)) + _element(1, name.encode())
    fields = _element(5, struct.pack("<i", 32)) + _element(1, field.encode().ljust(32, b"\0"))
    return _element(14, head + _element(1, kind.encode()) + fields + value)


UNITS = (("time", "s"), ("q", "mm"), ("v", "V"))


def write_mdf(path: Path) -> None:
    """Two groups with rasters of their own; time does not start at 0."""
    from asammdf import MDF, Signal

    with MDF(version="4.10") as mdf:
        mdf.append(
            [
                Signal(Q.astype(np.float32), TIME + 12.345, name="q", unit="mm"),
                Signal(V, TIME + 12.345, name="v", unit="V"),
            ]
        )
        slow = np.arange(40) * 0.01 + 12.345
        mdf.append([Signal(np.arange(40, dtype=np.int16), slow, name="temperature", unit="°C")])
        mdf.save(path, overwrite=True)


def save_plain_mat(path: Path, *, compressed: bool = True) -> None:
    """Vectors, a matrix, a nested struct and things that are no data, by SciPy."""
    savemat(
        path,
        {
            "t": TIME[:, None],
            "q": Q.astype(np.float32),
            "counts": np.arange(400, dtype=np.int16),
            "table": np.column_stack([TIME, Q, V]),
            "nested": {"deep": {"v": V}, "remark": "a text"},
            "z": 1j * Q,
            "cell": np.array([1, "x"], dtype=object),
            "one": 3.0,
        },
        do_compression=compressed,
    )


def _sheet(rows):
    """The rows of a sheet as spreadsheets write them, its texts inline, and numbers of the first column formatted."""
    return "".join(f"<row>{''.join(_cell(j, cell) for j, cell in enumerate(row))}</row>" for row in rows)


def _cell(column, cell):
    if isinstance(cell, str):
        formula = f"<c><f>{cell[1:]}</f></c>"
        return formula if cell.startswith("=") else f'<c t="inlineStr"><is><t>{cell}</t></is></c>'
    return f'<c s="{int(column == 0)}"><v>{cell!r}</v></c>'


def workbook(path, sheets, hidden=(), form="General"):
    """Sheets by their names (rows alone are those of Log), and a hidden one; the format of the first column."""
    sheets = sheets if isinstance(sheets, dict) else {"Log": sheets}
    main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
    office = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
    package = "http://schemas.openxmlformats.org/package/2006"
    every = [
        *((name, rows, "visible") for name, rows in sheets.items()),
        *([("Old", hidden, "hidden")] if hidden else []),
    ]
    entries = "".join(
        f'<sheet name="{name}" sheetId="{k}" state="{state}" r:id="s{k}"/>'
        for k, (name, _, state) in enumerate(every, 1)
    )
    links = "".join(
        f'<Relationship Id="s{k}" Target="worksheets/sheet{k}.xml" Type="{office}/worksheet"/>'
        for k in range(1, len(every) + 1)
    )
    files = {
        "[Content_Types].xml": f'<Types xmlns="{package}/content-types"></Types>',
        "_rels/.rels": f'<Relationships xmlns="{package}/relationships"><Relationship Id="a" Target="xl/workbook.xml" '
        f'Type="{office}/officeDocument"/></Relationships>',
        "xl/workbook.xml": f'<workbook xmlns="{main}" xmlns:r="{office}"><sheets>{entries}</sheets></workbook>',
        "xl/_rels/workbook.xml.rels": f'<Relationships xmlns="{package}/relationships"><Relationship Id="st" '
        f'Target="styles.xml" Type="{office}/styles"/>{links}</Relationships>',
        "xl/styles.xml": f'<styleSheet xmlns="{main}"><numFmts count="1"><numFmt numFmtId="170" formatCode="{form}"/>'
        '</numFmts><cellXfs><xf numFmtId="0"/><xf numFmtId="170" applyNumberFormat="1"/></cellXfs></styleSheet>',
    }
    for k, (_, rows, _) in enumerate(every, 1):
        sheet = f'<worksheet xmlns="{main}"><sheetData>{_sheet(rows)}</sheetData></worksheet>'
        files[f"xl/worksheets/sheet{k}.xml"] = sheet
    with zipfile.ZipFile(path, "w") as archive:
        for name, text in files.items():
            archive.writestr(name, text)
