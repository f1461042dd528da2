#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Objects and their names in labelled scans of real rooms, beside upstream LCCP and the thesis's method.

    real_accuracy.py BUILD_FOLDER SCANS_FOLDER [-methods ours,one,thesis,upstream] [-each] [-options "..."] [-work FOLDER]

Each scan.pcd of SCANS_FOLDER is a room with the fields label (object, 0 = building or not labelled) and class_id (NYU40
number). A simulated scan has object and category instead, and its names in scan.json. Nothing is told about rooms.

PQ, WO     panoptic quality and weighted overlap over the points of objects, means over scans. A segment of fewer than
           50 such points is no false one
AP         without classes, over all scans, as ScanNet judges: segments ranked by size, those mostly on points of no
           object left out, points of no object in the union; objects and segments of 50 points or more, as the scans
           are thinned; IoU of 0.50, 0.55 ... 0.95, and at 0.50 and 0.25
found      objects of at least 100 points with an IoU above 0.5
whole      those of which a segment covers 80 %, and that are 70 % of it
floor, walls, objects  points that are flagged as structure, of those that are floor, walls, objects; means over scans
class      objects of at least 100 points, of a kind that the model has, whose best segment has the right class
names      for the segments of ours of at least 100 points with a name: how many are right, by confidence; on the
           building no name is right, and of objects of no certain kind none is judged
