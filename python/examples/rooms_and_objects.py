# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Lists the rooms of a scan and the objects in them:

    python3 rooms_and_objects.py scan.pcd
"""

import sys

import numpy as np

import pcl_indoor

scene = pcl_indoor.describe(sys.argv[1])
for room in scene.rooms:
    found = [scene.objects[number - 1] for number in room.objects]
    names = sorted(item.name or "object" for item in found if item.structure == "none")
    print(f"room {room.number}: {room.area:.1f} m^2, {room.height:.2f} m high, {', '.join(names)}")
for opening in scene.openings:
    print(f"{opening.kind} {opening.width:.2f} m wide between rooms {opening.rooms}")
if scene.room_of_point is not None:
    print("points per room:", np.bincount(scene.room_of_point)[1:])
