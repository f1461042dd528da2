# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
import unittest

import numpy as np

import flat
import pcl_indoor


class SegmentRooms(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.points = flat.points()
        cls.labels = flat.fields_of("room_segmentation", flat.SCAN)["room"]

    def test_gives_the_labels_of_the_tool(self):
        self.assertEqual(len(np.unique(self.labels)), 4)  # three rooms and none
        for scan in (self.points, flat.SCAN, str(flat.SCAN), flat.quiet_load(flat.SCAN)):
            labels = pcl_indoor.segment_rooms(scan)
            self.assertEqual(labels.dtype, np.uint32)
            np.testing.assert_array_equal(labels, self.labels)

    def test_takes_the_options_of_the_tool(self):
        for options in (
            {"voxel_size": 0.15, "min_area": 9},
            {"method": "field", "single_cluster": True},
            {"preset": "thesis"},
            {"up": (0, 0, 1), "unit": "m", "threads": 1},
        ):
            words = []
            for name, value in options.items():
                words.append("-" + name)
                if value is not True:
                    words.append("0,0,1" if name == "up" else value)
            expected = flat.fields_of("room_segmentation", flat.SCAN, *words)["room"]
            with self.subTest(options):
                np.testing.assert_array_equal(
                    pcl_indoor.segment_rooms(self.points, messages=[], **options), expected
                )

    def test_reads_arrays_of_any_strides(self):
        wide = np.zeros((len(self.points), 7), np.float32)
        wide[:, 1:6:2] = self.points
        for array in (
            np.asfortranarray(self.points),
            wide[:, 1:6:2],
            self.points[::-1][::-1],
            self.points.astype(np.float64),
        ):
            np.testing.assert_array_equal(pcl_indoor.segment_rooms(array), self.labels)

    def test_points_that_are_none_are_in_no_room(self):
        points = self.points.copy()
        points[::7] = np.nan
        labels = pcl_indoor.segment_rooms(points)
        self.assertEqual(len(labels), len(points))
        self.assertTrue((labels[::7] == 0).all())
        self.assertGreater((labels[1::7] > 0).mean(), 0.9)

    def test_tells_how_far_it_is(self):
        told = []
        pcl_indoor.segment_rooms(self.points, progress=lambda *step: told.append(step))
        self.assertTrue(all(stage == "Segmenting rooms" for stage, _, _ in told))
        shares = [done / of for _, done, of in told]
        self.assertGreater(len(shares), 3)
        self.assertEqual(shares, sorted(shares))
        self.assertEqual(shares[-1], 1.0)

    def test_what_progress_raises_ends_the_work(self):
        def stop(stage, done, of):
            raise KeyError("enough")

        with self.assertRaisesRegex(KeyError, "enough"):
            pcl_indoor.segment_rooms(self.points, progress=stop)
        np.testing.assert_array_equal(pcl_indoor.segment_rooms(self.points), self.labels)

    def test_warns_of_a_scan_without_rooms(self):
        ball = np.random.default_rng(1).normal(size=(5000, 3)).astype(np.float32)
        with self.assertWarnsRegex(pcl_indoor.PclIndoorWarning, "^points: ") as caught:
            pcl_indoor.segment_rooms(ball)
        self.assertEqual(caught.filename, __file__)  # of who called
        lines = []
        labels = pcl_indoor.segment_rooms(ball, messages=lines)
        self.assertTrue(lines and lines[0].startswith("points: "))
        self.assertEqual(len(labels), 5000)


if __name__ == "__main__":
    unittest.main()