Needs numpy.
"""
import argparse
import glob
import json
import os
import shlex
import subprocess
import tempfile

import numpy

from point_files import name_of, read_fields

WALL, FLOOR, CEILING = 1, 2, 22  # NYU40
KINDS = {3: "cabinet", 4: "bed", 5: "chair armchair stool", 6: "sofa armchair", 7: "table desk", 8: "door", 9: "window",
         10: "bookcase", 11: "picture", 12: "cabinet table", 14: "desk table", 15: "bookcase", 16: "curtain", 17: "cabinet",
         24: "cabinet", 25: "screen", 28: "curtain", 32: "cabinet table", 33: "toilet", 34: "sink", 35: "lamp", 36: "bath"}
ANY_KIND = (0, 38, 39, 40)  # none, other structure, furniture and props
BUILDING = {"wall": WALL, "floor": FLOOR, "ceiling": CEILING}
NAMELESS = ("none", "other")
BINS = (0, 0.3, 0.5, 0.7, 0.9)
THRESHOLDS = numpy.arange(0.5, 0.96, 0.05)


class Scan:
    """Object of each point, kind of each point, and the classes that are right for each kind."""

    def __init__(self, path):
        self.path, self.name = path, name_of(path)
        try:
            self.object, self.kind = (column.astype(int) for column in read_fields(path, ["label", "class_id"]))
            self.classes = {number: names.split() for number, names in KINDS.items()}
            self.any_kind = ANY_KIND
            self.object[numpy.isin(self.kind, [WALL, FLOOR, CEILING])] = 0
        except (KeyError, ValueError):  # no such field
            self.object, category = (column.astype(int) for column in read_fields(path, ["object", "category"]))
            with open(os.path.splitext(path)[0] + ".json", encoding="utf-8") as file:
                names = json.load(file)["categories"]
            self.kind = numpy.array([BUILDING.get(name, 100 + k) for k, name in enumerate(names)])[category]
            self.classes = {100 + k: [name] for k, name in enumerate(names)}
            self.any_kind = ()
        self.field = "label" if self.any_kind else "object"

    def kind_of(self, points):
        return int(numpy.bincount(self.kind[points]).argmax())


def overlaps(true, found):
    """Counts of pairs, sizes of rows and columns, by label."""
    rows, of_row = numpy.unique(true, return_inverse=True)
    columns, of_column = numpy.unique(found, return_inverse=True)
    counts = numpy.zeros((len(rows), len(columns)), int)
    numpy.add.at(counts, (of_row, of_column), 1)
    return rows, columns, counts


def iou(counts):
    return counts / (counts.sum(axis=1, keepdims=True) + counts.sum(axis=0, keepdims=True) - counts)


def quality(truth, segment):
    """Panoptic quality and weighted overlap."""
    _, _, counts = overlaps(truth[truth > 0], segment[truth > 0])
    share = iou(counts)
    right = share > 0.5
    size = counts.sum(axis=0)
    wrong = numpy.sum((size >= 50) & ~right.any(axis=0))
    missed = len(counts) - right.sum()
    overlap = (counts.sum(axis=1) * share.max(axis=1)).sum() / counts.sum()
    return share[right].sum() / (right.sum() + 0.5 * wrong + 0.5 * missed), overlap


def objects_found(truth, segment):
    """Objects of 100 points or more that are found, that are whole, and all."""
    objects, segments, counts = overlaps(truth, segment)
    on_objects = counts[objects > 0].sum(axis=0)
    counts, sizes = counts[objects > 0][:, segments > 0], counts[objects > 0].sum(axis=1)
    on_objects = on_objects[segments > 0]
    counts, sizes = counts[sizes >= 100], sizes[sizes >= 100]
    best = counts.argmax(axis=1)
    both, own = counts.max(axis=1), on_objects[best]
    return numpy.array([numpy.sum(both > 0.5 * (sizes + own - both)),
                        numpy.sum((both >= 0.8 * sizes) & (both >= 0.7 * own)), len(sizes)])


def ranked(truth, segment):
    """Number of objects, and for each segment its size and its IoU with each object."""
    objects, segments, counts = overlaps(truth, segment)
    share = iou(counts)
    judged = (objects > 0) & (counts.sum(axis=1) >= 50)
    size = counts.sum(axis=0)
    void = counts[objects == 0].sum(axis=0)
    kept = (segments > 0) & (size >= 50) & (2 * void <= size)
    return judged.sum(), size[kept], share[judged][:, kept].T


def average_precision(scans, threshold):
    """Area below the largest precision at each recall or above; each object is found once, by the largest segment."""
    rows = []
    for _, sizes, shares in scans:
        taken = set()
        for k in numpy.argsort(-sizes, kind="stable"):
            best = int(shares[k].argmax()) if shares.shape[1] else -1
            is_right = best >= 0 and shares[k, best] > threshold and best not in taken
            if is_right:
                taken.add(best)
            rows.append((sizes[k], is_right))
    rows.sort(key=lambda row: -row[0])
    right = numpy.cumsum([row[1] for row in rows])
    if not len(right):
        return 0.0
    precision = numpy.maximum.accumulate((right / numpy.arange(1, len(right) + 1))[::-1])[::-1]
    recall = right / sum(scan[0] for scan in scans)
    return float(numpy.sum(numpy.diff(numpy.concatenate([[0], recall])) * precision))


def shares_flagged(scan, structure):
    """Of floor, walls and objects; not a number where there is none."""
    flagged = (structure > 0) & (structure < 4)
    parts = [scan.kind == FLOOR, scan.kind == WALL, scan.object > 0]
    return [flagged[part].mean() if part.any() else numpy.nan for part in parts]


def classes_right(scan, segment, class_of):
    """Objects whose best segment has a right class, and all of a kind that the model has."""
    right = count = 0
    for number in numpy.unique(scan.object[scan.object > 0]):
        points = scan.object == number
        wanted = scan.classes.get(scan.kind_of(points))
        if wanted is None or points.sum() < 100:
            continue
        numbers, sizes = numpy.unique(segment[points], return_counts=True)
        right += class_of.get(int(numbers[sizes.argmax()]), ("none", 0))[0] in wanted
        count += 1
    return numpy.array([right, count])


def names_right(scan, segment, class_of):
    """For each bin of confidence: names, right ones, those on the building."""
    bins = numpy.zeros((len(BINS), 3), int)
    for number, (name, confidence) in class_of.items():
        points = segment == number
        if name in NAMELESS or points.sum() < 100:
            continue
        kind = scan.kind_of(points)
        if kind in scan.any_kind:
            continue
        on_building = kind in (WALL, FLOOR, CEILING)
        bins[numpy.searchsorted(BINS, confidence, side="right") - 1] += [1, name in scan.classes.get(kind, []), on_building]
    return bins


def run_pipeline(tools, options, scan, folder):
    """Segment of each point, flag of structure, and (class, confidence) of each segment that is no structure."""
    subprocess.run([os.path.join(tools, "pcl_indoor_pipeline"), scan.path, folder, "-quiet", "-report", "none"] + options,
                   check=True)
    segment, structure = read_fields(os.path.join(folder, "cloud.pcd"), ["object", "structure"])
    with open(os.path.join(folder, "scene.json"), encoding="utf-8") as file:
        objects = json.load(file)["objects"]
    classes = {one["object"]: (one["class"], one["confidence"]) for one in objects}
    return segment.astype(int), structure, classes


def run_one_room(tools, options, scan, folder):
    """The same where the whole scan is one room."""
    output = os.path.join(folder, "objects.pcd")
    subprocess.run([os.path.join(tools, "pcl_noise_resilient_lccp"), scan.path, output, "-quiet"] + options, check=True)
    segment, structure = read_fields(output, ["object", "structure"])
    return segment.astype(int), structure, {}


def upstream_labels(build, scans, folder):
    """Labels of upstream's LCCP for all scans: by name of the method."""
    bench = os.path.join(build, "test", "benchmark", "bench_object_accuracy")
    subprocess.run([bench] + [scan.path for scan in scans] + ["-room_field", "none", "-object_field", scans[0].field,
                   "-methods", "upstream", "-upstream_voxel", "0.05", "-labels", folder, "-quiet"],
                   check=True, stdout=subprocess.DEVNULL)
    for method in ("LCCP, example's defaults", "LCCP, tuned"):
        yield method, [read_fields(os.path.join(folder, f"{scan.name}.{method}.pcd"), ["label"])[0].astype(int)
                       for scan in scans]


