# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
import json
import tempfile
import unittest
from pathlib import Path

import numpy as np

import flat
import pcl_indoor


class OfObjects(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.objects = flat.objects()
        cls.paths = []
        for k, one in enumerate(cls.objects):
            cls.paths.append(cls.folder / f"{k}.pcd")
            flat.save(cls.paths[-1], x=one[:, 0], y=one[:, 1], z=one[:, 2])

    def test_descriptors_are_those_of_the_tool(self):
        cases = [
            {},
            {"preset": "thesis"},
            {"descriptor": "eppf_short", "pairs": 5000, "seed": 3},
            {"bins": (20, 4, 5, 3), "descriptor": "eppf", "scale": 2.5},
            {"normal_neighbors": 8},
        ]
        for options in cases:
            words = []
            for name, value in options.items():
                words += ["-" + name, "20,4,5,3" if name == "bins" else value]
            out = self.folder / "descriptor"
            status, said = flat.run("eppf_estimation", self.paths[0], out, *words)
            self.assertEqual(status, 0, said)
            expected = flat.histogram_of(out)
            for one in (self.objects[0], self.paths[0]):
                with self.subTest(options):
                    values = pcl_indoor.descriptor(one, **options)
                    self.assertEqual(values.dtype, np.float32)
                    self.assertAlmostEqual(float(values.sum()), 1.0, places=4)
                    np.testing.assert_array_equal(values, expected)

    def test_classes_are_those_of_the_tool(self):
        model = self.folder / "indoor_objects.model"
        model.write_bytes((flat.TOOLS.parent / "share/pcl_indoor/indoor_objects.model").read_bytes())
        out = self.folder / "classes.json"
        status, said = flat.run("eppf_classify", model, *self.paths, "-json", out)
        self.assertEqual(status, 0, said)
        expected = json.loads(out.read_text())
        expected = expected if isinstance(expected, list) else expected["objects"]
        for options in ({}, {"model": model, "threads": 1}):
            for objects in (self.objects, self.paths):
                found = pcl_indoor.classify(objects, **options)
                self.assertEqual(len(found), len(expected))
                for one, other in zip(found, expected):
                    self.assertEqual(one.name, other["class"])
                    self.assertAlmostEqual(one.confidence, other["confidence"], places=3)
                    self.assertAlmostEqual(sum(one.probabilities.values()), 1.0, places=4)
                    self.assertEqual(
                        list(one.probabilities)[: len(other["top"])],
                        [top["class"] for top in other["top"]],
                    )

    def test_the_distance_from_the_floor_counts(self):
        low, high = pcl_indoor.classify([self.objects[0]] * 2, floor_distances=[0.0, 2.0])
        self.assertNotEqual(low.probabilities, high.probabilities)

    def test_what_cannot_be_described_has_no_class(self):
        point = np.zeros((30, 3), np.float32)
        (found,) = pcl_indoor.classify([point], messages=[])
        self.assertEqual((found.name, found.confidence, found.probabilities), ("", 0.0, {}))
        with self.assertRaisesRegex(pcl_indoor.InputError, "^points: no two points with normals"):
            pcl_indoor.descriptor(point, messages=[])

    def test_what_is_wrong_is_told_in_a_line(self):
        cases = [
            ("objects: give a list", lambda: pcl_indoor.classify(self.objects[0])),
            ("floor_distances: there are 1 for 2", lambda: pcl_indoor.classify(self.paths[:2], floor_distances=[0])),
            ("no.model", lambda: pcl_indoor.classify(self.paths, model="no.model")),
            ("missing.pcd", lambda: pcl_indoor.classify(["missing.pcd"])),
            ("-bins: 'many'", lambda: pcl_indoor.descriptor(self.objects[0], bins="many")),
            ("-bins: there must be", lambda: pcl_indoor.descriptor(self.objects[0], bins=(10, 3, 4, 3))),
            ("-normal_neighbors: '2' is out of range", lambda: pcl_indoor.descriptor(self.objects[0], normal_neighbors=2)),
        ]
        for line, call in cases:
            with self.subTest(line), self.assertRaises(pcl_indoor.InputError) as caught:
                call()
            self.assertIn(line, str(caught.exception))


if __name__ == "__main__":
    unittest.main()
