#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Compare the names of rooms in scene.json with those that the makers of buildings gave them.

    room_names.py BUILD_FOLDER DATA_FOLDER ... [-only NAME ...] [-results FOLDER] [-list]

BUILD_FOLDER holds tools/pcl_indoor_pipeline; each DATA_FOLDER has for each scan.pcd, with the field label (room), a
scan.json with

    rooms   id (or number, as pcl_scan_simulation -json writes it), name or kind; with "room": false or
            "outdoor": true they are left out

A true room is found if one room has an intersection over union of at least 0.5 with it, counted on points whose true
label is not 0. What its maker's word means is said in WORDS, the word that ends last counts; a room may have several names where a
word does not tell, such as a cellar room. Rooms without such a word are left out, and so is a word that names more
than half of the rooms of a building with six or more: that is a placeholder. A room is right if its name is one of
these, unknown if scene.json says so, else wrong. Needs numpy.
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

FEWEST = 6  # rooms, of a building with placeholders
STORE = ("storage", "technical")
WAY = ("corridor", "hall")
WORDS = {
    "kitchen": ("kitchen",), "küche": ("kitchen",), "kochen": ("kitchen",), "living_kitchen": ("living", "kitchen"),
    "living": ("living",), "wohnen": ("living",), "galerie": ("living", "hall", "other"),
    "bedroom": ("bedroom",), "schlaf": ("bedroom",), "children": ("bedroom",),
    "bath": ("bath",), "bad": ("bath",), "wc": ("toilet",), "toilet": ("toilet",),
    "corridor": ("corridor",), "flur": ("corridor",), "hallway": ("corridor",), "hall": WAY, "foyer": WAY, "gard/wifa": WAY,
    "stair": ("stairs",), "buero": ("office",), "office": ("office",), "hobby": ("office", "other"), "meeting": ("meeting",),
    "kellerraum": STORE, "storage": ("storage",), "utility": STORE, "hwr": STORE, "technik": ("technical",),
    "technical": ("technical",), "garage": ("storage", "other"), "dachboden": ("storage", "other"),
    "att": ("storage", "other"), "balcony": ("balcony",), "terrace": ("balcony",)}


def meanings(word):
    """The names that a maker's word allows; none if it says nothing."""
    word = word.lower()
    ends = [(word.rfind(each) + len(each), len(each), each) for each in WORDS if each in word]
    return WORDS[max(ends)[2]] if ends else ()


def true_names(scene):
    """Allowed names by the number of the room."""
    rooms = scene["rooms"]
    words = [re.sub(r"[0-9]+", "", room.get("kind", room["name"])).strip() for room in rooms]
    counts = collections.Counter(words)
    names = {}
    for room, word in zip(rooms, words):
        if room.get("room") is False or room.get("outdoor") or (len(rooms) >= FEWEST and counts[word] > 0.5 * len(rooms)):
            continue
        if meanings(word):
            names[room.get("id", room.get("number"))] = meanings(word)
    return names


def matches(label, found):
    """The found room of each true one."""
    judged = label > 0
    both = collections.Counter(zip(label[judged].tolist(), found[judged].tolist()))
    true_points, found_points = numpy.bincount(label), numpy.bincount(found[judged])
    return {true: room for (true, room), count in both.items()
            if room > 0 and 2 * count >= true_points[true] + found_points[room] - count}