class Row:
    """The figures of one method over scans."""

    def __init__(self, name):
        self.name = name
        self.quality, self.counts, self.flagged, self.ranked, self.classes, self.bins = [], [], [], [], [], []

    def add(self, scan, segment, structure=None, class_of=None):
        self.quality.append(quality(scan.object, segment))
        self.counts.append(objects_found(scan.object, segment))
        self.flagged.append([numpy.nan] * 3 if structure is None else shares_flagged(scan, structure))
        of_objects = segment if structure is None else numpy.where(structure > 0, 0, segment)
        self.ranked.append(ranked(scan.object, of_objects))
        self.classes.append(classes_right(scan, segment, class_of) if class_of else numpy.zeros(2, int))
        self.bins.append(names_right(scan, segment, class_of) if class_of else numpy.zeros((len(BINS), 3), int))

    def line(self, name, which):
        """A row of the table over some of the scans."""
        pick = [list(column[k] for k in which) for column in (self.quality, self.counts, self.flagged, self.ranked, self.classes)]
        (pq, overlap), (found, whole, all_objects) = numpy.mean(pick[0], axis=0), numpy.sum(pick[1], axis=0)
        shares = numpy.array(pick[2], float)
        means = [column[~numpy.isnan(column)] for column in shares.T]
        flags = [f"{100 * column.mean():.1f}" if len(column) else "-" for column in means]
        right, named = numpy.sum(pick[4], axis=0)
        precision = [average_precision(pick[3], threshold) for threshold in THRESHOLDS]
        quarter = average_precision(pick[3], 0.25)
        return (f"| {name} | {pq:.3f} | {overlap:.3f} | {numpy.mean(precision):.3f} | {precision[0]:.3f} | {quarter:.3f} | "
                f"{found} | {whole} of {all_objects} | {' | '.join(flags)} | {f'{right} of {named}' if named else '-'} |")


def print_table(rows, scans, each):
    print("| method | PQ | WO | AP | AP50 | AP25 | found | whole | floor % | walls % | objects % | class |")
    print("| --- |" + 11 * " ---: |")
    for row in rows:
        if each:
            for k, scan in enumerate(scans):
                print(row.line(f"{row.name}, {scan.name}", [k]))
        print(row.line(row.name, range(len(scans))), flush=True)


def print_names(row):
    print("\n| confidence | names | right | on the building |\n| --- | ---: | ---: | ---: |")
    for low, high, (names, right, on_building) in zip(BINS, BINS[1:] + (1,), numpy.sum(row.bins, axis=0)):
        print(f"| {low} to {high} | {names} | {right} | {on_building} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("scans")
    parser.add_argument("-methods", default="ours,one,thesis,upstream")
    parser.add_argument("-options", default="", help="further ones of pcl_indoor_pipeline")
    parser.add_argument("-one_options", default="", help="further ones of pcl_noise_resilient_lccp")
    parser.add_argument("-each", action="store_true", help="a row for each scan, too")
    parser.add_argument("-work", help="folder to keep what the tools write")
    arguments = parser.parse_args()
    methods = arguments.methods.split(",")
    tools = os.path.join(arguments.build, "tools")
    scans = [Scan(path) for path in sorted(glob.glob(os.path.join(arguments.scans, "*.pcd")))]
    if not scans:
        parser.error(f"{arguments.scans}: no scan.pcd")
    runs = {"ours": ("ours", run_pipeline, shlex.split(arguments.options)),
            "one": ("ours, the scan as one room", run_one_room, shlex.split(arguments.one_options)),
            "thesis": ("the thesis's method", run_pipeline, ["-preset", "thesis"])}
    rows = []
    with tempfile.TemporaryDirectory() as scratch:
        work = arguments.work or scratch
        if "upstream" in methods:
            folder = os.path.join(work, "upstream")
            os.makedirs(folder, exist_ok=True)
            for method, labels in upstream_labels(arguments.build, scans, folder):
                rows.append(Row(method))
                for scan, segment in zip(scans, labels):
                    rows[-1].add(scan, segment)
        for method in ("thesis", "one", "ours"):
            if method in methods:
                name, run, options = runs[method]
                rows.append(Row(name))
                for scan in scans:
                    folder = os.path.join(work, method, scan.name)
                    os.makedirs(folder, exist_ok=True)
                    rows[-1].add(scan, *run(tools, options, scan, folder))
    print_table(rows, scans, arguments.each)
    if "ours" in methods:
        print_names(rows[-1])


if __name__ == "__main__":
    main()
