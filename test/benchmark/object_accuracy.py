#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Run bench_object_accuracy on one source of labelled scans after the other.

    object_accuracy.py BUILD_FOLDER DATA_FOLDER [-sources homes,simulated,...] [options of bench_object_accuracy]

Each source is judged by itself: what is better on one of them only is no better. Scans of the source "simulated" are
made anew, of plans that the joining criterion was not learned from, in a folder that is kept (-work FOLDER).
"""
import argparse
import glob
import os
import subprocess
import tempfile

LABELLED = ["-room_field", "label", "-object_field", "object_id"]
FURNISHED = "sample_house fzk_2011 duplex large_building house_ru niedri home_h".split()


def simulate(tools, folder):
    """Scans of random plans: a home and an office each of three scanners."""
    os.makedirs(folder, exist_ok=True)
    scanners = [["-leaf", "0.02", "-rays_per_pose", "120000"],
                ["-leaf", "0.03", "-noise", "0.012", "-drift", "0.02"],
                ["-leaf", "0.025", "-rays_per_pose", "60000", "-spacing", "3.5"]]
    scans = []
    for number, scanner in enumerate(scanners):
        for kind in ("home", "office"):
            scan = os.path.join(folder, f"{kind}_{number}.pcd")
            if not os.path.exists(scan):
                subprocess.run([os.path.join(tools, "pcl_scan_simulation"), f"random:{kind}:{5000 + number}", scan,
                                "-quiet", "-seed", str(number + 1)] + scanner, check=True)
            scans.append(scan)
    return scans


def sources(data, tools, work):
    """Name, scans (made when asked for) and options of each source."""
    def files(pattern):
        return lambda: sorted(glob.glob(os.path.join(data, pattern)))

    yield "homes", files("homes/*.pcd"), LABELLED
    for scene in ("small_house", "office_small", "office_env_large"):
        yield scene, files(f"scenes/{scene}.pcd"), LABELLED
    yield "buildings", lambda: [os.path.join(data, "buildings", name + ".pcd") for name in FURNISHED], LABELLED
    yield "room1", files("rooms/room1_gt_fine.pcd"), ["-room_field", "none", "-object_field", "label", "-turns", "8"]
    yield "osd", files("osd/learn*.pcd"), ["-room_field", "none", "-object_field", "label"]
    yield "simulated", lambda: simulate(tools, work), ["-part_field", "part"]


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
