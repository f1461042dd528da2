#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# robot_map_accuracy.py TRUTH.json MAP.pgm ...: maps of pcl_indoor_export against what pcl_scan_simulation -json
# says of the building; the first map is of the lowest storey, and so on. Free cells of the truth are the rooms and the
# doors in their walls. Of each map: the intersection of both over their union, and how many doors between two rooms of
# the truth lead from one to the other within 1.5 m. Needs numpy.
#
# robot_map_accuracy.py PLAN.png DEGREES MAP.pgm ...: against a floor plan of 5 cm per pixel, x to the right and y
# downwards, whose scan was turned by so many degrees. White is free; PLAN_gt_segmentation.png beside it is white but for
# lines across the doorways. Of each map the IoU, and how many pairs of rooms with a doorway between them are connected.
# Needs scipy and pillow, too.
import json
import re
import sys

import numpy as np

from point_files import inside


def read_map(path):
    """Free cells, row by row from below, their origin and size."""
    with open(path, "rb") as file:
        magic, size, _, cells = file.read().split(b"\n", 3)
    assert magic == b"P5"
    nx, ny = map(int, size.split())
    with open(re.sub(r"\.pgm$", ".yaml", path), encoding="utf-8") as file:
        yaml = dict(line.strip().split(": ", 1) for line in file)
    origin = [float(word) for word in yaml["origin"].strip("[]").split(",")]
    values = np.frombuffer(cells, np.uint8).reshape(ny, nx)[::-1]
    return values == 254, np.array(origin[:2]), float(yaml["resolution"])


def door_frame(door):
    """Its middle, the way along the wall and the way across, as the plan turns it."""
    angle = np.radians(door["rotation"])
    along = np.array([np.cos(angle), np.sin(angle)])
    return np.array(door["position"][:2]), along, np.array([-along[1], along[0]])


def room_at(rooms, place):
    for room in rooms:
        if inside(room["polygon"], np.array([place[0]]), np.array([place[1]]))[0]:
            return room["number"]
    return 0


def connected(free, begin, end):
    """Is there a way between two cells?"""
    if not (free[begin] and free[end]):
        return False
    seen, stack = {begin}, [begin]
    while stack:
        row, column = stack.pop()
        if (row, column) == end:
            return True
        for cell in ((row + 1, column), (row - 1, column), (row, column + 1), (row, column - 1)):
            if 0 <= cell[0] < free.shape[0] and 0 <= cell[1] < free.shape[1] and free[cell] and cell not in seen:
                seen.add(cell)
                stack.append(cell)
    return False


def measure(truth, storey, path):
    free, origin, size = read_map(path)
    rooms = [room for room in truth["rooms"] if room["storey"] == storey]
    floors = {room["floor"] for room in rooms}
    y, x = np.indices(free.shape)
    x, y = origin[0] + size * (x + 0.5), origin[1] + size * (y + 0.5)
    expected = np.zeros(free.shape, bool)
    for room in rooms:
        expected |= inside(room["polygon"], x, y)
    doors = joined = 0
    for door in truth["objects"]:
        if door["category"] != "door" or not any(abs(door["position"][2] - floor) < 0.5 for floor in floors):
            continue
        middle, along, across = door_frame(door)
        dx, dy = x - middle[0], y - middle[1]
        expected |= (abs(dx * along[0] + dy * along[1]) < 0.5 * door["size"][0]) & (
            abs(dx * across[0] + dy * across[1]) < 0.5 * door["size"][1] + 0.01)
        sides = [middle + 0.35 * across, middle - 0.35 * across]
        numbers = [room_at(rooms, side) for side in sides]
        if 0 in numbers or numbers[0] == numbers[1]:
            continue
        doors += 1
        cells = [tuple(((side - origin) / size).astype(int)[::-1]) for side in sides]
        reach = int(1.5 / size)
        low = [max(0, min(cell[i] for cell in cells) - reach) for i in (0, 1)]
        part = free[low[0]:max(cell[0] for cell in cells) + reach, low[1]:max(cell[1] for cell in cells) + reach]
        local = [(cell[0] - low[0], cell[1] - low[1]) for cell in cells]
        if connected(part, *local):
            joined += 1
        else:
            print(f"  door {door['number']} between rooms {numbers} at {door['position']} does not lead through")
    overlap = np.count_nonzero(free & expected) / max(1, np.count_nonzero(free | expected))
    print(f"{path}: IoU {overlap:.4f}, {joined} of {doors} doors between rooms lead through")


def rooms_of_plan(path):
    """The room of each pixel of a floor plan, and the number of each doorway."""
    from PIL import Image
    from scipy import ndimage

    free, closed = (np.array(Image.open(name).convert("L")) > 250
                    for name in (path, re.sub(r"\.png$", "_gt_segmentation.png", path)))
    rooms, _ = ndimage.label(free & closed)
    rooms[np.bincount(rooms.ravel())[rooms] < 400] = 0  # 1 m^2
    doorways = free & ~closed & ndimage.binary_dilation(rooms > 0, iterations=3)
    return rooms, ndimage.label(doorways, np.ones((3, 3)))[0]


def connected_pairs(rooms, doorways):
    """The pairs of rooms that a doorway touches."""
    from scipy import ndimage

    pairs = set()
    for doorway in range(1, doorways.max() + 1):
        near = np.unique(rooms[ndimage.binary_dilation(doorways == doorway, iterations=2)])
        near = [room for room in near if room > 0]
        pairs.update((a, b) for a in near for b in near if a < b)
    return pairs


def measure_plan(path, degrees, map_path):
    from scipy import ndimage

    free, origin, size = read_map(map_path)
    rooms, doorways = rooms_of_plan(path)
    y, x = np.indices(free.shape)
    x, y = origin[0] + size * (x + 0.5), origin[1] + size * (y + 0.5)
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    column, row = (np.floor(place / 0.05).astype(int) for place in (c * x + s * y, c * y - s * x))
    on_plan = (column >= 0) & (row >= 0) & (column < rooms.shape[1]) & (row < rooms.shape[0])
    room_at_cell = np.zeros(free.shape, int)
    room_at_cell[on_plan] = rooms[row[on_plan], column[on_plan]]
    expected = room_at_cell > 0
    expected[on_plan] |= doorways[row[on_plan], column[on_plan]] > 0
    areas, _ = ndimage.label(free)
    largest = {room: np.bincount(areas[(room_at_cell == room) & free], minlength=1).argmax()
               for room in np.unique(rooms) if room > 0}
    pairs = connected_pairs(rooms, doorways)
    joined = sum(largest[a] == largest[b] != 0 for a, b in pairs)
    overlap = np.count_nonzero(free & expected) / max(1, np.count_nonzero(free | expected))
    print(f"{map_path}: IoU {overlap:.4f}, {joined} of {len(pairs)} pairs of rooms are connected")


def main():
    if sys.argv[1].endswith(".png"):
        for path in sys.argv[3:]:
            measure_plan(sys.argv[1], float(sys.argv[2]), path)
        return
    with open(sys.argv[1], encoding="utf-8") as file:
        truth = json.load(file)
    for storey, path in enumerate(sys.argv[2:]):
        measure(truth, storey, path)


if __name__ == "__main__":
    main()
