#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Rooms of maps as robots and hand-held lidars make them: simulate, segment, compare; a table.

    room_maps.py TOOLS_FOLDER WORK_FOLDER [-scanners spinning,solid_state,walk]
                 [-leaves 0.05,0.1,0.2,0.3] [-simulate "..."] [-options "..."] plan ...

TOOLS_FOLDER holds pcl_scan_simulation and pcl_room_segmentation; a plan is what the former
takes: a file or random:home:SEED. Each plan is scanned once by each scanner, with the
smallest leaf and the options of -simulate; what other leaves keep is the same as if the
tool had been asked for them (they should be multiples of the smallest).

A true room counts if the sensor entered it. It is right if a room that is found has an
intersection over union of at least 0.5 with it, over the points of entered rooms and those
that a found room holds beyond them. Rooms that were only seen through doors or glass count
neither as right nor as wrong: their points are left out. False are found rooms of which at
least half are points of entered rooms, or of no room at all, and that make no room right. Scans and
results stay in WORK_FOLDER; a scan that is there already is used. Needs numpy and scipy.
"""
import argparse
import json
import os
import re
import shlex
import subprocess

import numpy as np

from map_figures import entered_rooms
from point_files import name_of, read_fields, write_points


def plain_name(plan):
    return re.sub(r"[^A-Za-z0-9]+", "_", name_of(plan))


def simulated(arguments, plan, scanner, leaf):
    """Scan a plan unless that was done before; the names of the scan and its description."""
    scan = os.path.join(arguments.work, f"{plain_name(plan)}_{scanner}.pcd")
    description = scan[:-4] + ".json"
    if not os.path.exists(scan):
        subprocess.run([os.path.join(arguments.tools, "pcl_scan_simulation"), plan, scan, "-json", description, "-scanner",
                        scanner, "-leaf", str(leaf), "-quiet", *shlex.split(arguments.simulate)], check=True,
                       stdout=subprocess.DEVNULL)
    with open(description, encoding="utf-8") as file:
        return read_fields(scan), json.load(file)


def thinned(fields, leaf):
    """The first point of every cube."""
    cubes = np.floor(np.column_stack([fields[k] for k in "xyz"]).astype(float) / leaf + 1e-6).astype(np.int64)
    first = np.sort(np.unique(cubes, axis=0, return_index=True)[1])
    return {name: values[first] for name, values in fields.items()}


def segmented(arguments, points, result):
    """The room of each point, or None where the tool refuses the scan."""
    run = subprocess.run([os.path.join(arguments.tools, "pcl_room_segmentation"), points, result,
                          *shlex.split(arguments.options)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if run.returncode != 0:
        print(f"<!-- {os.path.basename(points)}: {run.stderr.strip()} -->")
        return None
    fields = read_fields(result)
    return fields["truth"].astype(int), fields["room"].astype(int)


def judged(truth, found, entered):
    """Rooms, right ones, found ones, false ones and the largest IoU of each room."""
    if found is None:
        return len(entered), 0, 0, 0
    counted = np.isin(truth, entered) | (truth == 0)
    right, used = 0, set()
    for room in entered:
        here = truth == room
        numbers, shared = np.unique(found[here & (found > 0)], return_counts=True)
        if not len(numbers):
            continue
        best = numbers[shared.argmax()]
        union = (here | ((found == best) & counted)).sum()
        if shared.max() >= 0.5 * union:
            right += 1
            used.add(best)
    numbers = np.unique(found[found > 0])
    false = [n for n in numbers if n not in used and counted[found == n].mean() >= 0.5]
    return len(entered), right, len(numbers), len(false)


def judge_plan(arguments, plan, scanner, leaves):
    scan, description = simulated(arguments, plan, scanner, min(leaves))
    entered = [room["number"] for room in entered_rooms(description)]
    for leaf in leaves:
        points = os.path.join(arguments.work, f"{plain_name(plan)}_{scanner}_{leaf:g}.pcd")
        result = points[:-4] + "_rooms.pcd"
        kept = thinned(scan, leaf)
        write_points(points, {"x": kept["x"], "y": kept["y"], "z": kept["z"], "truth": kept["room"]})
        truth, found = segmented(arguments, points, result) or (None, None)
        yield leaf, judged(truth, found, entered)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tools")
    parser.add_argument("work")
    parser.add_argument("-scanners", default="spinning,solid_state,walk")
    parser.add_argument("-leaves", default="0.05,0.1,0.2,0.3")
    parser.add_argument("-simulate", default="")
    parser.add_argument("-options", default="")
    parser.add_argument("plans", nargs="+")
    arguments = parser.parse_args()
    os.makedirs(arguments.work, exist_ok=True)
    scanners, leaves = arguments.scanners.split(","), [float(leaf) for leaf in arguments.leaves.split(",")]
    totals = {}
    print("| plan | scanner | rooms entered |" + "".join(f" {leaf:g} m: right / found / false |" for leaf in leaves))
    print("| --- | --- | ---: |" + " ---: |" * len(leaves))
    for plan in arguments.plans:
        for scanner in scanners:
            cells = dict(judge_plan(arguments, plan, scanner, leaves))
            for leaf, cell in cells.items():
                totals.setdefault(scanner, {}).setdefault(leaf, []).append(cell)
            print(f"| {plain_name(plan)} | {scanner} | {cells[leaves[0]][0]} |" +
                  "".join(" {} / {} / {} |".format(*cells[leaf][1:]) for leaf in leaves), flush=True)
    for scanner in scanners:
        sums = {leaf: np.sum(totals[scanner][leaf], axis=0) for leaf in leaves}
        print(f"| **all** | {scanner} | {sums[leaves[0]][0]} |" + "".join(
            f" {s[1]} ({s[1] / s[0]:.0%}) / {s[2]} / {s[3]} |" for s in sums.values()))


if __name__ == "__main__":
    main()
