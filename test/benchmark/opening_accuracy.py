#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Compare the doors and windows in scene.json with those of building models.

    opening_accuracy.py BUILD_FOLDER BUILDINGS_FOLDER [-only NAME ...] [-results FOLDER] [-list]

BUILD_FOLDER holds tools/pcl_indoor_pipeline; BUILDINGS_FOLDER has for each scan.pcd, with fields label (room)
and object_id, a scan.json with

    objects object, kind (door, window), size (m), room; points with this object_id are its surface
    doors   object, open: these were taken out of the building before the scan
    yaw     how far the building was turned, degrees

An opening is right if its kind is, its centre lies within 0.2 m of the true one along the wall, and its width
within 0.15 m of the true one; one true opening each. Its middle height lies within 0.6 m, and it stands within
0.5 m of the true one across the wall. A width is that of the name (0762 x 2032mm), or else of the box, less the
casings, which stand out of the wall's face (of doors that were taken out: as others of the building). Of doors
that were taken out no place is known: each is right with one door that no other door has, that can be passed,
leads from one true room to another, and is as wide within 0.15 m and as high within 0.2 m. A true opening shows
if at least half of its own points are 3 cm or more from the wall's face, or the face is not there; those that do
not show are neither right nor wrong in the columns "shows". Without "kind" in scene.json, its
openings are doors, and objects of class door or window what they are called. Needs numpy.
"""
import argparse
import collections
import glob
import json
import os
import re
import subprocess
import tempfile

import numpy

from point_files import name_of, read_fields

ALONG, WIDTH, ACROSS, UP = 0.2, 0.15, 0.5, 0.6
HIGH = 0.2  # of doors that were taken out
Opening = collections.namedtuple("Opening", "kind middle along width sill head rooms is_open", defaults=[True])


def turned(yaw):
    angle = numpy.radians(yaw)
    return numpy.array([[numpy.cos(angle), -numpy.sin(angle)], [numpy.sin(angle), numpy.cos(angle)]])


def true_size(each, axis):
    """Width and height: what its name says, 0762 x 2032mm, or the sides of its box."""
    named = re.search(r"(\d{3,4}) ?(?:mm)? ?x ?(\d{4}) ?mm", str(each.get("name")))
    return (0.001 * int(named[1]), 0.001 * int(named[2])) if named else (each["size"][axis], each["size"][2])


def face_level(around):
    """Where the wall's face lies across it: where most points do; None without a wall."""
    face = around[abs(around[:, 1]) < 0.6]
    if len(face) < 20:
        return None
    ordered = numpy.sort(face[:, 1])
    crowd = numpy.searchsorted(ordered, ordered + 0.04, side="right") - numpy.arange(len(ordered))
    return ordered[crowd.argmax()] + 0.02


def shows(own, level):
    """Whether the wall's face is not where an opening is. Points: along, across, up."""
    return level is None or (abs(own[:, 1] - level) < 0.03).mean() < 0.5


def casings(own, level, half):
    """How much of a width covers the wall beside the opening: from each end, what stands out of the wall's face."""
    if level is None:
        return 0.0
    inward = 1.0 if level < numpy.median(own[:, 1]) else -1.0  # from the face into the wall
    total = 0.0
    for end in (-1.0, 1.0):
        from_end = half - end * own[:, 0]
        for step in numpy.arange(0.0, 0.12, 0.02):
            depths = inward * (own[(from_end >= step) & (from_end < step + 0.02), 1] - level)
            if len(depths) < 5 or numpy.median(depths) > -0.01:
                break
            total += 0.02
    return total


