#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""How steadily maps of real lidars come out as rooms, when they are disturbed a little.

    disturbed_maps.py TOOLS_FOLDER MAPS_FOLDER [-turn DEGREES] [-seed N] [-each]

TOOLS_FOLDER holds pcl_room_segmentation. MAPS_FOLDER holds maps, NAME.pcd, and
regions.json: {NAME: {"regions": {REGION: [polygon, ...]}, "apart": [[REGION, REGION], ...]}},
x and y in metres. Each map is turned, mirrored, thinned, made noisy and cut in 23 ways;
-turn adds to all angles, -seed draws other points and noise. A region is whole if one
room holds at least 80 % of its points, and these are at least half of the points that the
room has in any region. Two regions are apart if their largest rooms differ and hold at
least half of them. Rooms beyond the regions are further ones. Needs numpy.
"""
import argparse
import json
import os
import subprocess
import tempfile
from functools import partial

import numpy

from point_files import inside, read_fields, write_points


def turned(places, degrees, side=1):
    cosine, sine = numpy.cos(numpy.radians(degrees)), numpy.sin(numpy.radians(degrees))
    x, y = side * places[:, 0], places[:, 1]
    return numpy.stack([cosine * x - sine * y, sine * x + cosine * y, places[:, 2]], 1)


def means_of_cells(places, random, size):
    """One point per cell of a grid that begins anywhere."""
    cells = numpy.floor((places + size * random.random(3)) / size).astype(numpy.int64)
    cell = numpy.unique(cells, axis=0, return_inverse=True)[1].ravel()
    count = numpy.bincount(cell)
    return numpy.stack([numpy.bincount(cell, places[:, k]) / count for k in range(3)], 1)


def between(places, random, low, high):
    """What lies between two shares of the height."""
    bottom, top = numpy.percentile(places[:, 2], [1, 99])
    share = (places[:, 2] - bottom) / (top - bottom)
    return places[(share >= low) & (share <= high)]


def disturbances():
    """By name: what is kept of the points, how noisy they are, metres, by how many degrees they are turned, and if they
    are mirrored (-1)."""
    def all_of(places, random):
        return places

    def thinned(places, random, share):
        return places[random.random(len(places)) < share]

    for degrees in range(0, 360, 40):
        yield f"turned {degrees}", all_of, 0, degrees, 1
    for degrees in (10, 100, 190):
        yield f"mirrored {degrees}", all_of, 0, degrees, -1
    for share, degrees in ((0.7, 15), (0.5, 50), (0.35, 95)):
        yield f"thinned to {share}", partial(thinned, share=share), 0, degrees, 1
    for size, degrees in ((0.08, 25), (0.12, 65), (0.16, 110)):
        yield f"cells of {size} m", partial(means_of_cells, size=size), 0, degrees, 1
    for noise, degrees in ((0.01, 35), (0.02, 85), (0.03, 5)):
        yield f"noise of {noise} m", all_of, noise, degrees, 1
    yield "without the top 15 %", partial(between, low=0, high=0.85), 0, 30, 1
    yield "without the lowest 10 %", partial(between, low=0.1, high=1), 0, 60, 1


def judged(region, room, names, apart):
    """Whole regions, pairs apart, further rooms."""
    whole, largest, share = 0, {}, {}
    for number, name in enumerate(names, 1):
        rooms, counts = numpy.unique(room[(region == number) & (room > 0)], return_counts=True)
        largest[name], share[name] = 0, 0.0
        if len(rooms):
            best = counts.argmax()
            largest[name], share[name] = rooms[best], counts[best] / numpy.count_nonzero(region == number)
            own = counts[best] / numpy.count_nonzero((room == rooms[best]) & (region > 0))
            whole += bool(share[name] >= 0.8 and own >= 0.5)
    parted = sum(bool(largest[a] != largest[b] and min(share[a], share[b]) >= 0.5) for a, b in apart)
    return numpy.array([whole, parted, max(0, len(numpy.unique(room[room > 0])) - len(names))])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tools")
    parser.add_argument("maps")
    parser.add_argument("-turn", type=float, default=0, help="degrees (default: 0)")
    parser.add_argument("-seed", type=int, default=7, help="of the random numbers (default: 7)")
    parser.add_argument("-each", action="store_true", help="a row for each disturbed map")
    arguments = parser.parse_args()
    with open(os.path.join(arguments.maps, "regions.json"), encoding="utf-8") as file:
        regions = json.load(file)
    print("| map | whole | apart | further rooms | with more than two |\n| --- | ---: | ---: | ---: | ---: |", flush=True)
    total = numpy.zeros(6, int)
    for name, truth in regions.items():
        source = read_fields(os.path.join(arguments.maps, name + ".pcd"), "xyz")
        source = numpy.stack(source, 1).astype(float)
        apart = truth["apart"]
        row = numpy.zeros(6, int)
        for what, kept, noise, degrees, side in disturbances():
            random = numpy.random.default_rng(arguments.seed)
            places = kept(source, random)
            region = numpy.zeros(len(places), int)
            for number, polygons in enumerate(truth["regions"].values(), 1):
                for polygon in polygons:
                    region[inside(polygon, places[:, 0], places[:, 1])] = number
            places = turned(places + random.normal(0, noise, places.shape), degrees + arguments.turn, side)
            with tempfile.TemporaryDirectory() as folder:
                scan, rooms = os.path.join(folder, "scan.pcd"), os.path.join(folder, "rooms.pcd")
                write_points(scan, dict(zip("xyz", places.T), region=region))
                subprocess.run([f"{arguments.tools}/pcl_room_segmentation", scan, rooms, "-quiet"], check=True,
                               stderr=subprocess.DEVNULL)
                fields = read_fields(rooms)
            result = judged(fields["region"].astype(int), fields["room"].astype(int), list(truth["regions"]), apart)
            if arguments.each:
                print(f"| {name}, {what} | {result[0]} of {len(truth['regions'])} | {result[1]} of {len(apart)} | "
                      f"{result[2]} | |", flush=True)
            row += [result[0], len(truth["regions"]), result[1], len(apart), result[2], result[2] > 2]
        total += row
        print("| {} | {} of {} | {} of {} | {} | {} |".format(name, *row), flush=True)
    print("| all | {} of {} | {} of {} | {} | {} |".format(*total))


main()
