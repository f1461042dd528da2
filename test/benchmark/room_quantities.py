#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Segment labelled scans into rooms and compare areas, heights and door widths with the truth.

    room_quantities.py TOOLS_FOLDER [-truth_field F] [-options "..."] [-rooms] scan.pcd ...

TOOLS_FOLDER holds pcl_room_segmentation; the scans have the room of each point in a field
(default: label, 0 = not to be judged), and beside each scan.pcd lies scan.json with

    rooms   id, z0 and z1 (floor and ceiling, m), and area or volume or polygon;
            rooms with "room": false or "outdoor": true are left out
    doors   width with the position of its middle; or object and open, then the width is the longer
            side of the object with this number ("objects": object, size). Closed doors are left out

Rooms are matched one to one where the intersection over union of their points is at least
0.5. In columns of 0.1 m that hold points of a room, the lowest and the highest ones are looked
at. Where at least three quarters of the columns end at one height the ceiling is level, and the area, if not given, is the
volume over z1 - z0; of other rooms, such as attics, only volumes are compared. Truth
that the scan contradicts is left out: areas and volumes more than a third from those of the
columns, heights where floor or ceiling are more than 3 cm from z0 or z1. Needs numpy.
"""
import argparse
import json
import os
import re
import shlex
import subprocess
import tempfile

import numpy

from point_files import name_of, read_fields


def ring_area(ring):
    x, y = numpy.array(ring)[:, :2].T
    return 0.5 * abs(numpy.dot(x, numpy.roll(y, -1)) - numpy.dot(y, numpy.roll(x, -1)))


def matched_rooms(truth, predicted, true_rooms):
    """Pairs of a true and a predicted number, IoU at least 0.5."""
    judged = truth > 0
    pairs, shared = numpy.unique(numpy.stack([truth[judged], predicted[judged]]), axis=1, return_counts=True)
    size_of = dict(zip(*numpy.unique(truth[judged], return_counts=True)))
    found_size = dict(zip(*numpy.unique(predicted[judged], return_counts=True)))
    return {int(a): int(b) for (a, b), both in zip(pairs.T, shared)
            if a in true_rooms and b > 0 and both >= 0.5 * (size_of[a] + found_size[b] - both)}


def main_level(heights):
    """Where most values are: the middle of the fullest 4 cm."""
    ordered = numpy.sort(heights)
    counts = numpy.searchsorted(ordered, ordered + 0.04, side="right") - numpy.arange(len(ordered))
    return ordered[counts.argmax()] + 0.02


def true_quantities(room, points):
    """Area, height and volume as far as they are known."""
    column = numpy.floor(points[:, :2] / 0.1).astype(numpy.int64)
    _, of_column = numpy.unique(column, axis=0, return_inverse=True)
    bottom, top = numpy.full((2, of_column.max() + 1), numpy.inf)
    numpy.minimum.at(bottom, of_column, points[:, 2])
    numpy.minimum.at(top, of_column, -points[:, 2])
    floor, ceiling, height = main_level(bottom), main_level(-top), room["z1"] - room["z0"]
    covered = 0.01 * len(top)
    is_level = numpy.mean(abs(-top - ceiling) < 0.15) >= 0.75
    area = room.get("area") or ("polygon" in room and ring_area(room["polygon"]))
    area = area or (is_level and room["volume"] / height)
    volume = room.get("volume") or (is_level and area * height)
    as_seen = max(abs(floor - room["z0"]), abs(ceiling - room["z1"])) < 0.03
    return (area if is_level and abs(area / covered - 1) < 1 / 3 else None,
            height if is_level and as_seen else None,
            volume if as_seen and abs(volume / (covered * height) - 1) < 1 / 3 else None)


def openings_of(result):
    """Each opening once: its rooms, position and width."""
    return [((room["room"], other["room"]), other["position"], other["width"])
            for room in result["rooms"] for other in room["neighbours"] if room["room"] < other["room"]]


def object_width(door):
    """The longer side of its box, which may hold a casing, or what its name says: 0762 x 2032mm."""
    named = re.search(r"(\d{3,4}) ?x ?\d{4} ?mm", str(door.get("name")))
    return 0.001 * int(named[1]) if named else max(door["size"][:2])


def door_errors(scene, openings, matched):
    """Found and true width per door between two rooms that were found."""
    found = set(matched.values())
    openings = [each for each in openings if found.issuperset(each[0])]
    pairs = []
    for door in scene.get("doors", []):
        if "position" not in door or not openings:
            continue
        far = [numpy.linalg.norm(numpy.subtract(place[:2], door["position"][:2]))
               + (abs(place[2] - door["position"][2]) > 1) * 9 for _, place, _ in openings]
        nearest = int(numpy.argmin(far))
        if far[nearest] < 0.5:
            pairs.append((openings[nearest][2], door["width"], openings[nearest][1]))
    objects = {each["object"]: each for each in scene.get("objects", []) if "object" in each}
    widths = [object_width(objects[door["object"]])
              for door in scene.get("doors", []) if door.get("open") and "object" in door]
    for _, place, width in openings if widths else []:
        nearest = min(widths, key=lambda each: abs(each - width))
        if abs(nearest - width) < 0.4:
            pairs.append((width, nearest, place))
    return pairs


def measure(arguments, scan, folder, row):
    with open(os.path.splitext(scan)[0] + ".json", encoding="utf-8") as file:
        scene = json.load(file)
    segmented, report = os.path.join(folder, "segmented.pcd"), os.path.join(folder, "report.json")
    subprocess.run([os.path.join(arguments.tools, "pcl_room_segmentation"), scan, segmented, "-quiet", "-json", report,
                    *shlex.split(arguments.options)], check=True, stdout=subprocess.DEVNULL)
    with open(report, encoding="utf-8") as file:
        result = json.load(file)
    x, y, z, truth = read_fields(scan, ["x", "y", "z", arguments.truth_field])
    predicted, = read_fields(segmented, ["room"])
    points = numpy.stack([x, y, z], axis=1).astype(float)
    rooms = {room["id"]: room for room in scene["rooms"] if room.get("room", True) and not room.get("outdoor")}
    matched = matched_rooms(truth, predicted, rooms)
    found = {room["room"]: room for room in result["rooms"]}
    errors = {"rooms": len(matched), "area": [], "height": [], "volume": [], "door": []}
    for number, other in sorted(matched.items()):
        area, height, volume = true_quantities(rooms[number], points[truth == number])
        for key, true in (("area", area), ("volume", volume)):
            if true:
                errors[key].append(found[other][key] / true - 1)
        if height:
            errors["height"].append(found[other]["height"] - height)
        row(f"    room {number} {rooms[number].get('name', '')} = {other}", [
            f"{key} {found[other][key]:.2f} / {true:.2f}" for key, true in
            (("area", area), ("height", height), ("volume", volume)) if true])
    for width, true, place in door_errors(scene, openings_of(result), matched):
        errors["door"].append(width - true)
        row("    door", [f"{width:.3f} / {true:.3f} at {place}"])
    return errors


def summary(errors):
    cells = [str(errors["rooms"])]
    for key, unit, style in (("area", 100, ".1f"), ("volume", 100, ".1f"), ("height", 100, ".1f"), ("door", 100, ".1f")):
        values = unit * numpy.array(errors[key])
        cells.append(f"{len(values)}" + ("" if not len(values) else
                     f": {numpy.median(abs(values)):{style}}, {numpy.quantile(abs(values), 0.9):{style}}, "
                     f"{numpy.median(values):+{style}}"))
    return "| " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tools")
    parser.add_argument("scans", nargs="+")
    parser.add_argument("-truth_field", default="label")
    parser.add_argument("-options", default="", help="further options of pcl_room_segmentation")
    parser.add_argument("-rooms", action="store_true", help="a line for each room and door, too")
    arguments = parser.parse_args()
    print("Count: median and 90th percentile of the absolute error, signed median.\n\n"
          "| scan | rooms | area, % | volume, % | height, cm | door width, cm |\n| --- | ---: | ---: | ---: | ---: | ---: |")
    every = []
    with tempfile.TemporaryDirectory() as folder:
        for scan in arguments.scans:
            lines = []
            every.append(measure(arguments, scan, folder, lambda name, texts: lines.append(f"{name}: {', '.join(texts)}")))
            print(f"| {name_of(scan)} {summary(every[-1])}", flush=True)
            if arguments.rooms:
                print("\n".join(lines))
    total = {"rooms": sum(errors["rooms"] for errors in every)}
    for key in ("area", "volume", "height", "door"):
        total[key] = [error for errors in every for error in errors[key]]
    print(f"| all {summary(total)}")


if __name__ == "__main__":
    main()
