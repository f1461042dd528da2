# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""The simulated flat, what the tools find in it, and clouds in files."""

import contextlib
import io
import os
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

import pcl_indoor

sys.path.append(str(Path(__file__).parent.parent / "benchmark"))
from point_files import unpacked  # noqa: E402

FOLDER = Path(os.environ["PCL_INDOOR_FLAT"])
TOOLS = Path(os.environ["PCL_INDOOR_TOOLS"])
SCAN = FOLDER / "flat.pcd"
RESULT = FOLDER / "result"


def quiet_load(path):
    return pcl_indoor.load(path, messages=[])


def points():
    """N x 3, float32, as the file has them."""
    fields = quiet_load(SCAN).fields
    return np.stack([fields["x"], fields["y"], fields["z"]], axis=1)


def run(tool, *arguments):
    """What a tool says, and its exit status."""
    done = subprocess.run(
        [TOOLS / f"pcl_{tool}", *map(str, arguments)], capture_output=True, text=True
    )
    return done.returncode, done.stdout + done.stderr


def fields_of(tool, scan, *options):
    """The fields of the cloud that a tool writes."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "out.pcd"
        status, said = run(tool, scan, out, "-quiet", *options)
        assert status == 0, said
        return {name: values.copy() for name, values in quiet_load(out).fields.items()}


def complaint(tool, *arguments):
    """The one line with which a tool refuses, without its name."""
    status, said = run(tool, *arguments)
    assert status == 1, said
    return said.strip().splitlines()[-1].split("] ", 1)[1]


def save(path, **fields):
    """A binary PCD of float32 fields."""
    names = list(fields)
    values = np.stack([np.asarray(fields[name], np.float32) for name in names], axis=1)
    header = (
        f"VERSION 0.7\nFIELDS {' '.join(names)}\nSIZE {' '.join('4' for _ in names)}\n"
        f"TYPE {' '.join('F' for _ in names)}\nCOUNT {' '.join('1' for _ in names)}\n"
        f"WIDTH {len(values)}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {len(values)}\n"
        "DATA binary\n"
    )
    Path(path).write_bytes(header.encode() + np.ascontiguousarray(values).tobytes())


def living_room():
    """The points of the flat's largest room."""
    found = quiet_load(RESULT / "cloud.pcd").fields
    rooms = np.asarray(found["room"])
    largest = np.argmax(np.bincount(rooms[rooms > 0]))
    return points()[rooms == largest]


def objects():
    """The points of some objects of the flat, the largest first."""
    scene = pcl_indoor.load_scene(RESULT / "scene.json")
    labels = np.asarray(quiet_load(RESULT / "cloud.pcd").fields["object"])
    wanted = sorted(
        (one for one in scene.objects if one.structure == "none"), key=lambda one: -one.points
    )
    return [points()[labels == one.number] for one in wanted[:4]]


def histogram_of(path):
    """The one field of a descriptor's PCD."""
    header, _, data = Path(path).read_bytes().partition(b"\nDATA ")
    kind, _, data = data.partition(b"\n")
    if kind == b"binary_compressed":
        packed, size = struct.unpack("<II", data[:8])
        data = unpacked(data[8 : 8 + packed], size)
    assert kind != b"ascii"
    count = int(header.partition(b"COUNT ")[2].split()[0])
    return np.frombuffer(data[: 4 * count], np.float32)
