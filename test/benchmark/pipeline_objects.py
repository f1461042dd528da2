#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Run pcl_indoor_pipeline on whole labelled buildings and compare its objects with the truth, as a table.

    pipeline_objects.py TOOLS_FOLDER scan.pcd ...

Rooms are found, not given. The scans have the true object of each point in the field object_id, 0 = the building or
not known, and the room in the field label, 0 = outside. Right, PQ and AP50 are those of pcl_segmentation_evaluation,
objects of fewer than 100 points void. They do not tell how much of the building is taken for objects; the last
columns do:

    flagged   share of the building's points that are floor, wall or ceiling
    objects   segments of at least 100 points that are none of these
    building  those of them most of whose points are of the building

The last row has the sums, and the means of shares.
Needs numpy.
"""
import argparse
import json
import os
import subprocess
import tempfile

import numpy

from point_files import name_of, read_fields


def building_in(cloud):
    """Share of the building that is flagged, number of objects, and of those that are building."""
    room, true_object, found, structure = read_fields(cloud, ["label", "object_id", "object", "structure"])
    inside = room > 0 if room.any() else room == 0
    building = true_object == 0
    in_object = inside & (structure == 0) & (found > 0)
    _, segment = numpy.unique(found[in_object], return_inverse=True)
    points = numpy.bincount(segment)
    of_building = numpy.bincount(segment, weights=building[in_object])
    objects = points >= 100
    flagged = numpy.isin(structure, [1, 2, 3])[inside & building].mean()
    return flagged, objects.sum(), (objects & (2 * of_building > points)).sum()


def print_row(name, row):
    right, true, quality, precision, share, objects, wrong = row
    print(f"| {name} | {right:.0f} of {true:.0f} | {quality:.3f} | {precision:.3f} | {100 * share:.1f} | {objects:.0f} | {wrong:.0f} |",
          flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tools")
    parser.add_argument("scans", nargs="+")
    arguments = parser.parse_args()

    print("| scan | right | PQ | AP50 | flagged % | objects | building |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: |")
    rows = []
    for scan in arguments.scans:
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([os.path.join(arguments.tools, "pcl_indoor_pipeline"), scan, folder, "-quiet",
                            "-report", "none", "-model", "none"], check=True)
            cloud, result = os.path.join(folder, "cloud.pcd"), os.path.join(folder, "result.json")
            subprocess.run([os.path.join(arguments.tools, "pcl_segmentation_evaluation"), cloud, cloud, "-truth_field",
                            "object_id", "-min_points", "100", "-json", result, "-quiet"],
                           check=True, stdout=subprocess.DEVNULL)
            with open(result, encoding="utf-8") as file:
                score = json.load(file)
            rows.append((score["right_segments"], score["true_segments"], score["panoptic_quality"],
                         score["average_precision_50"], *building_in(cloud)))
        print_row(name_of(scan), rows[-1])
    table = numpy.array(rows)
    print_row("**all**", numpy.where([1, 1, 0, 0, 0, 1, 1], table.sum(axis=0), table.mean(axis=0)))


if __name__ == "__main__":
    main()