def true_openings(scene, points, object_of, label):
    """Known places, whether they show, and the sizes of doors that were taken out."""
    turn = turned(scene.get("yaw", 0))
    straight = points.copy()
    straight[:, :2] = points[:, :2] @ turn  # by -yaw
    known, visible, taken_out, of_doors = [], [], [], [0.0]
    is_open = {door["object"] for door in scene.get("doors", []) if door.get("open")}
    for each in scene["objects"]:
        if each.get("kind") not in ("door", "window"):
            continue
        axis = int(each["size"][1] > each["size"][0])
        own = straight[object_of == each["object"]]
        if each["object"] in is_open:
            taken_out.append((each, *true_size(each, axis)))
        if each["object"] in is_open or len(own) < 50 or each["size"][2] < 0.3:
            continue
        order = [axis, 1 - axis, 2]
        lower, upper = numpy.quantile(own, [0.01, 0.99], axis=0)
        middle = 0.5 * (lower + upper)
        near = numpy.all((straight > lower - [0.4, 0.4, 0.3]) & (straight < upper + [0.4, 0.4, 0.3]), axis=1)
        near &= (object_of != each["object"]) & (label == each["room"])
        own = own[label[object_of == each["object"]] == each["room"]]
        inner = numpy.all((own > lower + 0.1) & (own < upper - 0.1) | (numpy.arange(3) == 1 - axis), axis=1)
        level = face_level((straight[near] - middle)[:, order])
        visible.append(shows((own - middle)[inner if inner.sum() > 20 else slice(None)][:, order], level))
        width = true_size(each, axis)[0]
        if width == each["size"][axis]:
            casing = casings((own - middle)[:, order], level, 0.5 * width)
            width -= casing
            if each["kind"] == "door":
                of_doors.append(casing)
        along = turn @ numpy.eye(2)[axis]
        middle[:2] = turn @ middle[:2]
        known.append(Opening(each["kind"], middle, along, width, lower[2], upper[2], ()))
    casing = numpy.median(of_doors)  # to both sides
    taken_out = [(width, height) if width not in each["size"] else (round(width - casing, 3), round(height - 0.5 * casing, 3))
                 for each, width, height in taken_out]
    return known, numpy.array(visible, bool), taken_out


def found_openings(scene):
    if all("kind" in each for each in scene["openings"]) and scene["openings"]:
        for each in scene["openings"]:
            sill = each["position"][2]
            yield Opening(each["kind"], numpy.array(each["position"]) + [0, 0, 0.5 * each["height"]], None, each["width"],
                          sill, sill + each["height"], [room for room in each["rooms"] if room], each["open"])
        return
    for each in scene["openings"]:
        sill = each["position"][2]
        yield Opening("door", numpy.array(each["position"]) + [0, 0, 1.0], None, each["width"], sill,
                      sill + each["area"] / max(0.1, each["width"]), each["rooms"])
    for each in scene["objects"]:
        if each.get("class") in ("door", "window"):
            box = each["upright_box"]
            middle, half = numpy.array(box["center"]), 0.5 * box["size"][2]
            yield Opening(each["class"], middle, None, box["size"][0], middle[2] - half, middle[2] + half, [each["room"]])


def pairs_of(true, found):
    """One to one, the nearest first."""
    candidates = []
    for t, one in enumerate(true):
        across = numpy.array([-one.along[1], one.along[0]])
        for f, other in enumerate(found):
            way = other.middle - one.middle
            along, beside = abs(one.along @ way[:2]), abs(across @ way[:2])
            if (one.kind == other.kind and along <= ALONG and beside <= ACROSS and abs(way[2]) <= UP
                    and abs(other.width - one.width) <= WIDTH):
                candidates.append((along + abs(one.width - other.width), t, f))
    pairs, used = [], set()
    for _, t, f in sorted(candidates):
        if ("t", t) not in used and ("f", f) not in used:
            used |= {("t", t), ("f", f)}
            pairs.append((t, f))
    return pairs


def at_place(one, other):
    """Whether something stands at an opening, whatever its kind or width."""
    way = other.middle - one.middle
    return (abs(one.along @ way[:2]) < 0.5 * one.width + 0.1 and abs(-one.along[1] * way[0] + one.along[0] * way[1]) < ACROSS
            and abs(way[2]) < 0.5 * (one.head - one.sill) + 0.3)


def leads_on(opening, points, label):
    """Whether points of two true rooms lie around an opening."""
    near = numpy.all(abs(points - opening.middle) < [0.8, 0.8, 1.0], axis=1)
    return len(set(label[near]) - {0}) > 1


def by_size(sizes, found, free, surroundings):
    """Doors that were taken out, whose places are not known: as many as have an opening of their size."""
    rest = sorted(sizes)
    for f in sorted(free, key=lambda each: (found[each].width, each)):
        one = found[f]
        fitting = [size for size in rest if abs(one.width - size[0]) <= WIDTH and abs(one.head - one.sill - size[1]) <= HIGH]
        if one.is_open and fitting and leads_on(one, *surroundings):
            rest.remove(fitting[0])
            yield f


def score(right, true, found):
    return {"right": right, "true": true, "found": found}


def f1(figures):
    return 2.0 * figures["right"] / max(1, figures["true"] + figures["found"])


