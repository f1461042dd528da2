#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Run pcl_indoor_pipeline on clouds and print what came out, how long it took and how much memory, as a table.

    pipeline_table.py TOOLS_FOLDER OUTPUT_FOLDER cloud.pcd ...
"""
import argparse
import json
import os
import time


def run(command):
    """Wall seconds and peak memory (MB) of a command that must succeed."""
    begin = time.monotonic()
    child = os.spawnvp(os.P_NOWAIT, command[0], command)
    _, status, usage = os.wait4(child, 0)
    if os.waitstatus_to_exitcode(status) != 0:
        raise SystemExit("failed: " + " ".join(command))
    return time.monotonic() - begin, usage.ru_maxrss / 1024


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tools")
    parser.add_argument("output")
    parser.add_argument("clouds", nargs="+")
    arguments = parser.parse_args()

    print("| cloud | points | in rooms | storeys | rooms | objects | seconds | MB |\n"
          "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |")
    for cloud in arguments.clouds:
        name = os.path.splitext(os.path.basename(cloud))[0]
        folder = os.path.join(arguments.output, name)
        seconds, memory = run([os.path.join(arguments.tools, "pcl_indoor_pipeline"), cloud, folder, "-quiet"])
        with open(os.path.join(folder, "scene.json"), encoding="utf-8") as file:
            scene = json.load(file)
        print(f"| {name} | {scene['points']} | {scene['points_in_rooms'] / scene['points']:.1%} | {len(scene['storeys'])} "
              f"| {len(scene['rooms'])} | {len(scene['objects'])} | {seconds:.1f} | {memory:.0f} |", flush=True)


if __name__ == "__main__":
    main()
