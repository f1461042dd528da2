#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Times beside those of PCL's own programs and classes, as ratios of medians.

    peers.py BUILD_FOLDER SCAN ROOM [-runs 5] [-threads 2] [-save ratios.json] [-against ratios.json]

SCAN is a scan of a building and ROOM one of a room with the field label, both PCD. What is compared runs in turns, so
that other work on the machine touches both. With -against, the exit status is 1 if a ratio is more than a tenth above
the one that was saved. Needs pcl_voxel_grid (Debian: pcl-tools) and the benchmarks
(-DPCL_INDOOR_BUILD_BENCHMARKS=ON).
"""
import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time

VOXEL = "0.2"  # metres, of the voxel grid that rooms are compared with
TOLERANCE = 1.1


def seconds_of(command):
    begin = time.monotonic()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return time.monotonic() - begin


def output_of(command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


class Peers:
    def __init__(self, arguments, folder):
        self.arguments, self.folder = arguments, folder
        self.tools = os.path.join(arguments.build, "tools")
        self.benchmarks = os.path.join(arguments.build, "test", "benchmark")

    def tool(self, name, *options):
        return [os.path.join(self.tools, name), *options]

    def output(self, name):
        return os.path.join(self.folder, name)

    def counters(self, name, *options):
        """Of a program of Google Benchmark: by the names of its benchmarks."""
        program = os.path.join(self.benchmarks, name)
        found = json.loads(output_of([program, *options, "--benchmark_format=json"]))["benchmarks"]
        return {entry["name"]: entry for entry in found}

    def rooms_with_files(self):
        """Whole processes, with reading and writing."""
        threads = str(self.arguments.threads)
        return (seconds_of(self.tool("pcl_room_segmentation", self.arguments.scan, self.output("rooms.pcd"), "-threads", threads, "-quiet")),
                self.voxel_grid_with_files())

    def voxel_grid_with_files(self):
        return seconds_of(["pcl_voxel_grid", self.arguments.scan, self.output("grid.pcd"), "-leaf", ",".join([VOXEL] * 3)])

    def rooms(self, threads):
        """Without reading and writing; the benchmark gives the ratio alone."""
        for name, entry in self.counters("bench_room_segmentation", self.arguments.scan).items():
            if f"threads:{threads}/" in name + "/":
                return entry["over_voxel_grid"], 1.0
        raise SystemExit(f"bench_room_segmentation: no line for {threads} threads")

    def objects(self, threads):
        """Without reading and writing."""
        path = self.output("objects.json")
        output_of(self.tool("pcl_lccp_comparison", self.arguments.room, "-threads", str(threads), "-json", path, "-quiet"))
        with open(path, encoding="utf-8") as file:
            methods = json.load(file)
        return methods["ours"]["mean"]["seconds"], methods["LCCP, tuned"]["mean"]["seconds"]

    def descriptor(self):
        of = {name.split("/")[0] + ("1" if "/1/" in name else ""): entry["cpu_time"]
              for name, entry in self.counters("bench_eppf", "--benchmark_filter=pair_harmonics/1/|esf").items()}
        return of["pair_harmonics1"], of["esf"]

    def pipeline(self):
        """Whole processes: rooms, walls, objects, classes, report."""
        threads = str(self.arguments.threads)
        return (seconds_of(self.tool("pcl_indoor_pipeline", self.arguments.scan, self.output("result"), "-threads", threads, "-quiet")),
                self.voxel_grid_with_files())

    def lines(self):
        threads = self.arguments.threads
        return {f"rooms with files, {threads} threads; pcl_voxel_grid": self.rooms_with_files,
                "rooms, 1 thread; pcl::VoxelGrid": lambda: self.rooms(1),
                f"rooms, {threads} threads; pcl::VoxelGrid": lambda: self.rooms(threads),
                "objects, 1 thread; normals, supervoxels, LCCP": lambda: self.objects(1),
                f"objects, {threads} threads; normals, supervoxels, LCCP": lambda: self.objects(threads),
                "descriptor, 1 thread; pcl::ESFEstimation": self.descriptor,
                f"pipeline with files, {threads} threads; pcl_voxel_grid": self.pipeline}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("scan")
    parser.add_argument("room")
    parser.add_argument("-runs", type=int, default=5)
    parser.add_argument("-threads", type=int, default=2)
    parser.add_argument("-save", help="file for the ratios")
    parser.add_argument("-against", help="file with ratios of an earlier run")
    arguments = parser.parse_args()
    earlier = {}
    if arguments.against:
        with open(arguments.against, encoding="utf-8") as file:
            earlier = json.load(file)
    ratios, slower = {}, []
    print("| work; peer | ours | peer | ratio |\n| --- | ---: | ---: | ---: |")
    with tempfile.TemporaryDirectory() as folder:
        for name, measure in Peers(arguments, folder).lines().items():
            pairs = [measure() for _ in range(arguments.runs)]
            ours, peer = (statistics.median(column) for column in zip(*pairs))
            ratios[name] = ours / peer
            print(f"| {name} | {ours:.3g} | {peer:.3g} | {ratios[name]:.3g} |", flush=True)
            if ratios[name] > TOLERANCE * earlier.get(name, float("inf")):
                slower.append(f"{name}: {ratios[name]:.3g}, was {earlier[name]:.3g}")
    if arguments.save:
        with open(arguments.save, "w", encoding="utf-8") as file:
            json.dump(ratios, file, indent=1)
    for line in slower:
        print(f"slower: {line}", file=sys.stderr)
    return 1 if slower else 0


if __name__ == "__main__":
    sys.exit(main())
