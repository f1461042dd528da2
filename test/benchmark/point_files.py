# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""PCD files and polygons, for the scripts of this folder. Needs numpy; liblzf1, where it is there, unpacks faster."""
import ctypes
import os

import numpy


def name_of(path):
    """The name of a file without folder and ending."""
    return os.path.splitext(os.path.basename(path))[0]


def inside(polygon, x, y):
    """Which places are in a polygon, by the even-odd rule."""
    hit = numpy.zeros(x.shape, bool)
    for (x0, y0), (x1, y1) in zip(polygon, numpy.roll(polygon, -1, axis=0)):
        if y0 != y1:
            hit ^= ((y0 > y) != (y1 > y)) & (x < (x1 - x0) * (y - y0) / (y1 - y0) + x0)
    return hit


def unpacked(data, size):
    """What LZF packed: runs, and copies of what came before."""
    try:
        library = ctypes.CDLL("liblzf.so.1")
    except OSError:
        library = None
    if library:
        result = ctypes.create_string_buffer(size)
        if library.lzf_decompress(data, len(data), result, size) != size:
            raise SystemExit("the compressed data is damaged")
        return result.raw
    out, at = bytearray(), 0
    while at < len(data):
        control = data[at]
        at += 1
        if control < 32:
            out += data[at:at + control + 1]
            at += control + 1
            continue
        length = control >> 5
        if length == 7:
            length += data[at]
            at += 1
        start = len(out) - ((control & 31) << 8) - data[at] - 1
        at += 1
        for part in range(length + 2):
            out.append(out[start + part])
    assert len(out) == size
    return bytes(out)


def header_of(content):
    """The words of each line of a PCD file's header by the first one, and where the points begin."""
    header, start = {}, 0
    while "DATA" not in header:
        end = content.index(b"\n", start)
        key, _, value = content[start:end].decode().partition(" ")
        header[key], start = value.split(), end + 1
    return header, start


def all_fields(path):
    with open(path, "rb") as file:
        content = file.read()
    header, start = header_of(content)
    count, mode = int(header["POINTS"][0]), header["DATA"][0]
    counts = [int(c) for c in header.get("COUNT", ["1"] * len(header["FIELDS"]))]
    names = [f"_{i}" if name == "_" else name for i, name in enumerate(header["FIELDS"])]  # padding is often several
    if mode == "ascii":
        rows = numpy.array([line.split() for line in content[start:].decode().splitlines()], float)
        return {name: rows[:, sum(counts[:i])] for i, name in enumerate(names) if counts[i] == 1}
    kinds = [f"<{kind.lower()}{size}" for kind, size in zip(header["TYPE"], header["SIZE"])]
    if mode == "binary":
        rows = numpy.frombuffer(content, numpy.dtype(list(zip(names, kinds, [(c,) for c in counts]))), count, start)
        return {name: rows[name][:, 0] for name, c in zip(names, counts) if c == 1}
    packed, size = numpy.frombuffer(content, "<u4", 2, start)
    body, at, columns = unpacked(content[start + 8:start + 8 + int(packed)], int(size)), 0, {}
    for name, kind, c in zip(names, kinds, counts):
        if c == 1:
            columns[name] = numpy.frombuffer(body, kind, count, at)
        at += count * c * numpy.dtype(kind).itemsize
    return columns


def read_fields(path, names=None):
    """The fields of a PCD file that have one element, by name; or a list of those with these names."""
    fields = all_fields(path)
    return fields if names is None else [fields[name] for name in names]


def write_points(path, fields):
    """An uncompressed PCD file of these columns: whole numbers and others, of 4 bytes each."""
    whole = [numpy.issubdtype(numpy.asarray(column).dtype, numpy.integer) for column in fields.values()]
    record = numpy.zeros(len(next(iter(fields.values()))),
                         [(name, "<u4" if is_whole else "<f4") for name, is_whole in zip(fields, whole)])
    for name, column in fields.items():
        record[name] = column
    with open(path, "wb") as file:
        file.write((f"VERSION 0.7\nFIELDS {' '.join(fields)}\nSIZE {' '.join('4' for _ in fields)}\n"
                    f"TYPE {' '.join('U' if is_whole else 'F' for is_whole in whole)}\n"
                    f"COUNT {' '.join('1' for _ in fields)}\nWIDTH {len(record)}\nHEIGHT 1\n"
                    f"VIEWPOINT 0 0 0 1 0 0 0\nPOINTS {len(record)}\nDATA binary\n").encode())
        file.write(record.tobytes())
