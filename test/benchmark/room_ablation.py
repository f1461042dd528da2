#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""What each part of the thesis's room segmentation is worth, as a table.

    room_ablation.py TOOLS_FOLDER [-truth_field F] [-only TEXT] scan.pcd ...

Segments all scans with each setting, see room_accuracy.py for scans, tools and figures.
"""
import argparse
import shlex
import tempfile

from room_accuracy import evaluate, totals

FIELD = "-method field -voxel_size {0} -interior_voxel_size {0}"
THESIS = FIELD.format("0.2")

SETTINGS = [
    ("defaults", ""),
    ("defaults, voxels of 15 cm", "-voxel_size 0.15"),
    ("defaults, voxels of 20 cm", "-voxel_size 0.2"),
    ("thesis: weights 0.7 / 0.25 / 0.05, voxels of 20 cm", THESIS),
    ("thesis, voxels of 15 cm", FIELD.format("0.15")),
    ("thesis, voxels of 10 cm", FIELD.format("0.1")),
    ("thesis, points on voxels of 10 cm, field on voxels of 20 cm", "-method field"),
    ("thesis, without visibility", THESIS + " -visibility_weight 0"),
    ("thesis, without field", THESIS + " -field_weight 0"),
    ("thesis, weights 0.3 / 0.6 / 0.1 of the conference paper", THESIS + " -euclidean_weight 0.3 -field_weight 0.6 "
     "-visibility_weight 0.1"),
] + [(f"thesis, DBSCAN at {distance}", f"{THESIS} -dbscan_distance {distance}")
     for distance in (0.15, 0.2, 0.23, 0.25, 0.27)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tools")
    parser.add_argument("scans", nargs="+")
    parser.add_argument("-truth_field", default="label")
    parser.add_argument("-only", default="", help="only settings whose name contains this text")
    arguments = parser.parse_args()

    print("| setting | options | right | mean IoU | ARI |\n| --- | --- | ---: | ---: | ---: |")
    with tempfile.TemporaryDirectory() as folder:
        for name, options in SETTINGS:
            if arguments.only not in name:
                continue
            results = [evaluate(arguments.tools, scan, arguments.truth_field, shlex.split(options), folder)
                       for scan in arguments.scans]
            rooms, right, iou, ari = totals(results)
            print(f"| {name} | `{options}` | {right / rooms:.1%} | {iou:.3f} | {ari:.3f} |", flush=True)


if __name__ == "__main__":
    main()
