#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Segment labelled scans into rooms and compare them with the truth, as a table.

    room_accuracy.py TOOLS_FOLDER [-truth_field F] [-options "..."] [-turn 13,30,45]
                     [-shear 0,5,10,20 [-towards 0,45,90]] scan.pcd ...

TOOLS_FOLDER holds pcl_room_segmentation and pcl_segmentation_evaluation; the scans have
the room of each point in a field (default: label; 0 = not to be judged). A room is right
if one predicted room has an intersection over union of at least 0.5 with it. Rooms that a
scan.json beside the scan marks with "room": false or "outdoor": true are not judged.

With -turn, each scan is segmented once per angle (degrees about its z axis), and the
table shows per scan the mean of the angles and, in brackets, the largest difference
between two of them. With -shear, everything leans by each angle (degrees from the
vertical) towards each heading of -towards (degrees about the z axis from x): floors and
ceilings stay level and walls lean. Both need numpy and uncompressed binary PCD files of
floats.
"""
import argparse
import json
import os
import shlex
import subprocess
import tempfile


def moved(scan, change, output):
    """Write the scan with its places changed."""
    import numpy

    from point_files import header_of

    with open(scan, "rb") as file:
        content = file.read()
    lines, start = header_of(content)
    if lines["DATA"] != ["binary"] or lines["FIELDS"][:3] != ["x", "y", "z"] or lines["SIZE"][:3] != ["4"] * 3:
        raise SystemExit(f"{scan}: -turn and -shear read binary PCD files that begin with the floats x, y, z only.")
    step = sum(int(size) * int(count) for size, count in zip(lines["SIZE"], lines["COUNT"]))
    bytes_ = numpy.frombuffer(content, numpy.uint8, int(lines["POINTS"][0]) * step, start).reshape(-1, step).copy()
    place = bytes_[:, :12].copy().view(numpy.float32).astype(numpy.float64)
    bytes_[:, :12] = change(place).astype(numpy.float32).view(numpy.uint8)
    with open(output, "wb") as file:
        file.write(content[:start])
        file.write(bytes_.tobytes())


def turned(scan, degrees, output):
    """Write the scan turned about the z axis."""
    import numpy

    cosine, sine = numpy.cos(numpy.radians(degrees)), numpy.sin(numpy.radians(degrees))
    moved(scan, lambda place: place @ numpy.array([[cosine, sine, 0], [-sine, cosine, 0], [0, 0, 1]]), output)


def sheared(scan, degrees, heading, output):
    """Write the scan with all that is upright leaning by an angle in a direction."""
    import numpy

    slope = numpy.tan(numpy.radians(degrees))
    shift = slope * numpy.array([numpy.cos(numpy.radians(heading)), numpy.sin(numpy.radians(heading)), 0])
    moved(scan, lambda place: place + (place[:, 2:] - numpy.nanmin(place[:, 2])) * shift, output)


def unscored(scan):
    """The numbers of the rooms that scan.json, if there is one, says are no rooms or outdoors."""
    description = os.path.splitext(scan)[0] + ".json"
    if not os.path.exists(description):
        return []
    with open(description, encoding="utf-8") as file:
        rooms = json.load(file).get("rooms", [])
    return [str(room["id"]) for room in rooms
            if "id" in room and (room.get("outdoor", False) or not room.get("room", True))]


def evaluate(tools, scan, truth_field, options, folder, ignored=()):
    segmented = os.path.join(folder, "segmented.pcd")
    result = os.path.join(folder, "result.json")
    subprocess.run([os.path.join(tools, "pcl_room_segmentation"), scan, segmented, *options], check=True,
                   stdout=subprocess.DEVNULL)
    subprocess.run([os.path.join(tools, "pcl_segmentation_evaluation"), scan, segmented, "-truth_field", truth_field,
                    "-predicted_field", "room", "-json", result,
                    *(["-ignore", ",".join(ignored)] if ignored else [])], check=True, stdout=subprocess.DEVNULL)
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
        result = evaluate(arguments.tools, scan, arguments.truth_field, options, folder, unscored(scan))
        results.append(result)
        print(f"| {name_of(scan)} | {result['points']} | {result['true_segments']} "
              f"| {result['right_segments']} | {result['predicted_segments']} | {result['mean_iou']:.3f} "
              f"| {result['adjusted_rand_index']:.3f} |", flush=True)
    rooms, right, iou, ari = totals(results)
    print(f"| all | {sum(result['points'] for result in results)} | {rooms} | {right} ({right / rooms:.1%}) | "
          f"| {iou:.3f} | {ari:.3f} |")


def angles_of(text):
    return [float(angle) for angle in text.split(",")]


def print_variants(arguments, options, folder):
    """One row per scan over all its variants, one row per variant over all scans."""
    if arguments.turn:
        variants = [(f"{angle:g} degrees", turned, (angle,)) for angle in angles_of(arguments.turn)]
    else:
        variants = [(f"leaning {angle:g} degrees" + (f" to {heading:g}" if angle else ""), sheared, (angle, heading))
                    for angle in angles_of(arguments.shear)
                    for heading in (angles_of(arguments.towards) if angle else [0.0])]
    print("| scan | rooms | right | mean IoU | ARI |\n| --- | ---: | ---: | ---: | ---: |")
    by_variant = [[] for _ in variants]

    def row(name, values):
        count, right, iou, ari = zip(*values)
        cells = [(right, ".1f"), (iou, ".3f"), (ari, ".3f")]
        texts = [f"{sum(v) / len(v):{style}} ({max(v) - min(v):{style}})" for v, style in cells]
        print(f"| {name} | {count[0]} | " + " | ".join(texts) + " |", flush=True)

    for scan in arguments.scans:
        copy = os.path.join(folder, "moved.pcd")
        for (_, change, angles), results in zip(variants, by_variant):
            change(scan, *angles, copy)
            results.append(evaluate(arguments.tools, copy, arguments.truth_field, options, folder, unscored(scan)))
        row(name_of(scan), [totals(results[-1:]) for results in by_variant])
    row("all", [totals(results) for results in by_variant])
    for (name, _, _), results in zip(variants, by_variant):
        rooms, right, iou, ari = totals(results)
        print(f"| all, {name} | {rooms} | {right} ({right / rooms:.1%}) | {iou:.3f} | {ari:.3f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tools")
    parser.add_argument("scans", nargs="+")
    parser.add_argument("-truth_field", default="label")
    parser.add_argument("-options", default="", help="further options of pcl_room_segmentation")
    parser.add_argument("-turn", help="angles, degrees, with commas between them")
    parser.add_argument("-shear", help="angles, degrees, with commas between them")
    parser.add_argument("-towards", default="0,45,90", help="headings of -shear, degrees (default: %(default)s)")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        (print_variants if arguments.turn or arguments.shear else print_table)(arguments, shlex.split(arguments.options), folder)


if __name__ == "__main__":
    main()
