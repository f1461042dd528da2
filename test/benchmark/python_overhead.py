# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""What Python adds to the library's work, on the points of a scan as an array:

    PYTHONPATH=build/python python3 test/benchmark/python_overhead.py scan.pcd [repeats]

The library's work is what a C++ program calls, too: memoryScan() and describeBuilding(). Beside it are the copy of the
array into the library's cloud, which is timed as a copy of the array, and the scene's dictionary and dataclasses.
"""

import statistics
import sys
import time

import numpy as np

import pcl_indoor
from pcl_indoor import _core

in_library = []


def timed(function):
    def called(*arguments):
        begin = time.perf_counter()
        result = function(*arguments)
        in_library[-1] += time.perf_counter() - begin
        return result

    return called


def main():
    fields = pcl_indoor.load(sys.argv[1], messages=[]).fields
    points = np.stack([fields["x"], fields["y"], fields["z"]], axis=1)
    _core.scan_of = timed(_core.scan_of)
    _core.describe = timed(_core.describe)
    whole = []
    copies = []
    for _ in range(int(sys.argv[2]) if len(sys.argv) > 2 else 5):
        begin = time.perf_counter()
        points.copy()
        copies.append(time.perf_counter() - begin)
        in_library.append(0.0)
        begin = time.perf_counter()
        pcl_indoor.describe(points, messages=[])
        whole.append(time.perf_counter() - begin)
    beside = statistics.median(a - b + c for a, b, c in zip(whole, in_library, copies))
    library = statistics.median(in_library)
    print(f"{len(points)} points: {statistics.median(whole):.2f} s, of them in the library {library:.2f} s,")
    print(f"beside it {1000 * beside:.0f} ms, {100 * beside / library:.2f} %")


if __name__ == "__main__":
    main()
