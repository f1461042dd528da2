# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
import unittest

import numpy as np

import flat
import pcl_indoor

ROOM = np.zeros((10, 3), np.float32)


class WrongArrays(unittest.TestCase):
    def refuse(self, line, *arguments, **options):
        with self.assertRaises(ValueError) as caught:
            pcl_indoor.segment_objects(*arguments, **options)
        self.assertIsInstance(caught.exception, pcl_indoor.InputError)
        self.assertEqual(str(caught.exception), line)

    def test_shapes(self):
        for shape in ((10,), (10, 2), (10, 4), (3, 10), (2, 5, 3), ()):
            self.refuse(
                f"points: the shape is {shape}, it must be (N, 3)", np.zeros(shape, np.float32)
            )

    def test_types(self):
        for name in ("int32", "float16", "complex64", "bool", "object", ">f4", "<U3"):
            self.refuse(
                f"points: the dtype is {np.dtype(name)}, it must be float32 or float64",
                np.zeros((10, 3), name),
            )

    def test_no_points(self):
        self.refuse("points: the cloud is empty (0 points)", np.zeros((0, 3), np.float32))

    def test_nothing_finite(self):
        self.refuse(
            "points: none of its 5 points is finite and less than 1e9 units from their middle",
            np.full((5, 3), np.nan),
        )

    def test_one_point(self):
        self.refuse("points: 1 finite points are too few, 2 are needed", np.zeros((1, 3)))

    def test_normals_and_colors(self):
        self.refuse(
            "point_normals: there are 9 for 10 points", ROOM, point_normals=np.ones((9, 3))
        )
        self.refuse(
            "point_normals: the dtype is int64, it must be float32 or float64",
            ROOM,
            point_normals=np.ones((10, 3), np.int64),
        )
        self.refuse(
            "point_colors: the dtype is float64, it must be uint8",
            ROOM,
            point_colors=np.ones((10, 3)),
        )
        self.refuse(
            "point_colors: the shape is (10, 4), it must be (N, 3)",
            ROOM,
            point_colors=np.ones((10, 4), np.uint8),
        )
        self.refuse(
            "point_normals, point_colors and viewpoint go with an array of points, "
            "a file has its own",
            flat.SCAN,
            point_normals=np.ones((10, 3)),
        )

    def test_viewpoint(self):
        for place in ((0, 0), (0, 0, float("nan"))):
            self.refuse(
                f"viewpoint: {place} is no place, three finite numbers are needed",
                ROOM,
                viewpoint=place,
            )

    def test_arrays_for_results(self):
        self.refuse(
            "structure: the array is (3,) of int32, it must be (1000,) of uint32",
            np.random.default_rng(2).uniform(size=(1000, 3)),
            structure=np.zeros(3, np.int32),
            messages=[],
        )

    def test_the_array_is_left_as_it_was(self):
        points = flat.points()
        before = points.copy()
        points.flags.writeable = False
        pcl_indoor.segment_rooms(points)
        np.testing.assert_array_equal(points, before)

    def test_lists_are_points(self):
        lines = []
        labels = pcl_indoor.segment_objects([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]], messages=lines)
        self.assertEqual(labels.shape, (3,))


if __name__ == "__main__":
    unittest.main()
