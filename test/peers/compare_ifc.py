#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# compare_ifc.py SCENE TRUTH WEB_IFC IFCPLUSPLUS: what both programs read of the scene's IFC file, see read_ifc.sh.
import json
import statistics
import sys


def expected_counts(scene):
    kinds = [opening["kind"] for opening in scene["openings"]]
    in_wall = ["wall" in opening for opening in scene["openings"]]
    objects = [one.get("class", "") for one in scene["objects"] if one["structure"] == "none"]
    other = {"stairs": 0, "column": 0, "door": 0, "window": 0}
    for name in objects:
        if name in other:
            other[name] += 1
    return {
        "IFCBUILDINGSTOREY": len(scene["storeys"]), "IFCSPACE": len(scene["rooms"]),
        "IFCSLAB": sum(1 for room in scene["rooms"] if room["footprint"]), "IFCWALL": len(scene["walls"]),
        "IFCOPENINGELEMENT": sum(in_wall), "IFCDOOR": kinds.count("door"), "IFCWINDOW": kinds.count("window"),
        "IFCVIRTUALELEMENT": sum(1 for kind, wall in zip(kinds, in_wall) if kind == "passage" and not wall),
        "IFCSTAIR": other["stairs"], "IFCCOLUMN": other["column"] + len(scene["columns"]),
        "IFCBUILDINGELEMENTPROXY": other["door"] + other["window"],
        "IFCFURNITURE": len(objects) - sum(other.values()),
    }


def inside(polygon, x, y):
    result = False
    for (ax, ay), (bx, by) in zip(polygon, polygon[1:] + polygon[:1]):
        if (ay > y) != (by > y) and x < ax + (bx - ax) * (y - ay) / (by - ay):
            result = not result
    return result


def area_errors(scene, truth, areas):
    """Of each room of the truth that holds the middle of one room of the scene, and no other does."""
    errors = []
    for room in truth["rooms"]:
        found = [one for one in scene["rooms"] if one["storey"] == room["storey"]
                 and inside(room["polygon"], *one["centroid"][:2])]
        if len(found) == 1:
            errors.append(abs(areas[str(found[0]["room"])] - room["area"]) / room["area"])
    return errors


def main():
    scene, truth = (json.load(open(name, encoding="utf-8")) for name in sys.argv[1:3])
    problems = []
    with open(sys.argv[3], encoding="utf-8") as file:
        lines = file.read().splitlines()
    web = json.loads(next(line for line in lines if line.startswith("RESULT "))[7:])
    problems += ["web-ifc: " + line for line in lines if "error" in line.lower() and not line.startswith("RESULT ")]
    with open(sys.argv[4], encoding="utf-8") as file:
        lines = file.read().splitlines()
    problems += ["IfcPlusPlus: " + line for line in lines if line.startswith("COMPLAINT")]
    plus = {line.split()[0].upper(): int(line.split()[1]) for line in lines if not line.startswith("COMPLAINT")}
    for kind, count in expected_counts(scene).items():
        for name, counts in (("web-ifc", web["counts"]), ("IfcPlusPlus", plus)):
            if counts.get(kind, 0) != count:
                problems.append(f"{name} reads {counts.get(kind, 0)} of {count} {kind}")
    errors = area_errors(scene, truth, web["areas"])
    median = statistics.median(errors)
    print(f"{web['meshes']} meshes, {len(scene['rooms'])} spaces, {len(scene['walls'])} walls, "
          f"{plus.get('IFCDOOR', 0)} doors, {plus.get('IFCWINDOW', 0)} windows, {len(problems)} problems; "
          f"areas of {len(errors)} of {len(truth['rooms'])} rooms: median error {100 * median:.2f} %")
    if median > 0.01:
        problems.append("the areas are off by more than 1 %")
    print("\n".join(problems))
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
