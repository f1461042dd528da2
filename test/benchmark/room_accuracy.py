#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Segment labelled scans into rooms and compare them with the truth, as a table.

    room_accuracy.py TOOLS_FOLDER [-truth_field F] [-options "..."] scan.pcd ...

TOOLS_FOLDER holds pcl_room_segmentation and pcl_segmentation_evaluation; the scans have
the room of each point in a field (default: label; 0 = not to be judged). A room is right
if one predicted room has an intersection over union of at least 0.5 with it.
"""
import argparse
import json
import os
import shlex
import subprocess
import tempfile


def evaluate(tools, scan, truth_field, options, folder):
    segmented = os.path.join(folder, "segmented.pcd")
    result = os.path.join(folder, "result.json")
    subprocess.run([os.path.join(tools, "pcl_room_segmentation"), scan, segmented, *options], check=True,
                   stdout=subprocess.DEVNULL)
    subprocess.run([os.path.join(tools, "pcl_segmentation_evaluation"), scan, segmented, "-truth_field", truth_field,
                    "-predicted_field", "room", "-json", result], check=True, stdout=subprocess.DEVNULL)
    with open(result, encoding="utf-8") as file:
        return json.load(file)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tools")
    parser.add_argument("scans", nargs="+")
    parser.add_argument("-truth_field", default="label")
    parser.add_argument("-options", default="", help="further options of pcl_room_segmentation")
    arguments = parser.parse_args()

    print("| scan | points | rooms | right | found | mean IoU | ARI |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: |")
    results = []
    with tempfile.TemporaryDirectory() as folder:
        for scan in arguments.scans:
            result = evaluate(arguments.tools, scan, arguments.truth_field, shlex.split(arguments.options), folder)
            results.append(result)
            print(f"| {os.path.splitext(os.path.basename(scan))[0]} | {result['points']} | {result['true_segments']} "
                  f"| {result['right_segments']} | {result['predicted_segments']} | {result['mean_iou']:.3f} "
                  f"| {result['adjusted_rand_index']:.3f} |", flush=True)
    rooms = sum(result["true_segments"] for result in results)
    right = sum(result["right_segments"] for result in results)
    iou = sum(result["mean_iou"] * result["true_segments"] for result in results) / rooms
    ari = sum(result["adjusted_rand_index"] for result in results) / len(results)
    print(f"| all | {sum(result['points'] for result in results)} | {rooms} | {right} ({right / rooms:.1%}) | "
          f"| {iou:.3f} | {ari:.3f} |")


if __name__ == "__main__":
    main()