def judged(scene, result, points, object_of, label, listed):
    known, visible, taken_out = true_openings(scene, points, object_of, label)
    found = list(found_openings(result))
    pairs = pairs_of(known, found)
    row = {"sill": [], "head": []}
    for t, f in pairs:
        if found[f].sill is not None:
            row["sill"].append(found[f].sill - known[t].sill)
            row["head"].append(found[f].head - known[t].head)
    right_of = {t: f for t, f in pairs}
    for kind in ("window", "door"):
        truth = [t for t, one in enumerate(known) if one.kind == kind]
        own = {f for f, one in enumerate(found) if one.kind == kind}
        right = [t for t in truth if t in right_of]
        hidden = {f for f in own for t in truth if not visible[t] and at_place(known[t], found[f])}
        hidden -= {right_of[t] for t in right if visible[t]}
        seen = [t for t in truth if visible[t]]
        seen_right = [t for t in seen if t in right_of]
        row[f"{kind} all"] = score(len(right), len(truth), len(own))
        row[f"{kind} shows"] = score(len(seen_right), len(seen), len(own - hidden))
        if kind == "door":
            free = own - {f for _, f in pairs}
            opened = len(set(by_size(taken_out, found, free, (points, label))))
            row["closed"] = score(len(seen_right), len(seen), len(own - hidden) - opened)
            for key in ("door all", "door shows"):
                row[key]["right"] += opened
                row[key]["true"] += len(taken_out)
    if listed:
        for t, one in enumerate(known):
            near = [f"{found[f].kind} {found[f].width:.2f} off {abs(one.along @ (found[f].middle - one.middle)[:2]):.2f}"
                    for f in range(len(found)) if at_place(one, found[f])]
            print(f"    {'right' if t in right_of else 'MISSED' if visible[t] else 'hidden'} {one.kind} {one.width:.2f} at "
                  f"{one.middle.round(2)}, {one.sill:.2f} to {one.head:.2f}: {'; '.join(near) or 'nothing'}")
        matched = set(right_of.values())
        for f, one in enumerate(found):
            if f not in matched and not any(at_place(true, one) for true in known):
                print(f"    alone: {one.kind} {one.width:.2f} at {one.middle.round(2)}, rooms {one.rooms}, {one.sill} to {one.head}")
        print(f"    taken out: {sorted(taken_out)}")
    return row


def added(rows):
    total = {"sill": [], "head": []}
    for row in rows:
        for key, value in row.items():
            if isinstance(value, list):
                total[key] += value
            else:
                into = total.setdefault(key, score(0, 0, 0))
                for name in value:
                    into[name] += value[name]
    return total


def line(name, row):
    cells = [name]
    for key in ("window shows", "window all", "door shows", "door all", "closed"):
        each = row[key]
        cells.append(f"{each['right']} of {each['true']}, {each['found']}: {f1(each):.2f}")
    for key in ("sill", "head"):
        values = 100.0 * numpy.abs(row[key])
        cells.append(f"{numpy.median(values):.1f}" if len(values) else "-")
    return "| " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("buildings")
    parser.add_argument("-only", nargs="*", default=[], help="names of buildings")
    parser.add_argument("-results", help="keep the folders of the pipeline here, and use those that are there")
    parser.add_argument("-list", action="store_true", help="a line for each opening, too")
    arguments = parser.parse_args()
    print("| building | windows that show | windows | doors that show | doors | of closed ones | sill, cm | head, cm |\n"
          "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |")
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for scan in sorted(glob.glob(os.path.join(arguments.buildings, "*.pcd"))):
            name = name_of(scan)
            if arguments.only and name not in arguments.only:
                continue
            output = os.path.join(arguments.results or folder, name)
            if not os.path.exists(os.path.join(output, "scene.json")):
                subprocess.run([os.path.join(arguments.build, "tools", "pcl_indoor_pipeline"), scan, output, "-quiet",
                                "-report", "none"], check=True, stdout=subprocess.DEVNULL)
            with open(os.path.join(output, "scene.json"), encoding="utf-8") as file:
                result = json.load(file)
            with open(os.path.splitext(scan)[0] + ".json", encoding="utf-8") as file:
                scene = json.load(file)
            x, y, z, label, object_of = read_fields(scan, ["x", "y", "z", "label", "object_id"])
            points = numpy.stack([x, y, z], axis=1).astype(float)
            rows.append(judged(scene, result, points, object_of, label, arguments.list))
            print(line(name, rows[-1]), flush=True)
    print(line("all", added(rows)))


if __name__ == "__main__":
    main()
