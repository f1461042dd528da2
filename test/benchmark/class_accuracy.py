#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Name the objects of labelled scans and compare with the truth.

    class_accuracy.py TOOLS_FOLDER -classes MAP.json [-model FILE] [-category_field F] [-object_field F] [-confusion]
                      scan.pcd ...

TOOLS_FOLDER holds pcl_indoor_pipeline, pcl_segment_collection and pcl_eppf_classify. Each scan
has the category and the object of each point in fields (default: category, object; 0 = none), and beside
scan.pcd lies scan.json with the names of the categories ("categories": [...] or "classes":
{number: name}). MAP.json names the categories of each class, class: [names]. What is in none of
its lists is structure where it is called floor, ceiling, wall or ghost, and otherwise not judged, as are those
of the class "none".

points     share of the points of all segments, structure being "other", whose class is right
segments   share of the pipeline's segments of at least 30 points whose class is right, of those where a class
           of the map holds more than half of the points
whole      share of the true objects of a class that are named right when they are cut out of the
           scan as a whole
Needs numpy.
"""
import argparse
import collections
import json
import os
import subprocess
import tempfile

import numpy

from point_files import read_fields

STRUCTURE = ("floor", "ceiling", "wall", "ghost")
NOT_JUDGED = "?"


def category_names(path):
    with open(path, encoding="utf-8") as file:
        content = json.load(file)
    if "categories" in content:
        return dict(enumerate(content["categories"]))
    return {int(number): name for number, name in content["classes"].items()}


def class_of_category(names, class_map):
    """The class of each number, as an array of texts."""
    class_of_name = {name: kind for kind, names_of in class_map.items() for name in names_of}
    class_of_name = {name: NOT_JUDGED if kind == "none" else kind for name, kind in class_of_name.items()}
    class_of_name.update({name: "other" for name in STRUCTURE})
    return numpy.array([class_of_name.get(names.get(k), NOT_JUDGED) for k in range(max(names) + 1)], object)


def judge_pipeline(arguments, scan, folder, truth_of_category, row, confusion):
    command = [os.path.join(arguments.tools, "pcl_indoor_pipeline"), scan, folder, "-quiet"]
    if arguments.model:
        command += ["-model", arguments.model]
    subprocess.run(command, check=True)
    with open(os.path.join(folder, "scene.json"), encoding="utf-8") as file:
        classes = numpy.array([one["class"] for one in json.load(file)["objects"]], object)
    truth = truth_of_category[read_fields(scan, [arguments.category_field])[0]]
    segment = read_fields(os.path.join(folder, "cloud.pcd"), ["object"])[0].astype(int)
    judged = (truth != NOT_JUDGED) & (segment > 0)
    row["points"] += numpy.array([numpy.sum(truth[judged] == classes[segment[judged] - 1]), numpy.sum(judged)])
    names, kinds = numpy.unique(truth, return_inverse=True)
    counts = numpy.zeros((len(classes) + 1, len(names)), int)
    numpy.add.at(counts, (segment, kinds), 1)
    for k, count in enumerate(counts[1:]):
        best = names[count.argmax()]
        if count.sum() >= 30 and 2 * count.max() > count.sum() and best not in ("other", NOT_JUDGED):
            row["segments"] += numpy.array([best == classes[k], 1])
            confusion["segments"][best, classes[k]] += 1


def judge_whole(arguments, scan, folder, row, confusion):
    tool = os.path.join(arguments.tools, "pcl_segment_collection")
    subprocess.run([tool, scan, folder, "-names", os.path.splitext(scan)[0] + ".json", "-classes", arguments.classes,
                    "-category_field", arguments.category_field, "-object_field", arguments.object_field,
                    "-quiet"], check=True)
    output = folder + ".json"
    subprocess.run([os.path.join(arguments.tools, "pcl_eppf_classify"), arguments.model, folder,
                    "-json", output, "-quiet"], check=True, stdout=subprocess.DEVNULL)
    with open(output, encoding="utf-8") as file:
        for one in json.load(file):
            truth = os.path.basename(os.path.dirname(one["file"]))
            if truth != "other":
                row["whole"] += numpy.array([truth == one["class"], 1])
                confusion["whole"][truth, one["class"]] += 1


def share(counts):
    return f"{counts[0] / counts[1]:.1%} of {counts[1]}" if counts[1] else "-"


def print_confusion(confusion):
    for kind, counts in confusion.items():
        print(f"\n{kind}: true class, what it was taken for")
        for truth in sorted({pair[0] for pair in counts}):
            taken = sorted(((n, name) for (own, name), n in counts.items() if own == truth), reverse=True)
            print(f"- {truth} {sum(n for n, _ in taken)}: " + ", ".join(f"{name} {n}" for n, name in taken))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tools")
    parser.add_argument("-classes", required=True)
    parser.add_argument("-model", default="")
    parser.add_argument("-category_field", default="category")
    parser.add_argument("-object_field", default="object")
    parser.add_argument("-confusion", action="store_true")
    parser.add_argument("scans", nargs="+")
    arguments = parser.parse_args()
    if not arguments.model:
        arguments.model = os.path.join(arguments.tools, "..", "share", "pcl_indoor", "indoor_objects.model")
    with open(arguments.classes, encoding="utf-8") as file:
        class_map = json.load(file)
    confusion = {"segments": collections.Counter(), "whole": collections.Counter()}
    total = collections.defaultdict(lambda: numpy.zeros(2, int))
    print("| scan | points | segments | whole |\n| --- | ---: | ---: | ---: |")
    for scan in arguments.scans:
        row = collections.defaultdict(lambda: numpy.zeros(2, int))
        stem = os.path.splitext(scan)[0]
        truth = class_of_category(category_names(stem + ".json"), class_map)
        with tempfile.TemporaryDirectory() as folder:
            judge_pipeline(arguments, scan, os.path.join(folder, "scene"), truth, row, confusion)
            judge_whole(arguments, scan, os.path.join(folder, "objects"), row, confusion)
        print(f"| {os.path.basename(stem)} | " +
              " | ".join(share(row[kind]) for kind in ("points", "segments", "whole")) + " |", flush=True)
        for kind, counts in row.items():
            total[kind] += counts
    print("| all | " + " | ".join(share(total[kind]) for kind in ("points", "segments", "whole")) + " |")
    if arguments.confusion:
        print_confusion(confusion)


if __name__ == "__main__":
    main()
