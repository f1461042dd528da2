#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Train and test classifiers on labelled objects, as chapter 5.3.3 of the thesis does.

    class_experiments.py TOOLS_FOLDER DATA [-experiment classes|noise|occlusion] [-seeds 1 2 3]
                         [-levels 0 6 ...] [-only METHOD ...] [-results FILE] [-picture FILE]

DATA holds DATA/CLASS/OBJECT. TOOLS_FOLDER holds pcl_eppf_train and pcl_eppf_classify; all run on one thread.
classes    each method (Table 5.3): mean and deviation of its scores over the seeds; 80 % of each class
           are trained with, the other objects are tested with
noise      accuracy under noise of 0, 2 ... 10 % of the extent (Fig. 5.16), which objects to train and
           to test with have both
occlusion  accuracy where 0, 25 and 50 % of the points are hidden from one side, in training and test
Prints a Markdown table. With -results what has been measured is kept, and not measured again. A method that was
measured with fewer seeds than are asked for is shown with those. Needs numpy, for -picture matplotlib.
"""
import argparse
import json
import os
import re
import subprocess
import tempfile
import time

import numpy

CONVOLUTIONS = "-augment mild -epochs 20 -batch_size 32"  # equal for all of Table 5.1
POINTNET = "-network pointnet -augment mild -points 256 -width 0.25 -epochs 100 -batch_size 32"
METHODS = {
    "recommended": "",
    "recommended, any pose": "-any_pose",
    "perceptron, thesis's bins": "-descriptor eppf -any_pose",
    "4D network, thesis's bins": "-network 4d " + CONVOLUTIONS,
    "3D network, thesis's bins": "-network 3d " + CONVOLUTIONS,
    "2D network, thesis's bins": "-network 2d " + CONVOLUTIONS,
    "PointNet, a quarter as wide": POINTNET,
    "nearest, pair harmonics": "nearest -descriptor pair_harmonics",
    "Point-NN, no training": "nearest -descriptor point_nn",
}
DISTURBED = {
    "perceptron": "-augment mild -draws 12",
    "perceptron, any pose": "-augment mild -draws 12 -any_pose",
    "4D network, thesis's bins": "-network 4d -augment mild -draws 4 -epochs 15 -batch_size 32",
    "PointNet, a quarter as wide": POINTNET,
}
LEVELS = {"noise": (0, 2, 4, 6, 8, 10), "occlusion": (0, 25, 50)}
SCORES = ("total accuracy", "mean accuracy", "mean recall", "F1")


def split_at_random(data, seed):
    """The objects that -split random:0.8 trains with and tests with."""
    random = numpy.random.RandomState(seed)  # MT19937, seeded as the C++ library's
    known, tested = [], []
    for name in sorted(os.listdir(data)):
        own = sorted(os.path.join(name, file) for file in os.listdir(os.path.join(data, name)))
        taken = min(max(int(0.8 * len(own) + 0.5), 1), len(own) - 1)
        for k in range(taken):
            other = k + int(random.randint(0, 2**32, dtype=numpy.uint32)) % (len(own) - k)
            own[k], own[other] = own[other], own[k]
        known += own[:taken]
        tested += own[taken:]
    return known, tested


def scores_of(pairs):
    """Scores of (truth, predicted) as pcl_eppf_train has them: means over the classes that have objects."""
    precisions, recalls, harmonics = [], [], []
    for name in sorted({truth for truth, _ in pairs}):
        right = sum(pair == (name, name) for pair in pairs)
        predicted = sum(found == name for _, found in pairs)
        precisions.append(right / predicted if predicted else 0)
        recalls.append(right / sum(truth == name for truth, _ in pairs))
        total = precisions[-1] + recalls[-1]
        harmonics.append(2 * precisions[-1] * recalls[-1] / total if total else 0)
    accuracy = sum(truth == found for truth, found in pairs) / len(pairs)
    return [100 * accuracy] + [100 * numpy.mean(values) for values in (precisions, recalls, harmonics)]


def nearest(tools, data, options, seed, folder):
    for part, files in zip(("known", "tested"), split_at_random(data, seed)):
        for file in files:
            link = os.path.join(folder, part, file)
            os.makedirs(os.path.dirname(link), exist_ok=True)
            os.symlink(os.path.abspath(os.path.join(data, file)), link)
    output = os.path.join(folder, "classes.json")
    subprocess.run([os.path.join(tools, "pcl_eppf_classify"), "-nearest", os.path.join(folder, "known"),
                    os.path.join(folder, "tested"), "-json", output, "-quiet", "-threads", "1"] + options,
                   check=True, stdout=subprocess.DEVNULL)
    with open(output, encoding="utf-8") as file:
        return scores_of([(one["true_class"], one["class"]) for one in json.load(file)])


def trained(tools, data, options, seed, folder):
    said = subprocess.run([os.path.join(tools, "pcl_eppf_train"), data, os.path.join(folder, "model"),
                           "-split", "random:0.8", "-seed", str(seed), "-quiet", "-threads", "1"] + options,
                          check=True, stdout=subprocess.PIPE, universal_newlines=True).stdout
    found = re.search(r"total accuracy ([\d.]+) %, mean accuracy ([\d.]+) %, mean recall ([\d.]+) %, F1 ([\d.]+)", said)
    values = [float(text) for text in found.groups()]
    return values[:3] + [100 * values[3]]


class Measurements:
    """What was measured, kept in a file."""

    def __init__(self, arguments):
        self.arguments = arguments
        self.known = {}
        if arguments.results and os.path.exists(arguments.results):
            with open(arguments.results, encoding="utf-8") as file:
                self.known = json.load(file)

    def of(self, options, measures):
        """Scores, and seconds each, of all seeds; None without any."""
        found = []
        for seed in self.arguments.seeds:
            key = f"{options} -seed {seed}".strip()
            if key not in self.known and measures:
                self.known[key] = self.measured(options.split(), seed)
                self.save()
            if key in self.known:
                found.append(self.known[key])
        return numpy.array(found) if found else None

    def measured(self, options, seed):
        begin = time.time()
        with tempfile.TemporaryDirectory() as folder:
            run, rest = (nearest, options[1:]) if options[:1] == ["nearest"] else (trained, options)
            scores = run(self.arguments.tools, self.arguments.data, rest, seed, folder)
        return list(scores) + [time.time() - begin]

    def save(self):
        if self.arguments.results:
            with open(self.arguments.results, "w", encoding="utf-8") as file:
                json.dump(self.known, file, indent=1)


def cell(values):
    if len(values) == 1:
        return f"{values[0]:.1f}"
    return f"{numpy.mean(values):.1f} +- {numpy.std(values, ddof=1):.1f}"


def print_classes(measurements, is_wanted):
    print("| method | " + " | ".join(f"{name} %" for name in SCORES) + " | seeds | seconds each |")
    print("| --- |" + " ---: |" * 6)
    for name, options in METHODS.items():
        rows = measurements.of(options, is_wanted(name))
        if rows is not None:
            print(f"| {name} | " + " | ".join(cell(rows[:, k]) for k in range(4)) +
                  f" | {len(rows)} | {numpy.mean(rows[:, 4]):.0f} |", flush=True)


def print_disturbed(measurements, is_wanted, arguments):
    kind = arguments.experiment
    levels = arguments.levels or LEVELS[kind]
    print(f"| accuracy % under {kind} of | " + " | ".join(f"{level} %" for level in levels) +
          " | seeds | seconds each |")
    print("| --- |" + " ---: |" * (len(levels) + 2))
    curves = {}
    for name, options in DISTURBED.items():
        cells, seconds, curve = [], [], {}
        for level in levels:
            disturbance = f" -{kind} {level}" if level else ""
            rows = measurements.of(options + disturbance, is_wanted(name))
            cells.append("-" if rows is None else cell(rows[:, 0]))
            if rows is not None:
                seconds += list(rows[:, 4])
                curve[level] = (len(rows), rows[:, 0].mean())
        if curve:
            counts = sorted({count for count, _ in curve.values()})
            print(f"| {name} | " + " | ".join(cells) + f" | {'-'.join(map(str, counts))} | {numpy.mean(seconds):.0f} |",
                  flush=True)
            curves[name] = curve
    if arguments.picture:
        draw(curves, kind, arguments.picture)


def draw(curves, kind, picture):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(figsize=(6, 4))
    for marker, (name, curve) in zip("os^vD", curves.items()):
        axes.plot(list(curve), [mean for _, mean in curve.values()], marker=marker, label=name)
    axes.set(xlabel=kind + ", %", ylabel="accuracy, %", ylim=(0, 100))
    axes.grid(True)
    axes.legend(loc="lower left")
    figure.tight_layout()
    figure.savefig(picture, dpi=100)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tools")
    parser.add_argument("data")
    parser.add_argument("-experiment", choices=["classes"] + list(LEVELS), default="classes")
    parser.add_argument("-levels", type=int, nargs="+", help="of noise or occlusion, per cent")
    parser.add_argument("-seeds", type=int, nargs="+", default=[1, 2, 3])
    parser.add_argument("-only", nargs="*", help="methods to measure; others are shown if they are in the results")
    parser.add_argument("-results", help="JSON file that keeps what was measured")
    parser.add_argument("-picture", help="draw the curves of noise or occlusion as PNG")
    arguments = parser.parse_args()
    os.environ["OMP_NUM_THREADS"] = "1"
    measurements = Measurements(arguments)

    def is_wanted(name):
        return arguments.only is None or name in arguments.only

    if arguments.experiment == "classes":
        print_classes(measurements, is_wanted)
    else:
        print_disturbed(measurements, is_wanted, arguments)


if __name__ == "__main__":
    main()
