# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Rooms, objects and classes out of scans of buildings.

    import pcl_indoor

    scene = pcl_indoor.describe("scan.pcd")   # or N x 3 numbers
    for room in scene.rooms:
        print(room.number, room.area, "m^2")

Every function does what one of the pcl_* tools does, with options of the same names; what cannot be
used is an InputError, a ValueError with the line that the tool says. Functions may be called from
several threads; the library uses several itself.
"""

from ._call import PclIndoorWarning
from ._core import InputError, Scan, __version__
from .classes import Classification, classify, descriptor
from .objects import estimate_normals, segment_objects
from .rooms import segment_rooms
from .scan import load
from .scene import (
    Box,
    Column,
    Neighbour,
    Opening,
    Room,
    Scene,
    SceneObject,
    Storey,
    UprightBox,
    Wall,
    describe,
    load_scene,
)

__all__ = [
    "Box",
    "Classification",
    "Column",
    "InputError",
    "Neighbour",
    "Opening",
    "PclIndoorWarning",
    "Room",
    "Scan",
    "Scene",
    "SceneObject",
    "Storey",
    "UprightBox",
    "Wall",
    "__version__",
    "classify",
    "describe",
    "descriptor",
    "estimate_normals",
    "load",
    "load_scene",
    "segment_objects",
    "segment_rooms",
]

for _public in (InputError, Scan):
    _public.__module__ = "pcl_indoor"
