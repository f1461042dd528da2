# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Gives the objects of a scan colours; writes a cloud, or without a second name shows it:

    python3 objects_with_open3d.py scan.pcd objects.ply
"""

import sys

import numpy as np
import open3d

import pcl_indoor

cloud = open3d.io.read_point_cloud(sys.argv[1])
scene = pcl_indoor.describe(np.asarray(cloud.points))
colors = np.random.default_rng(1).uniform(0.2, 1.0, size=(len(scene.objects) + 1, 3))
colors[0] = 0.5  # of no object
cloud.colors = open3d.utility.Vector3dVector(colors[scene.object_of_point])
if len(sys.argv) > 2:
    open3d.io.write_point_cloud(sys.argv[2], cloud)
else:
    open3d.visualization.draw_geometries([cloud])
