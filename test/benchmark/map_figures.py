#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""What maps of rooms look like in figures, real and simulated ones alike, as a table.

    map_figures.py [-least_area 6] scan.pcd rooms.json ...

rooms.json is what pcl_scan_simulation -json writes (rooms that the sensor did not enter and
those below -least_area m^2 are left out), or {"NAME of scan.pcd": {"regions": {"NAME":
[polygon, ...]}}} with polygons in metres. Columns, medians over the regions of a map:

    spacing  median distance of a point to its nearest neighbour, and its 90th percentile
    floor    share of squares of 0.3 m that hold a point within 0.15 m of the floor's height
    ceiling  the same for the height that most points higher than 2 m above the floor have
    walls    share of the boxes along the boundary (0.5 m long, 0.25 m high, 0.5 m to both
             sides, up to 2.5 m above the floor) that hold a point
    thick    of the quarter of such boxes, now of full height, where it is least (for there
             stands nothing before the wall): range of the middle 80 % of the distances within
             0.2 m of the line where most points are: noise, drift and doubled walls

PCD files are uncompressed or compressed binary or ascii. Needs numpy and scipy.
"""
import argparse
import json

import numpy as np
from scipy.spatial import cKDTree

from point_files import inside, name_of, read_fields


def inside_any(polygons, x, y):
    return np.logical_or.reduce([inside(p, x, y) for p in polygons])


def area_of(polygon):
    x, y = np.asarray(polygon, float).T
    return abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) / 2


def entered_rooms(scene):
    """Rooms of a simulated scene that the sensor was in."""
    path = np.array(scene["trajectory"])
    for room in scene["rooms"]:
        height = path[:, 2] - room["floor"]
        if (inside(room["polygon"], path[:, 0], path[:, 1]) & (height > 0) & (height < 2.2)).any():
            yield room


def regions_of(scan, description, least_area):
    """Lists of polygons with the heights between which they are looked at."""
    if "rooms" in description:
        return [([np.array(room["polygon"])], room["floor"] - 1, room["floor"] + 6)
                for room in entered_rooms(description) if area_of(room["polygon"]) >= least_area]
    named = description[name_of(scan)]
    return [([np.array(p) for p in polygons], -np.inf, np.inf) for polygons in named["regions"].values()]


def mode(values, step):
    lowest = values.min()
    return lowest + step * (np.bincount(((values - lowest) / step).astype(int)).argmax() + 0.5)


def heights_of(z):
    low = np.percentile(z, 2)
    floor = mode(z[(z > low - 0.3) & (z < low + 0.4)], 0.05)
    upper = z[z > floor + 2.0]
    return floor, mode(upper, 0.05) if len(upper) > 20 else np.nan


def share_of_squares(points, polygons):
    """Of the squares whose middle is in the region, those that hold a point."""
    side, corners = 0.3, np.concatenate(polygons)
    low = corners.min(axis=0)
    columns, rows = np.ceil((corners.max(axis=0) - low) / side).astype(int)
    x, y = np.meshgrid(low[0] + side * (np.arange(columns) + 0.5), low[1] + side * (np.arange(rows) + 0.5))
    wanted = inside_any(polygons, x.ravel(), y.ravel())
    square = ((points[:, :2] - low) / side).astype(int)
    square = square[((square >= 0) & (square < [columns, rows])).all(axis=1)]
    seen = np.zeros(columns * rows, bool)
    seen[square[:, 1] * columns + square[:, 0]] = True
    return seen[wanted].mean()


def boundary_boxes(polygons):
    """Middles and directions of pieces of 0.5 m of the boundary of the union."""
    for k, polygon in enumerate(polygons):
        for a, b in zip(polygon, np.roll(polygon, -1, axis=0)):
            length = np.linalg.norm(b - a)
            for along in np.arange(0.25, length - 0.2, 0.5):
                middle = a + (b - a) * along / length
                others = polygons[:k] + polygons[k + 1:]
                if not others or not inside_any(others, middle[:1], middle[1:])[0]:
                    yield middle, (b - a) / length


def thickness_of(along, across):
    """Range of the middle 80 % of the distances from the line where most points are."""
    near = abs(across - mode(across, 0.06)) < 0.1
    if near.sum() < 20:
        return np.nan
    rest = across - np.polyval(np.polyfit(along[near], across[near], 1), along)
    return np.subtract(*np.percentile(rest[abs(rest) < 0.2], [90, 10]))


def wall_figures(points, polygons, floor):
    shares, spreads = [], []
    tree = cKDTree(points[:, :2])
    for middle, way in boundary_boxes(polygons):
        near = points[tree.query_ball_point(middle, 0.6)]
        offset = near[:, :2] - middle
        along, across, height = offset @ way, offset @ [-way[1], way[0]], near[:, 2] - floor
        box = (abs(along) < 0.25) & (abs(across) < 0.5) & (height > 0.25) & (height < 2.5)
        shares.append(len(np.unique((height[box] / 0.25).astype(int))) / 9)
        if box.any():
            spreads.append(thickness_of(along[box], across[box]))
    spreads = np.array(spreads)[np.isfinite(spreads)]
    return np.mean(shares), np.percentile(spreads, 25) if len(spreads) else np.nan


def figures(points, polygons):
    members = points[inside_any(polygons, points[:, 0], points[:, 1])]
    floor, ceiling = heights_of(members[:, 2])
    spacing = cKDTree(members).query(members, 2)[0][:, 1]
    walls, thickness = wall_figures(points, polygons, floor)
    at_ceiling = members[abs(members[:, 2] - ceiling) < 0.15]
    return [np.median(spacing), np.percentile(spacing, 90),
            share_of_squares(members[abs(members[:, 2] - floor) < 0.15], polygons),
            share_of_squares(at_ceiling, polygons) if len(at_ceiling) else 0.0,
            walls, thickness, len(members) / sum(area_of(p) for p in polygons)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-least_area", type=float, default=6.0)
    parser.add_argument("maps", nargs="+", metavar="scan.pcd rooms.json")
    arguments = parser.parse_args()
    print("| map | regions | spacing, cm | floor | ceiling | walls | thick, cm | points per m^2 |")
    print("| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |")
    for scan, rooms in zip(arguments.maps[::2], arguments.maps[1::2]):
        with open(rooms, encoding="utf-8") as file:
            description = json.load(file)
        fields = read_fields(scan)
        points = np.column_stack([fields[k] for k in "xyz"]).astype(float)
        points = points[np.isfinite(points).all(axis=1)]
        rows = []
        for polygons, low, high in regions_of(scan, description, arguments.least_area):
            rows.append(figures(points[(points[:, 2] > low) & (points[:, 2] < high)], polygons))
        m = np.nanmedian(rows, axis=0)
        name = name_of(scan)
        print(f"| {name} | {len(rows)} | {100 * m[0]:.1f}, {100 * m[1]:.1f} | {m[2]:.0%} | {m[3]:.0%} | {m[4]:.0%} "
              f"| {100 * m[5]:.1f} | {m[6]:.0f} |", flush=True)


if __name__ == "__main__":
    main()
