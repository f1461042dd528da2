#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Simulate scans of random buildings and pack their rooms, to train voxel_network.py with.

    collect_rooms.py TOOLS_FOLDER ROOMS.npz WORK_FOLDER [-scans N] [-first SEED] [-jobs N]

Three of five buildings are captured room by room by a depth camera in somebody's hand, the others scanned by a laser; half
are lived in. What the work folder holds already is not made again. A capture takes half a minute on one core.

ROOMS.npz: names of the classes, floor, wall and ceiling first, then those of classes.json; of each room its number of
points and of objects, and whether it was captured; of all points, room after room, place (mm from the room's middle),
class (-1: not to be learned) and object (0: the building). Needs numpy.
"""
import argparse
import concurrent.futures
import json
import os
import subprocess

import numpy

BUILDING = {"floor": 0, "wall": 1, "ceiling": 2, "column": 1, "beam": 1, "ghost": -1, "person": -1, "none": -1}
FEWEST, MOST = 2000, 90000  # points of a room
FARTHEST = 20  # m from its middle


def class_table():
    """Names of the classes, and the class of each category."""
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "classes.json"), encoding="utf-8") as file:
        class_of = {category: name for name, categories in json.load(file).items() if name != "none"
                    for category in categories}
    names = ["floor", "wall", "ceiling"] + sorted(set(class_of.values())) + ["other"]
    return names, lambda category: BUILDING.get(category, names.index(class_of.get(category, "other")))


def read_ply(path):
    with open(path, "rb") as file:
        content = file.read()
    start = content.index(b"end_header\n") + len(b"end_header\n")
    lines = [line.split() for line in content[:start].decode("latin1").split("\n")]
    at = next(k for k, line in enumerate(lines) if line[:2] == ["element", "vertex"])
    fields = []
    for line in lines[at + 1:]:
        if line[0] != "property":
            break
        fields.append((line[2], {"float": "<f4", "uint": "<u4"}[line[1]]))
    return numpy.frombuffer(content, numpy.dtype(fields), int(lines[at][2]), start)


def is_captured(seed):
    return seed % 5 < 3


def scan_command(tools, seed, name):
    kind, n = ("office", "home", "home")[seed % 3], seed // 3
    if is_captured(seed):
        suffix = (":lived_in", "", ":lived_in", ":cluttered")[seed % 4]
        choices = {"-points": ((50000, 80000, 30000, 50000), n), "-fusion_voxel": ((0.02, 0.03, 0.02, 0.04), n // 2),
                   "-noise": ((0.001, 0.0015, 0.001), n // 3), "-drift": ((0.015, 0.005, 0.03), n),
                   "-spacing": ((0.9, 0.7, 1.3), n // 5), "-scanner": (("depth_camera",), 0)}
    else:
        suffix = ("", ":lived_in", ":cluttered", ":lived_in")[seed % 4]
        choices = {"-rays_per_pose": ((40000, 80000, 120000), n), "-spacing": ((2, 1.5, 3.5), n // 2),
                   "-leaf": ((0.025, 0.03, 0.035, 0.05), n), "-noise": ((0.004, 0.012, 0.008), n // 3),
                   "-drift": ((0.01, 0.003, 0.02, 0.005), n // 2), "-glass_echo": ((0, 0.05), n // 3)}
    command = [os.path.join(tools, "pcl_scan_simulation"), f"random:{kind}:{seed}{suffix}", name + ".ply",
               "-json", name + ".json", "-seed", str(seed), "-threads", "1", "-quiet"]
    for option, (values, k) in choices.items():
        command += [option, str(values[k % len(values)])]
    return command


def rooms_of(cloud, of_category, seed):
    """Of each room points, classes and objects. Four of ten with what is around them."""
    places = numpy.stack([cloud["x"], cloud["y"], cloud["z"]], 1)
    random = numpy.random.default_rng(seed)
    for room in numpy.unique(cloud["room"][cloud["room"] > 0]):
        own = cloud["room"] == room
        if own.sum() < FEWEST:
            continue
        if random.random() < 0.4:
            least, most = places[own].min(0) - 0.5, places[own].max(0) + [0.5, 0.5, 0.1]
            own = ((places >= least) & (places <= most)).all(1)
        own = numpy.flatnonzero(own)
        if len(own) > MOST:
            own = random.choice(own, MOST, replace=False)
        local = places[own] - places[own].mean(0)
        if numpy.abs(local).max() <= FARTHEST:
            yield numpy.round(1000 * local).astype(numpy.int16), of_category[cloud["category"][own]], cloud["object"][own]


def collect(tools, work, seed):
    name = os.path.join(work, str(seed))
    if os.path.exists(name + ".npz"):
        return
    subprocess.run(scan_command(tools, seed, name), check=True, env=dict(os.environ, OMP_NUM_THREADS="1"))
    class_of = class_table()[1]
    with open(name + ".json", encoding="utf-8") as file:
        of_category = numpy.array([class_of(category) for category in json.load(file)["categories"]], numpy.int8)
    rooms = list(rooms_of(read_ply(name + ".ply"), of_category, seed))
    points, classes, objects = (numpy.concatenate(part) for part in zip(*rooms))
    numpy.savez(name + ".new.npz", points=points, classes=classes, objects=objects.astype(numpy.uint16),
                sizes=[len(room[0]) for room in rooms], counts=[len(numpy.unique(room[2])) - 1 for room in rooms],
                captured=[is_captured(seed)] * len(rooms))
    os.remove(name + ".ply")
    os.remove(name + ".json")
    os.replace(name + ".new.npz", name + ".npz")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tools")
    parser.add_argument("rooms")
    parser.add_argument("work")
    parser.add_argument("-scans", type=int, default=125)
    parser.add_argument("-first", type=int, default=70000, help="seed")
    parser.add_argument("-jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    os.makedirs(options.work, exist_ok=True)
    seeds = range(options.first, options.first + options.scans)
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        list(pool.map(lambda seed: collect(options.tools, options.work, seed), seeds))
    parts = [numpy.load(os.path.join(options.work, f"{seed}.npz")) for seed in seeds]
    columns = {name: numpy.concatenate([part[name] for part in parts]) for name in parts[0].files}
    numpy.savez(options.rooms, names=class_table()[0], **columns)
    print(f"{len(columns['sizes'])} rooms of {len(parts)} scans")


if __name__ == "__main__":
    main()
