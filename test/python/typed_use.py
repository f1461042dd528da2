# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""What a user's program does with the package; mypy checks its types."""

from typing import Dict, List, Optional

import numpy as np
from numpy.typing import NDArray

import pcl_indoor


def areas(path: str) -> Dict[int, float]:
    scene: pcl_indoor.Scene = pcl_indoor.describe(path, voxel_size=0.1, up=(0, 0, 1), threads=2)
    heights: List[float] = [room.box.upper[2] for room in scene.rooms if room.box is not None]
    thickness: Optional[float] = scene.walls[0].thickness
    labels: Optional[NDArray[np.uint32]] = scene.room_of_point
    print(heights, thickness, labels, scene.to_dict()["version"])
    return {room.number: room.area for room in scene.rooms}


def largest_object(points: NDArray[np.float64]) -> pcl_indoor.Classification:
    messages: List[str] = []
    labels = pcl_indoor.segment_objects(points, preset="objects", messages=messages)
    normals: NDArray[np.float32] = pcl_indoor.estimate_normals(points, k=20)
    inside = labels == np.bincount(labels[labels > 0]).argmax()
    values: NDArray[np.float32] = pcl_indoor.descriptor(
        points[inside], point_normals=normals[inside], bins=(8, 15, 5, 1, 3, 6, 12)
    )
    print(values.sum())
    return pcl_indoor.classify([points[inside]], floor_distances=[0.0])[0]


def fields(path: str) -> List[str]:
    scan: pcl_indoor.Scan = pcl_indoor.load(path)
    points: NDArray[np.float32] = scan.points
    print(points.shape, pcl_indoor.segment_rooms(scan, progress=lambda stage, done, of: None))
    return list(scan.fields)