def described(arguments, folder, scan):
    """The folder of the pipeline's results."""
    output = os.path.join(arguments.results or folder, name_of(scan))
    if not os.path.exists(os.path.join(output, "scene.json")):
        subprocess.run([os.path.join(arguments.build, "tools", "pcl_indoor_pipeline"), scan, output, "-quiet",
                        "-report", "none"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return output


def judged_rooms(scan, output):
    """Allowed names, and the found room, of each true room that has a name; None where none is found."""
    with open(os.path.splitext(scan)[0] + ".json", encoding="utf-8") as file:
        names = true_names(json.load(file))
    with open(os.path.join(output, "scene.json"), encoding="utf-8") as file:
        rooms = {room["room"]: room for room in json.load(file)["rooms"]}
    label, = read_fields(scan, ["label"] if has_field(scan, "label") else ["room"])
    found, = read_fields(os.path.join(output, "cloud.pcd"), ["room"])
    room_of = matches(numpy.asarray(label).astype(int), numpy.asarray(found).astype(int))
    return [(allowed, rooms[room_of[true]] if true in room_of else None) for true, allowed in sorted(names.items())]


def has_field(scan, name):
    with open(scan, "rb") as file:
        head = file.read(2000).split(b"\nDATA")[0].decode("ascii", "replace")
    return name in re.search(r"FIELDS(.*)", head)[1].split()


def verdict(allowed, room):
    if room is None:
        return "not found"
    return "unknown" if room["name"] == "unknown" else "right" if room["name"] in allowed else "wrong"


def line(name, counts):
    named = sum(counts.values())
    found = max(1, named - counts["not found"])
    cells = [name, named, named - counts["not found"], counts["right"], counts["wrong"], counts["unknown"],
             f"{100 * counts['right'] / found:.0f} %", f"{100 * counts['wrong'] / found:.0f} %"]
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def by_name_table(rooms):
    """Of all rooms that were found, by what they may be called."""
    table = collections.defaultdict(collections.Counter)
    for allowed, room in rooms:
        if room is not None:
            table[" or ".join(allowed)][verdict(allowed, room)] += 1
            if verdict(allowed, room) == "wrong":
                table[" or ".join(allowed)]["as " + room["name"]] += 1
    print("\n| truth | found | right | wrong | unknown | called instead |\n| --- | ---: | ---: | ---: | ---: | --- |")
    for name, counts in sorted(table.items()):
        instead = ", ".join(f"{each[3:]} {counts[each]}" for each in sorted(counts) if each.startswith("as "))
        print(f"| {name} | {counts['right'] + counts['wrong'] + counts['unknown']} | {counts['right']} | {counts['wrong']} | "
              f"{counts['unknown']} | {instead or '-'} |")


def by_threshold_table(rooms):
    """What other probabilities would do from which on a room is named."""
    found = [(room["name_probability"], room["name_top"][0]["name"] in allowed) for allowed, room in rooms if room is not None]
    print("\n| named from | right | wrong |\n| --- | ---: | ---: |")
    for least in (0.0, 0.4, 0.5, 0.6, 0.7, 0.8):
        right, wrong = (sum(is_right == kind for sure, is_right in found if sure >= least) for kind in (True, False))
        print(f"| {least} | {100 * right / len(found):.0f} % | {100 * wrong / len(found):.0f} % |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("data", nargs="+")
    parser.add_argument("-only", nargs="*", default=[], help="names of scans")
    parser.add_argument("-results", help="keep the folders of the pipeline here, and use those that are there")
    parser.add_argument("-list", action="store_true", help="a line for each room, too")
    arguments = parser.parse_args()
    print("| source | named | found | right | wrong | unknown | right | wrong |\n"
          "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |")
    rooms, total = [], collections.Counter()
    with tempfile.TemporaryDirectory() as folder:
        for scan in sorted(each for data in arguments.data for each in glob.glob(os.path.join(data, "*.pcd"))):
            name = name_of(scan)
            if arguments.only and name not in arguments.only:
                continue
            own = judged_rooms(scan, described(arguments, folder, scan))
            counts = collections.Counter(verdict(*each) for each in own)
            print(line(name, counts), flush=True)
            if arguments.list:
                for allowed, room in own:
                    if room is not None:
                        print(f"    {verdict(allowed, room)}: {' or '.join(allowed)}, room {room['room']}, "
                              f"{room['area']:.1f} m2, {room['name_top']}")
            rooms += own
            total += counts
    print(line("all", total))
    if any(room is not None for _, room in rooms):
        by_name_table(rooms)
        by_threshold_table(rooms)


if __name__ == "__main__":
    main()
