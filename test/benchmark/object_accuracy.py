#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Run bench_object_accuracy on one source of labelled scans after the other.

    object_accuracy.py BUILD_FOLDER DATA_FOLDER [-sources homes,simulated,...] [options of bench_object_accuracy]

Each source is judged by itself: what is better on one of them only is no better. Scans of the sources "simulated",
"tables" and "views" are made anew, of plans that the joining criterion was not learned from, in a folder that is kept
(-work FOLDER).
"""
import argparse
import glob
import os
import subprocess
import tempfile

LABELLED = ["-room_field", "label", "-object_field", "object_id"]
UNITED = "2,3,4,28,29,30/6,7,8,31,32,33/9,10,25,34,35,42/11,12,13,26,27,36/16,44/22,23"  # four chairs, a table and a lamp of room1
FURNISHED = "sample_house fzk_2011 duplex large_building house_ru niedri home_h".split()


def scan_once(tools, scan, plan, options):
    """Simulate a scan, unless it is there."""
    if not os.path.exists(scan):
        os.makedirs(os.path.dirname(scan), exist_ok=True)
        subprocess.run([os.path.join(tools, "pcl_scan_simulation"), plan, scan, "-quiet"] + options, check=True)
    return scan


def simulate(tools, folder):
    """Scans of random plans: a home and an office each of three scanners."""
    scanners = [["-leaf", "0.02", "-rays_per_pose", "120000"],
                ["-leaf", "0.03", "-noise", "0.012", "-drift", "0.02"],
                ["-leaf", "0.025", "-rays_per_pose", "60000", "-spacing", "3.5"]]
    scans = []
    for number, scanner in enumerate(scanners):
        for kind in ("home", "office"):
            scans.append(scan_once(tools, os.path.join(folder, f"{kind}_{number}.pcd"), f"random:{kind}:{5000 + number}",
                                   ["-seed", str(number + 1)] + scanner))
    return scans


def clutter(number):
    return ":cluttered" if number % 2 else ""


def see_tables(tools, folder):
    """What a depth camera sees of 60 random tables, from 0.9 to 1.3 m away."""
    places = "0.5,0.3,1.35 0.8,0,1.3 0.7,0.7,1.5 0.4,0.6,1.6 0.9,0.2,1.35 0.2,0.5,1.4 0.9,0.4,1.6".split()
    return [scan_once(tools, os.path.join(folder, "tables", f"table_{number}.pcd"),
                      f"random:table:{9000 + number}{clutter(number)}",
                      ["-seed", str(number), "-view", places[number % len(places)]])
            for number in range(1, 61)]


def see_rooms(tools, folder):
    """What a depth camera sees of 40 rooms of random homes and offices, from five heights."""
    return [scan_once(tools, os.path.join(folder, "views", f"room_{number}.pcd"),
                      f"random:{'home' if number % 4 else 'office'}:{5000 + number}{clutter(number // 2)}",
                      ["-seed", str(number), "-view", "random", "-height", "1.5 1.2 1.7 1.4 1.0".split()[number % 5]])
            for number in range(1, 41)]


def sources(data, tools, work):
    """Name, scans (made when asked for) and options of each source."""
    def files(pattern):
        return lambda: sorted(glob.glob(os.path.join(data, pattern)))

    yield "homes", files("homes/*.pcd"), LABELLED
    for scene in ("small_house", "office_small", "office_env_large"):
        yield scene, files(f"scenes/{scene}.pcd"), LABELLED
    yield "buildings", lambda: [os.path.join(data, "buildings", name + ".pcd") for name in FURNISHED], LABELLED
    yield "room1", files("rooms/room1_gt_fine.pcd"), ["-room_field", "none", "-object_field", "label", "-turns", "8"]
    yield "room1_whole", files("rooms/room1_gt_fine.pcd"), [
        "-room_field", "none", "-object_field", "label", "-part_field", "label", "-unite", UNITED, "-turns", "8"]
    yield "osd", files("osd/learn*.pcd"), ["-room_field", "none", "-object_field", "label"]
    yield "simulated", lambda: simulate(tools, work), ["-part_field", "part"]
    yield "tables", lambda: see_tables(tools, work), ["-room_field", "none", "-object_field", "part"]
    yield "views", lambda: see_rooms(tools, work), ["-room_field", "none"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("data")
    parser.add_argument("-sources")
    parser.add_argument("-work", default=os.path.join(tempfile.gettempdir(), "object_accuracy"))
    arguments, options = parser.parse_known_args()
    tools = os.path.join(arguments.build, "tools")
    bench = os.path.join(arguments.build, "test", "benchmark", "bench_object_accuracy")
    wanted = arguments.sources.split(",") if arguments.sources else None
    for name, scans, fields in sources(arguments.data, tools, arguments.work):
        if wanted and name not in wanted:
            continue
        print(f"\n### {name}\n", flush=True)
        subprocess.run([bench] + scans() + fields + options, check=True)


if __name__ == "__main__":
    main()
