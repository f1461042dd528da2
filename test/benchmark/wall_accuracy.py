#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Compare the walls in scene.json with those of the plans that were scanned.

    wall_accuracy.py BUILD_FOLDER PLAN.json ...

BUILD_FOLDER holds tools/pcl_scan_simulation and tools/pcl_indoor_pipeline. The plan's walls are the edges of its
rooms, as thick as it says; their ends are the corners of the rooms. A wall of which one side was seen has no
thickness in the scene: here it gets that of the plan behind this side, and its ends move by half of it.

    ends       F1 of the ends of walls, one end for one corner, within 10 cm
    on axis    share of the walls' length that lies within 3 cm of an edge
    thickness  median error of walls of which both sides were seen
    IoU        of the areas of walls seen from above, in cells of 2 cm; doors and windows count as wall
Needs numpy.
"""
import argparse
import json
import os
import subprocess
import tempfile

import numpy

REACH, ON_AXIS, CELL, SAME = 0.1, 0.03, 0.02, 0.05  # metres


def distinct(places):
    kept = []
    for place in places:
        if all(numpy.hypot(*(place - other)) > SAME for other in kept):
            kept.append(place)
    return kept


def edges_of(storey):
    """Pairs of corners; arcs are left out."""
    for room in storey["rooms"]:
        corners = [numpy.array(corner, float) for corner in room["polygon"] if isinstance(corner, list)]
        yield from zip(corners, corners[1:] + corners[:1])


class Wall:
    """A wall of a scene: its axis, and how far it reaches to the left and right of the line that the scene tells."""

    def __init__(self, told, thickness):
        self.line = numpy.array(told["begin"][:2]), numpy.array(told["end"][:2])
        self.thickness = told.get("thickness")
        way = self.line[1] - self.line[0]
        self.length = numpy.hypot(*way)
        along = way / max(self.length, 1e-9)
        left = numpy.array([-along[1], along[0]])
        half = 0.0 if self.thickness else 0.5 * thickness
        self.axis = self.line[0] - half * (left + along), self.line[1] - half * (left - along)
        self.width = self.thickness or thickness


def distance(place, edge):
    way = edge[1] - edge[0]
    share = numpy.clip((place - edge[0]) @ way / (way @ way), 0, 1)
    return numpy.hypot(*(place - edge[0] - share * way))


def matched(ends, corners):
    """How many ends lie near a corner of their own."""
    left, count = list(corners), 0
    for end in ends:
        ways = [numpy.hypot(*(end - corner)) for corner in left]
        if ways and min(ways) <= REACH:
            left.pop(int(numpy.argmin(ways)))
            count += 1
    return count


def area(strips, low, high):
    """Cells that strips, of a line, a width and what they go on at both ends, cover."""
    count = numpy.ceil((high - low) / CELL).astype(int)
    x, y = numpy.meshgrid(*(low[k] + CELL * (numpy.arange(count[k]) + 0.5) for k in (0, 1)), indexing="ij")
    covered = numpy.zeros(count, bool)
    for (begin, end), width, beyond in strips:
        length = numpy.hypot(*(end - begin))
        if length < 1e-6:
            continue
        along = (end - begin) / length
        u = (x - begin[0]) * along[0] + (y - begin[1]) * along[1]
        v = (y - begin[1]) * along[0] - (x - begin[0]) * along[1]
        covered |= (u >= -beyond) & (u <= length + beyond) & (abs(v) <= 0.5 * width)
    return covered


def measures(plan, scene):
    for number, storey in enumerate(plan["storeys"]):
        thickness = plan["wall_thickness"]
        edges = list(edges_of(storey))
        corners = distinct([corner for edge in edges for corner in edge])
        walls = [Wall(told, thickness) for told in scene["walls"] if told["storey"] == number]
        ends = distinct([end for wall in walls for end in wall.axis])
        places = [(wall.axis[0] + share * (wall.axis[1] - wall.axis[0]), wall.length)
                  for wall in walls for share in numpy.arange(0.05, 1, 0.1)]
        on_axis = sum(length for place, length in places if min(distance(place, edge) for edge in edges) < ON_AXIS)
        errors = [abs(wall.thickness - thickness) for wall in walls if wall.thickness]
        low, high = numpy.min(corners, axis=0) - 1, numpy.max(corners, axis=0) + 1
        true = area([(edge, thickness, 0.5 * thickness) for edge in edges], low, high)
        found = area([(wall.axis, wall.width, 0.0) for wall in walls], low, high)
        yield {"storey": storey["name"], "walls": len(walls), "right": matched(ends, corners), "ends": len(ends),
               "corners": len(corners), "on": on_axis, "length": sum(length for _, length in places),
               "errors": errors, "both": (true & found).sum(), "either": (true | found).sum()}


def row(name, each):
    thickness = f"{100 * numpy.median(each['errors']):.1f}" if each["errors"] else "-"
    return (f"| {name} | {each['walls']} | {each['right']} of {each['corners']}, {each['ends']}: "
            f"{2 * each['right'] / max(1, each['ends'] + each['corners']):.2f} | "
            f"{each['on'] / max(1e-9, each['length']):.2f} | {thickness} | {each['both'] / max(1, each['either']):.2f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("plans", nargs="+")
    options = parser.parse_args()
    print("| storey | walls | ends, F1 | on axis | thickness, cm | IoU |\n| --- | ---: | ---: | ---: | ---: | ---: |")
    total = {}
    with tempfile.TemporaryDirectory() as folder:
        for path in options.plans:
            scan = os.path.join(folder, "scan.pcd")
            subprocess.run([f"{options.build}/tools/pcl_scan_simulation", path, scan, "-quiet"], check=True)
            subprocess.run([f"{options.build}/tools/pcl_indoor_pipeline", scan, f"{folder}/result", "-model", "none",
                            "-report", "none", "-quiet"], check=True)
            with open(path) as plan, open(f"{folder}/result/scene.json") as scene:
                for each in measures(json.load(plan), json.load(scene)):
                    name = os.path.basename(path).removesuffix(".json") + ", " + each.pop("storey")
                    print(row(name, each), flush=True)
                    for key, value in each.items():
                        total[key] = total[key] + value if key in total else value
    print(row("all", total))


if __name__ == "__main__":
    main()
