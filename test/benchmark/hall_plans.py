#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Write eight plans of halls with small rooms beside them, to scan with pcl_scan_simulation.

    hall_plans.py FOLDER

Open offices with side rooms, a corridor of 40 m with rooms along it, a hall beside a corridor, high halls with columns and
aisles, a lobby with a lower part, an arcade. Then: room_maps.py TOOLS WORK FOLDER/*.json
"""
import argparse
import json
import os
import random

RANDOM = random.Random(5)


def rectangle(x0, y0, x1, y1):
    return [[round(x, 2), round(y, 2)] for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]


def room(name, x0, y0, x1, y1, **more):
    return {"name": name, "polygon": rectangle(x0, y0, x1, y1), **more}


def door(x, y, into, width=0.95, angle=85, **more):
    return {"at": [round(x, 2), y], "width": width, "angle": angle, "into": into, **more}


def window(x, y, width, height, sill):
    return {"at": [x, y], "width": width, "height": height, "sill": sill}


def columns(places, size):
    return [{"class": "column", "at": list(place), "size": size} for place in places]


def desks(x0, y0, x1, y1, step_x=3.2, step_y=3.0):
    """Rows of desks with a chair each."""
    made, y = [], y0
    while y <= y1:
        x = x0
        while x <= x1:
            made.append({"class": "desk", "at": [round(x, 2), round(y, 2)], "rotation": RANDOM.choice([0, 180]),
                         "size": [1.6, 0.8, 0.74], "seed": RANDOM.randrange(99)})
            made.append({"class": "chair", "at": [round(x + RANDOM.uniform(-0.2, 0.2), 2), round(y - 0.7, 2)],
                         "rotation": RANDOM.randrange(360), "seed": RANDOM.randrange(99)})
            x += step_x
        y += step_y
    return made


def plan(ceiling, rooms, doors=(), windows=(), passages=(), furniture=()):
    return {"ceiling_height": ceiling, "rooms": rooms, "doors": list(doors), "windows": list(windows),
            "passages": list(passages), "furniture": list(furniture)}


def open_office(furniture):
    rooms = [room("open office", 0, 0, 20, 13)] + [room(f"side {k}", 2 + 5 * k, 13, 7 + 5 * k, 17) for k in range(3)]
    doors = [door(4.5 + 5 * k, 13, f"side {k}", angle=angle) for k, angle in enumerate((85, 0, 60))]
    doors.append(door(0, 6, "open office", 1.2, 0))
    return plan(2.9, rooms, doors, [window(2.5 + 3.7 * k, 0, 2.6, 1.5, 0.9) for k in range(5)], (), furniture)


def corridor():
    rooms, doors, furniture = [room("corridor", 0, 0, 40, 2.2, kind="corridor")], [], []
    for y0, y1, at in ((2.2, 7, 2.2), (-4.8, 0, 0)):
        x = 0
        while x < 39:
            width = min(RANDOM.choice([3.5, 4.2, 5.2, 6.5]), 40 - x)
            if 40 - x - width < 3:
                width = 40 - x
            name = f"room {len(rooms)}"
            rooms.append(room(name, x, y0, x + width, y1))
            doors.append(door(x + width / 2, at, name, angle=RANDOM.choice([0, 0, 30, 85, 90])))
            furniture += desks(x + 1.5, y0 + 2, x + width - 1.2, y0 + 2)
            x += width
    return plan(2.6, rooms, doors + [door(0, 1.1, "corridor", 1.2)], (), (), furniture)


def plans():
    """The name and the only storey of each."""
    shelves = [{"class": "bookcase", "at": [x, 12.7], "rotation": 180} for x in (10.5, 15.5)]
    cabinets = [{"class": "cabinet", "at": [x, 6.5], "size": [1.6, 0.45, 1.5]} for x in (2, 3.7, 12, 13.7, 15.4)]
    yield "open_office", open_office(desks(2, 2.5, 18, 10.5) + desks(3.5, 15, 14, 15, 5) + shelves)
    yield "open_office_columns", open_office(
        desks(2, 2.5, 18, 10.5, 3.4, 3.2) +
        columns([(x, y) for x in (5, 10, 15) for y in (4.3, 8.7)], [0.45, 0.45, 2.9]) + cabinets)
    yield "corridor", corridor()
    yield "hall_beside", plan(
        2.7, [room("hall", 0, 2.5, 16, 13, kind="hall", ceiling=4.5), room("corridor", -6, 0, 26, 2.5, kind="corridor"),
              room("room a", 16, 2.5, 21, 8), room("room b", 21, 2.5, 26, 8)],
        [door(18.5, 2.5, "room a"), door(23.5, 2.5, "room b")], [window(4, 13, 3, 2.5, 0.5), window(11, 13, 3, 2.5, 0.5)],
        [{"at": [4, 2.5], "width": 2.0, "height": 2.3}, {"at": [12, 2.5], "width": 2.0, "height": 2.3}],
        desks(3, 5, 13, 11, 4, 3))
    aisles = [{"polygon": rectangle(-1, -1, 27, 4.0), "ceiling": 3.6}, {"polygon": rectangle(-1, 14.0, 27, 19), "ceiling": 3.6}]
    yield "high_aisles", plan(
        2.9, [room("hall", 0, 0, 26, 18, kind="hall", ceiling=8.0, ceiling_parts=aisles),
              room("office a", 26, 0, 31, 6), room("office b", 26, 6, 31, 12)],
        [door(26, 3, "office a"), door(26, 9, "office b"), door(0, 9, "hall", 2.2, 0, height=2.4)], (), (),
        columns([(x, y) for x in (4, 8.5, 13, 17.5, 22) for y in (4, 14)], [0.6, 0.6, 3.5]) + desks(6, 7, 20, 11, 7, 4) +
        desks(28, 2, 29, 9, 9, 6))
    yield "high_hall", plan(
        2.9, [room("hall", 0, 0, 28, 14, kind="hall", ceiling=9.0), room("entrance", -6, 4, 0, 10), room("store", 28, 0, 33, 7)],
        [door(0, 7, "hall", 2.0, height=2.3), door(28, 4, "store", 1.0)], (), (),
        columns([(x, 7) for x in (5, 10, 15, 20, 25)], [0.7, 0.7, 8.9]) + desks(3, 3, 25, 11, 5.5, 7))
    lobby = {"name": "lobby", "kind": "hall", "polygon": [[0, 0], [18, 0], [18, 8], [10, 8], [10, 16], [0, 16]], "ceiling": 6.5,
             "ceiling_parts": [{"polygon": rectangle(-1, 10, 11, 17), "ceiling": 2.9}]}
    yield "lobby", plan(
        2.9, [lobby, room("cafe", 10, 8, 18, 16), room("shop", 18, 0, 24, 8)], [door(18, 4, "shop", 1.6, height=2.3)],
        [window(5, 0, 4, 3, 0.1)], [{"at": [13, 8], "width": 3.0, "height": 2.6}],
        desks(12, 11, 16, 14, 3, 2.5) + desks(3, 3, 14, 5, 5, 3))
    yield "arcade", plan(
        2.8, [room("hall", 0, 0, 24, 15, kind="hall", ceiling=4.2)] + [room(f"room {k}", 24, 5 * k, 29, 5 * k + 5) for k in range(3)],
        [door(24, 2.5 + 5 * k, f"room {k}", angle=80) for k in range(3)], [window(4 + 5 * k, 0, 2, 2.2, 0.6) for k in range(4)], (),
        columns([(x, 7.5) for x in (3, 6.5, 10, 13.5, 17, 20.5)], [0.8, 0.5, 4.2]) + desks(3, 3, 20, 12, 5, 5))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    folder = parser.parse_args().folder
    os.makedirs(folder, exist_ok=True)
    for seed, (name, storey) in enumerate(plans(), 1):
        scene = {"name": name, "wall_thickness": 0.2, "seed": seed,
                 "storeys": [{"name": "ground floor", "elevation": 0.0, **storey}]}
        with open(os.path.join(folder, name + ".json"), "w", encoding="utf-8") as file:
            json.dump(scene, file, indent=1)


if __name__ == "__main__":
    main()
