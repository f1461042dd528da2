# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""What Python adds to the library's work, on the points of a scan as an array:

    PYTHONPATH=build/python python3 test/benchmark/python_overhead.py scan.pcd [repeats]

The library's work is the call of describeBuilding(); beside it are the check of the array, the copy into the library's
cloud, and the scene's dictionary and dataclasses.
"""

import statistics
import sys
import time

import numpy as np

import pcl_indoor
from pcl_indoor import _core

in_library = []
describe_building = _core.describe


def timed(*arguments):
    begin = time.perf_counter()
    result = describe_building(*arguments)
    in_library.append(time.perf_counter() - begin)
    return result


def main():
    fields = pcl_indoor.load(sys.argv[1], messages=[]).fields
    points = np.stack([fields["x"], fields["y"], fields["z"]], axis=1)
    _core.describe = timed
    whole = []
    for _ in range(int(sys.argv[2]) if len(sys.argv) > 2 else 5):
        begin = time.perf_counter()
        pcl_indoor.describe(points, messages=[])
        whole.append(time.perf_counter() - begin)
    beside = statistics.median(a - b for a, b in zip(whole, in_library))
    library = statistics.median(in_library)
    print(f"{len(points)} points: {statistics.median(whole):.2f} s, of them in the library {library:.2f} s,")
    print(f"beside it {1000 * beside:.0f} ms, {100 * beside / library:.2f} %")


if __name__ == "__main__":
    main()
