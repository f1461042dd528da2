# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Draws the rooms and walls of the lowest storey of a scan whose z axis points up:

    python3 plan_with_matplotlib.py scan.pcd plan.png
"""

import sys

import matplotlib.pyplot as plt

import pcl_indoor

scene = pcl_indoor.describe(sys.argv[1])
figure, axes = plt.subplots()
for room in scene.rooms:
    if room.storey > 0 or not room.footprint:
        continue
    x, y, _ = zip(*room.footprint[0])
    axes.fill(x, y, alpha=0.4)
    axes.text(sum(x) / len(x), sum(y) / len(y), f"{room.number}\n{room.area:.1f} m²", ha="center")
for wall in scene.walls:
    if wall.storey == 0:
        axes.plot(*zip(wall.begin[:2], wall.end[:2]), color="black")
for opening in scene.openings:
    if opening.storey == 0:
        axes.plot(*opening.position[:2], "o", label=opening.kind)
axes.set_aspect("equal")
figure.savefig(sys.argv[2], dpi=150)
