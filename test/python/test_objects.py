# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
import tempfile
import unittest
from pathlib import Path

import numpy as np

import flat
import pcl_indoor


class OfARoom(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.path = Path(folder.name) / "room.pcd"
        cls.points = flat.living_room()
        flat.save(cls.path, x=cls.points[:, 0], y=cls.points[:, 1], z=cls.points[:, 2])

    def test_objects_are_those_of_the_tool(self):
        for options in ({}, {"preset": "parts", "remove_outliers": True}, {"partition": "lccp"}):
            words = []
            for name, value in options.items():
                words += ["-" + name] + ([] if value is True else [value])
            found = flat.fields_of("noise_resilient_lccp", self.path, *words)
            structure = np.zeros(len(self.points), np.uint32)
            with self.subTest(options):
                labels = pcl_indoor.segment_objects(
                    self.points, structure=structure, messages=[], **options
                )
                self.assertGreater(labels.max(), 3)
                np.testing.assert_array_equal(labels, found["object"])
                np.testing.assert_array_equal(structure, found["structure"])

    def test_normals_are_those_of_the_tool(self):
        for options in ({}, {"k": 30, "orientation": "free_space", "seed": 7}):
            words = [word for item in options.items() for word in ("-" + item[0], item[1])]
            found = flat.fields_of("hough_normals", self.path, *words)
            curvature = np.zeros(len(self.points), np.float32)
            with self.subTest(options):
                normals = pcl_indoor.estimate_normals(self.points, curvature=curvature, **options)
                self.assertGreater(np.isfinite(normals).all(axis=1).mean(), 0.9)
                for k, axis in enumerate("xyz"):
                    np.testing.assert_array_equal(normals[:, k], found[f"normal_{axis}"])
                np.testing.assert_array_equal(curvature, found["curvature"])

    def test_given_normals_are_used(self):
        normals = pcl_indoor.estimate_normals(self.points, orientation="free_space")
        fields = {f"normal_{axis}": normals[:, k] for k, axis in enumerate("xyz")}
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "with_normals.pcd"
            x, y, z = self.points.T
            flat.save(path, x=x, y=y, z=z, **fields)
            found = flat.fields_of("noise_resilient_lccp", path)["object"]
        labels = pcl_indoor.segment_objects(self.points, point_normals=normals, messages=[])
        np.testing.assert_array_equal(labels, found)
        without = pcl_indoor.segment_objects(
            self.points, point_normals=normals, ignore_normals=True, messages=[]
        )
        self.assertFalse(np.array_equal(without, labels))

    def test_the_viewpoint_turns_normals(self):
        middle = self.points.mean(axis=0)
        normals = pcl_indoor.estimate_normals(self.points, viewpoint=middle)
        outward = np.einsum("ij,ij->i", normals, self.points - middle)
        self.assertTrue((outward[np.isfinite(outward)] <= 1e-4).all())

    def test_wrong_options_are_told_as_the_tool_tells_them(self):
        cases = [
            ("noise_resilient_lccp", pcl_indoor.segment_objects, {"voxel_resolution": -1}),
            ("noise_resilient_lccp", pcl_indoor.segment_objects, {"voxel_resolution": "much"}),
            ("noise_resilient_lccp", pcl_indoor.segment_objects, {"partition": "none"}),
            ("noise_resilient_lccp", pcl_indoor.segment_objects, {"min_points": 2.5}),
            ("noise_resilient_lccp", pcl_indoor.segment_objects, {"ransac_share": 0.5}),
            ("noise_resilient_lccp", pcl_indoor.segment_objects, {"level": -0.5}),
            ("hough_normals", pcl_indoor.estimate_normals, {"radius": 1, "k": 3}),
            ("hough_normals", pcl_indoor.estimate_normals, {"bin_angle": float("nan")}),
            ("room_segmentation", pcl_indoor.segment_rooms, {"voxel_size": float("inf")}),
            ("room_segmentation", pcl_indoor.segment_rooms, {"persistence": 1.5}),
            ("room_segmentation", pcl_indoor.segment_rooms, {"up": "0,0,0"}),
            ("room_segmentation", pcl_indoor.segment_rooms, {"unit": ""}),
        ]
        for tool, function, options in cases:
            words = [word for item in options.items() for word in ("-" + item[0], item[1])]
            out = self.path.with_name("out.pcd")
            with self.subTest(options), self.assertRaises(pcl_indoor.InputError) as caught:
                function(self.points, **options)
            self.assertEqual(
                str(caught.exception), flat.complaint(tool, self.path, out, *words)
            )

    def test_unknown_options_are_type_errors(self):
        with self.assertRaises(TypeError):
            pcl_indoor.segment_objects(self.points, voxel=1)


if __name__ == "__main__":
    unittest.main()
