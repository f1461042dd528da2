#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Count the rooms that are found outdoors, in gardens with trees around simulated houses.

    gardens.py TOOLS_FOLDER [-plans random:home:31 ...] [-options "..."] [-seed N]

TOOLS_FOLDER holds pcl_scan_simulation and pcl_room_segmentation. Around each plan lie 8 to
25 m of sloping ground with three to seven trees: hollow, full, or clumps of leaves on a
trunk; facades are seen from outside. A room is right if one predicted room has an
intersection over union of at least 0.5 with it; one is outdoors if most of its points are
of the garden. Needs numpy.
"""
import argparse
import shlex
import subprocess
import tempfile

import numpy

from point_files import read_fields

MOST_POINTS = 150000  # of the house


def tree(random, foot, height):
    """A crown on a trunk, n x 3."""
    radius = random.uniform(1.0, 3.2)
    count = int(random.uniform(500, 2500) * radius**2)
    directions = random.normal(size=(count, 3))
    directions /= numpy.linalg.norm(directions, axis=1)[:, None]
    kind = random.integers(3)
    if kind == 0:
        crown = directions * radius * random.uniform(0.5, 1.0, (count, 1))
    elif kind == 1:
        crown = directions * radius * numpy.cbrt(random.uniform(size=(count, 1)))
    else:
        clumps = random.normal(size=(12, 3)) * radius / 2
        crown = clumps[random.integers(12, size=count)] + random.normal(size=(count, 3)) * radius / 8
    turn = random.uniform(0.0, 2.0 * numpy.pi, 400)
    trunk = 0.15 * numpy.c_[numpy.cos(turn), numpy.sin(turn), numpy.zeros(400)]
    trunk[:, 2] = random.uniform(0.0, height, 400)
    return foot + numpy.r_[crown + [0.0, 0.0, height], trunk]


def garden(random, house):
    """Ground, trees and facades around the points of a house, n x 3."""
    low, high = numpy.percentile(house, 0.5, 0), numpy.percentile(house, 99.5, 0)
    inner = numpy.array([low[:2] - 0.35, high[:2] + 0.35])
    width = random.uniform(8.0, 25.0)
    outer = inner + [[-width], [width]]
    slope = random.normal(size=2) * 0.02

    def at_ground(place):
        return numpy.c_[place, low[2] - 0.15 + (place - inner[0]) @ slope]

    ground = random.uniform(*outer, (int(numpy.prod(outer[1] - outer[0]) * random.uniform(20, 60)), 2))
    ground = ground[((ground < inner[0]) | (ground > inner[1])).any(1)]
    parts = [at_ground(ground) + random.normal(size=(len(ground), 3)) * [0, 0, 0.02]]
    for _ in range(random.integers(3, 8)):
        foot = random.uniform(*outer)
        axis, side = random.integers(2, size=2)
        foot[axis] = inner[side][axis] + (2 * side - 1) * random.uniform(3.0, width - 1.0)
        parts.append(tree(random, at_ground(foot[None]), random.uniform(3.0, 7.0)))
    for axis in (0, 1):
        for side in (0, 1):
            length = inner[1][1 - axis] - inner[0][1 - axis]
            facade = numpy.zeros((int(600 * length), 3))
            facade[:, axis] = inner[side][axis]
            facade[:, 1 - axis] = random.uniform(inner[0][1 - axis], inner[1][1 - axis], len(facade))
            facade[:, 2] = random.uniform(low[2] - 0.1, high[2] + 0.2, len(facade))
            parts.append(facade + random.normal(size=facade.shape) * 0.01)
    return numpy.concatenate(parts)


def save(path, points):
    header = f"""VERSION 0.7
FIELDS x y z
SIZE 4 4 4
TYPE F F F
COUNT 1 1 1
WIDTH {len(points)}
HEIGHT 1
POINTS {len(points)}
DATA binary
"""
    with open(path, "wb") as file:
        file.write(header.encode() + points.astype(numpy.float32).tobytes())


def judged(true, found):
    """Right rooms, true rooms, rooms found, and those of them that are outdoors."""
    pairs, counts = numpy.unique(numpy.c_[true, found], axis=0, return_counts=True)
    of_true, of_found = numpy.bincount(true), numpy.bincount(found)
    right = sum(
        t > 0 and f > 0 and 2 * n >= of_true[t] + of_found[f] - n for (t, f), n in zip(pairs, counts)
    )
    garden_points = dict(zip(pairs[pairs[:, 0] == 0][:, 1], counts[pairs[:, 0] == 0]))
    outdoors = sum(2 * garden_points.get(f, 0) > of_found[f] for f in range(1, len(of_found)) if of_found[f])
    return right, len(numpy.unique(true[true > 0])), len(numpy.unique(found[found > 0])), outdoors


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tools")
    parser.add_argument("-plans", nargs="+", default=[f"random:home:{seed}" for seed in range(31, 41)])
    parser.add_argument("-options", default="", help="of pcl_room_segmentation")
    parser.add_argument("-seed", type=int, default=1)
    arguments = parser.parse_args()
    print("| plan | right rooms | found | of these outdoors |\n| --- | --- | --- | --- |")
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        scan, result = f"{folder}/scan.pcd", f"{folder}/rooms.pcd"
        for number, plan in enumerate(arguments.plans):
            random = numpy.random.default_rng([arguments.seed, number])
            subprocess.run([f"{arguments.tools}/pcl_scan_simulation", plan, scan, "-quiet"], check=True)
            house = read_fields(scan)
            points = numpy.c_[house["x"], house["y"], house["z"]]
            kept = random.permutation(len(points))[:MOST_POINTS]
            around = garden(random, points)
            true = numpy.r_[house["room"][kept], numpy.zeros(len(around))].astype(int)
            save(scan, numpy.r_[points[kept], around])
            command = [f"{arguments.tools}/pcl_room_segmentation", scan, result, "-quiet"]
            subprocess.run(command + shlex.split(arguments.options), check=True, stderr=subprocess.DEVNULL)
            rows.append(judged(true, read_fields(result)["room"].astype(int)))
            right, there, found, outdoors = rows[-1]
            print(f"| {plan} | {right} of {there} | {found} | {outdoors} |", flush=True)
    right, there, found, outdoors = numpy.sum(rows, 0)
    print(f"| all | {right} of {there} | {found} | {outdoors} |")


if __name__ == "__main__":
    main()
