#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""How exactly the vertical of tilted scans is found.

    vertical_accuracy.py TOOLS_FOLDER [-tilts N] [-seed N] SCAN.pcd ...

TOOLS_FOLDER holds pcl_room_segmentation. The scans stand upright. Each is tilted N times, by 2 to 8 degrees about
a level axis that is drawn. The error is the angle between the vertical that is found and the true one; which end is up does
not count. What is tilted by less than a degree is taken as level, so an error may be as large as the tilt. Needs numpy.
"""
import argparse
import json
import os
import subprocess
import tempfile

import numpy

from point_files import name_of, read_fields, write_points


def tilting(random):
    """A turn about a level axis."""
    angle, azimuth = numpy.radians(random.uniform(2, 8)), random.uniform(0, 2 * numpy.pi)
    x, y = numpy.cos(azimuth), numpy.sin(azimuth)
    cross = numpy.array([[0, 0, y], [0, 0, -x], [-y, x, 0]])
    return numpy.eye(3) + numpy.sin(angle) * cross + (1 - numpy.cos(angle)) * cross @ cross


def found_vertical(tools, places):
    with tempfile.TemporaryDirectory() as folder:
        scan, rooms, result = (os.path.join(folder, name) for name in ("scan.pcd", "rooms.pcd", "rooms.json"))
        write_points(scan, dict(zip("xyz", places.T)))
        subprocess.run([f"{tools}/pcl_room_segmentation", scan, rooms, "-json", result, "-quiet"], check=True,
                       stderr=subprocess.DEVNULL)
        with open(result, encoding="utf-8") as file:
            parameters = dict(part.split(" ", 1) for part in json.load(file)["parameters"].split(", "))
    up = parameters["-up"]
    if up[-1] in "xyz":  # an axis: the scan was taken as level
        return numpy.eye(3)["xyz".index(up[-1])]
    direction = numpy.array([float(number) for number in up.split(",")])
    return direction / numpy.linalg.norm(direction)


def tell(name, errors):
    print(f"| {name} | {len(errors)} | {numpy.median(errors):.2f} | {numpy.quantile(errors, 0.9):.2f} | {max(errors):.2f} |",
          flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tools")
    parser.add_argument("scans", nargs="+")
    parser.add_argument("-tilts", type=int, default=3, help="of each scan (default: 3)")
    parser.add_argument("-seed", type=int, default=1, help="of the tilts (default: 1)")
    arguments = parser.parse_args()
    random = numpy.random.default_rng(arguments.seed)
    errors = []
    print("| scan | tilts | median error, degrees | nine of ten below | largest |\n| --- | ---: | ---: | ---: | ---: |")
    for scan in arguments.scans:
        places = numpy.stack(read_fields(scan, "xyz"), 1).astype(float)
        of_scan = []
        for _ in range(arguments.tilts):
            turn = tilting(random)
            cosine = abs(found_vertical(arguments.tools, places @ turn.T) @ turn[:, 2])
            of_scan.append(numpy.degrees(numpy.arccos(min(1, cosine))))
        tell(name_of(scan), of_scan)
        errors += of_scan
    tell("all", errors)


main()
