#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Run pcl_indoor_pipeline on whole labelled buildings and compare its objects with the truth, as a table.

    pipeline_objects.py TOOLS_FOLDER scan.pcd ...

Rooms are found, not given. The scans have the true object of each point in the field object_id, 0 = the building or
not known, and the room in the field label, 0 = outside. Right, PQ and AP50 are those of pcl_segmentation_evaluation,
objects of fewer than 100 points void. They do not tell how much of the building is taken for things; the last columns do:

    flagged   share of the building's points that are floor, wall or ceiling
    things    segments of at least 100 points that are none of these
    building  those of them most of whose points are of the building

Needs numpy.
"""
import argparse
import json
import os
import struct
import subprocess
import tempfile

import numpy


def decompressed(data):
    """The bytes that PCL's LZF made shorter."""
    result, at = bytearray(), 0
    while at < len(data):
        control = data[at]
        at += 1
        if control < 32:
            result += data[at:at + control + 1]
            at += control + 1
            continue
        length = (control >> 5) + 2
        if length == 9:
            length += data[at]
            at += 1
        begin = len(result) - ((control & 31) << 8) - data[at] - 1
        at += 1
        while length > 0:  # what is copied may reach into itself
            piece = result[begin:begin + length]
            result += piece
            begin += len(piece)
            length -= len(piece)
    return bytes(result)


def fields_of(file_name):
    """The fields of a compressed PCD file, by name."""
    with open(file_name, "rb") as file:
        header = {}
        while "DATA" not in header:
            key, *values = file.readline().decode().split()
            header[key] = values
        compressed = struct.unpack("II", file.read(8))[0]
        content = decompressed(file.read(compressed))
    kinds = {"F": "f", "U": "u", "I": "i"}
    fields, at, count = {}, 0, int(header["POINTS"][0])
    for name, kind, size in zip(header["FIELDS"], header["TYPE"], header["SIZE"]):
        fields[name] = numpy.frombuffer(content, kinds[kind] + size, count, at)
        at += count * int(size)
    return fields


def building_in(cloud):
    """Share of the building that is flagged, number of things, and of those that are building."""
    labelled = cloud["label"] > 0 if cloud["label"].any() else cloud["label"] == 0
    building = cloud["object_id"] == 0
    flagged = numpy.isin(cloud["structure"], [1, 2, 3])
    in_thing = labelled & (cloud["structure"] == 0) & (cloud["object"] > 0)
    _, segment = numpy.unique(cloud["object"][in_thing], return_inverse=True)
    points = numpy.bincount(segment)
    of_building = numpy.bincount(segment, weights=building[in_thing])
    things = points >= 100
    return (flagged[labelled & building].mean(), things.sum(), (things & (2 * of_building > points)).sum())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tools")
    parser.add_argument("scans", nargs="+")
    arguments = parser.parse_args()

    print("| scan | right | PQ | AP50 | flagged % | things | building |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: |")
    for scan in arguments.scans:
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([os.path.join(arguments.tools, "pcl_indoor_pipeline"), scan, folder, "-quiet",
                            "-report", "none", "-model", "none"], check=True)
            cloud, result = os.path.join(folder, "cloud.pcd"), os.path.join(folder, "result.json")
            subprocess.run([os.path.join(arguments.tools, "pcl_segmentation_evaluation"), cloud, cloud, "-truth_field",
                            "object_id", "-min_points", "100", "-json", result, "-quiet"],
                           check=True, stdout=subprocess.DEVNULL)
            with open(result, encoding="utf-8") as file:
                score = json.load(file)
            share, things, wrong = building_in(fields_of(cloud))
        name = os.path.splitext(os.path.basename(scan))[0]
        print(f"| {name} | {score['right_segments']} of {score['true_segments']} | {score['panoptic_quality']:.3f} "
              f"| {score['average_precision_50']:.3f} | {100 * share:.1f} | {things} | {wrong} |", flush=True)


if __name__ == "__main__":
    main()
