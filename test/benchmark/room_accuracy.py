#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Segment labelled scans into rooms and compare them with the truth, as a table.

    room_accuracy.py TOOLS_FOLDER [-truth_field F] [-options "..."] [-turn 13,30,45] scan.pcd ...

TOOLS_FOLDER holds pcl_room_segmentation and pcl_segmentation_evaluation; the scans have
the room of each point in a field (default: label; 0 = not to be judged). A room is right
if one predicted room has an intersection over union of at least 0.5 with it.

With -turn, each scan is segmented once per angle (degrees about its z axis), and the
table shows per scan the mean of the angles and, in brackets, the largest difference
between two of them. That needs numpy and uncompressed binary PCD files of floats.
"""
import argparse
import json
import os
import shlex
import subprocess
import tempfile


def turned(scan, degrees, output):
    """Write the scan turned about the z axis."""
    import numpy

    with open(scan, "rb") as file:
        content = file.read()
    lines, start = {}, 0
    while "DATA" not in lines:
        end = content.index(b"\n", start)
        key, _, value = content[start:end].decode().partition(" ")
        lines[key], start = value.split(), end + 1
    if lines["DATA"] != ["binary"] or lines["FIELDS"][:3] != ["x", "y", "z"] or lines["SIZE"][:3] != ["4"] * 3:
        raise SystemExit(f"{scan}: -turn reads binary PCD files that begin with the floats x, y, z only.")
    step = sum(int(size) * int(count) for size, count in zip(lines["SIZE"], lines["COUNT"]))
    bytes_ = numpy.frombuffer(content, numpy.uint8, int(lines["POINTS"][0]) * step, start).reshape(-1, step).copy()
    place = bytes_[:, :8].copy().view(numpy.float32).astype(numpy.float64)
    cosine, sine = numpy.cos(numpy.radians(degrees)), numpy.sin(numpy.radians(degrees))
    place = (place @ numpy.array([[cosine, sine], [-sine, cosine]])).astype(numpy.float32)
    bytes_[:, :8] = place.view(numpy.uint8)
    with open(output, "wb") as file:
        file.write(content[:start])
        file.write(bytes_.tobytes())


def evaluate(tools, scan, truth_field, options, folder):
    segmented = os.path.join(folder, "segmented.pcd")
    result = os.path.join(folder, "result.json")
    subprocess.run([os.path.join(tools, "pcl_room_segmentation"), scan, segmented, *options], check=True,
                   stdout=subprocess.DEVNULL)
    subprocess.run([os.path.join(tools, "pcl_segmentation_evaluation"), scan, segmented, "-truth_field", truth_field,
                    "-predicted_field", "room", "-json", result], check=True, stdout=subprocess.DEVNULL)
    with open(result, encoding="utf-8") as file:
        return json.load(file)


def totals(results):
    """Rooms, right rooms, mean IoU over the rooms, mean ARI over the scans."""
    rooms = sum(result["true_segments"] for result in results)
    right = sum(result["right_segments"] for result in results)
    iou = sum(result["mean_iou"] * result["true_segments"] for result in results) / rooms
    ari = sum(result["adjusted_rand_index"] for result in results) / len(results)
    return rooms, right, iou, ari


def name_of(scan):
    return os.path.splitext(os.path.basename(scan))[0]


def print_table(arguments, options, folder):
    print("| scan | points | rooms | right | found | mean IoU | ARI |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: |")
    results = []
    for scan in arguments.scans:
        result = evaluate(arguments.tools, scan, arguments.truth_field, options, folder)
        results.append(result)
        print(f"| {name_of(scan)} | {result['points']} | {result['true_segments']} "
              f"| {result['right_segments']} | {result['predicted_segments']} | {result['mean_iou']:.3f} "
              f"| {result['adjusted_rand_index']:.3f} |", flush=True)
    rooms, right, iou, ari = totals(results)
    print(f"| all | {sum(result['points'] for result in results)} | {rooms} | {right} ({right / rooms:.1%}) | "
          f"| {iou:.3f} | {ari:.3f} |")


def print_turns(arguments, options, folder):
    angles = [float(angle) for angle in arguments.turn.split(",")]
    print("| scan | rooms | right | mean IoU | ARI |\n| --- | ---: | ---: | ---: | ---: |")
    by_angle = [[] for _ in angles]

    def row(name, values):
        count, right, iou, ari = zip(*values)
        cells = [(right, ".1f"), (iou, ".3f"), (ari, ".3f")]
        texts = [f"{sum(v) / len(v):{style}} ({max(v) - min(v):{style}})" for v, style in cells]
        print(f"| {name} | {count[0]} | " + " | ".join(texts) + " |", flush=True)

    for scan in arguments.scans:
        copy = os.path.join(folder, "turned.pcd")
        for angle, results in zip(angles, by_angle):
            turned(scan, angle, copy)
            results.append(evaluate(arguments.tools, copy, arguments.truth_field, options, folder))
        row(name_of(scan), [totals(results[-1:]) for results in by_angle])
    row("all", [totals(results) for results in by_angle])
    for angle, results in zip(angles, by_angle):
        rooms, right, iou, ari = totals(results)
        print(f"| all, {angle:g} degrees | {rooms} | {right} ({right / rooms:.1%}) | {iou:.3f} | {ari:.3f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tools")
    parser.add_argument("scans", nargs="+")
    parser.add_argument("-truth_field", default="label")
    parser.add_argument("-options", default="", help="further options of pcl_room_segmentation")
    parser.add_argument("-turn", help="angles, degrees, with commas between them")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        (print_turns if arguments.turn else print_table)(arguments, shlex.split(arguments.options), folder)


if __name__ == "__main__":
    main()
