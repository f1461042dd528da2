# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
import json
import tempfile
import unittest
from pathlib import Path

import numpy as np

import flat
import pcl_indoor


class Describe(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scene = pcl_indoor.describe(flat.SCAN, messages=[])
        cls.expected = json.loads((flat.RESULT / "scene.json").read_text())

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_is_the_scene_of_the_tool(self):
        self.assertEqual(self.scene.to_dict(), self.expected)
        self.scene.save(self.folder / "scene.json")
        self.assertEqual(
            (self.folder / "scene.json").read_bytes(), (flat.RESULT / "scene.json").read_bytes()
        )

    def test_labels_are_those_of_the_tool(self):
        cloud = flat.quiet_load(flat.RESULT / "cloud.pcd").fields
        np.testing.assert_array_equal(self.scene.room_of_point, cloud["room"])
        np.testing.assert_array_equal(self.scene.object_of_point, cloud["object"])
        np.testing.assert_array_equal(self.scene.structure_of_point, cloud["structure"])
        np.testing.assert_array_equal(self.scene.category_of_point, cloud["category"])

    def test_of_an_array_is_the_same_but_for_the_fields_of_the_file(self):
        told = []
        scene = pcl_indoor.describe(
            flat.points(),
            point_colors=flat.quiet_load(flat.SCAN).colors,
            messages=[],
            progress=lambda stage, done, of: told.append(stage),
        )
        found = scene.to_dict()
        self.assertEqual(found.pop("input"), "points")
        expected = dict(self.expected)
        expected.pop("input")
        self.assertEqual(found, expected)
        for stage in ("Segmenting rooms", "Finding walls, doors and windows", "Finding objects"):
            self.assertIn(stage, told)

    def test_dataclasses_hold_what_the_dictionary_holds(self):
        self.assertEqual(len(self.scene.rooms), 3)
        for room, found in zip(self.scene.rooms, self.expected["rooms"]):
            self.assertEqual(room.number, found["room"])
            self.assertEqual(room.area, found["area"])
            self.assertEqual(room.name, found["name"])
            self.assertEqual(room.name_probability, found["name_probability"])
            self.assertEqual(len(room.name_top), len(found["name_top"]))
            self.assertEqual(room.name_top[0][1], room.name_probability)
            self.assertEqual(list(room.objects), found["objects"])
            self.assertEqual(
                [[list(place) for place in line] for line in room.footprint], found["footprint"]
            )
            self.assertEqual(list(room.box.lower), found["box"]["lower"])
            self.assertEqual(
                [one.room for one in room.neighbours], [one["room"] for one in found["neighbours"]]
            )
        self.assertGreater(len(self.scene.walls), 3)
        for wall, found in zip(self.scene.walls, self.expected["walls"]):
            self.assertEqual(list(wall.begin), found["begin"])
            self.assertEqual(wall.thickness, found.get("thickness"))
        self.assertGreater(len(self.scene.openings), 1)
        for opening, found in zip(self.scene.openings, self.expected["openings"]):
            self.assertEqual((opening.kind, opening.open), (found["kind"], found["open"]))
            self.assertEqual(opening.wall, found.get("wall"))
        self.assertGreater(len(self.scene.objects), 5)
        for one, found in zip(self.scene.objects, self.expected["objects"]):
            self.assertEqual(one.number, found["object"])
            self.assertEqual(one.name, found["class"])
            self.assertEqual(one.storey, found.get("storey"))
            self.assertEqual([name for name, _ in one.top], [t["class"] for t in found["top"]])
            self.assertEqual(list(one.upright_box.size), found["upright_box"]["size"])
            self.assertEqual(one.points, (self.scene.object_of_point == one.number).sum())
        self.assertEqual(self.scene.storeys[0].area, self.expected["storeys"][0]["area"])
        self.assertEqual(self.scene.categories, self.expected["categories"])
        self.assertEqual(self.scene.warnings, self.expected["warnings"])
        self.assertIn("3 rooms", repr(self.scene))

    def test_options_are_those_of_the_tool(self):
        options = {"voxel_size": 0.15, "model": "none", "normals": "multi_scale", "min_area": 3}
        words = [word for item in options.items() for word in ("-" + item[0], item[1])]
        status, said = flat.run("indoor_pipeline", flat.SCAN, self.folder / "r", "-quiet", *words)
        self.assertEqual(status, 0, said)
        scene = pcl_indoor.describe(flat.SCAN, messages=[], **options)
        expected = json.loads((self.folder / "r" / "scene.json").read_text())
        self.assertEqual(scene.to_dict(), expected)
        self.assertIsNone(scene.category_of_point)
        self.assertIsNone(scene.objects[0].name)

    def test_of_a_scan_in_parts_has_no_labels(self):
        x, y, z = flat.points().T
        scan = self.folder / "uncompressed.pcd"  # others are read whole
        flat.save(scan, x=x, y=y, z=z)
        result = self.folder / "r"
        status, said = flat.run("indoor_pipeline", scan, result, "-quiet", "-points_at_once", 10000)
        self.assertEqual(status, 0, said)
        scene = pcl_indoor.describe(scan, points_at_once=10000, messages=[])
        self.assertEqual(scene.to_dict(), json.loads((result / "scene.json").read_text()))
        self.assertEqual(scene.to_dict()["settings"]["points_at_once"], 10000)
        self.assertIsNone(scene.room_of_point)

    def test_exports_are_those_of_the_tool(self):
        for ending, options in (("ifc", {"epsg": 25832}), ("geojson", {}), ("svg", {}), ("dxf", {})):
            with self.subTest(ending):
                path, expected = self.folder / f"a.{ending}", self.folder / f"b.{ending}"
                self.scene.save(path, **options)
                words = [word for item in options.items() for word in ("-" + item[0], item[1])]
                status, said = flat.run(
                    "indoor_export", flat.RESULT / "scene.json", expected, "-quiet", *words
                )
                self.assertEqual(status, 0, said)
                self.assertEqual(path.read_bytes(), expected.read_bytes())
        self.scene.save(self.folder / "map.pgm", resolution=0.1)
        self.assertTrue((self.folder / "map_route.geojson").exists())

    def test_is_read_again(self):
        scene = pcl_indoor.load_scene(flat.RESULT / "scene.json")
        self.assertEqual(scene.to_dict(), self.expected)
        self.assertEqual(scene.objects, self.scene.objects)
        self.assertIsNone(scene.room_of_point)
        scene.save(self.folder / "again.json")
        self.assertEqual(
            (self.folder / "again.json").read_bytes(), (flat.RESULT / "scene.json").read_bytes()
        )

    def test_what_is_wrong_is_told_in_a_line(self):
        def refuse(line, function, *arguments, **options):
            with self.subTest(line), self.assertRaises(pcl_indoor.InputError) as caught:
                function(*arguments, **options)
            self.assertIn(line, str(caught.exception))
            self.assertNotIn("\n", str(caught.exception))

        scene, describe = self.scene, pcl_indoor.describe
        refuse("a.xyz: cannot be written", scene.save, self.folder / "a.xyz")
        refuse("there is no folder", scene.save, self.folder / "none" / "scene.json")
        refuse("there is no folder", scene.save, self.folder / "none" / "a.ifc")
        refuse("-epsg: '-1' is out of range", scene.save, self.folder / "a.ifc", epsg=-1)
        refuse("missing.json", pcl_indoor.load_scene, self.folder / "missing.json")
        (self.folder / "list.json").write_text("[]")
        refuse("list.json", pcl_indoor.load_scene, self.folder / "list.json")
        refuse("missing.pcd", describe, self.folder / "missing.pcd")
        refuse("no.model", describe, flat.SCAN, model=self.folder / "no.model")
        refuse("-unit: 'yd' is not one of", describe, flat.SCAN, unit="yd")
        refuse("-normals: 'guess' is not one of", describe, flat.SCAN, normals="guess")
        refuse("points: the shape is", describe, np.zeros(3))

    def test_warns_of_what_is_odd(self):
        scene = None
        with self.assertWarnsRegex(pcl_indoor.PclIndoorWarning, "^points: "):
            scene = pcl_indoor.describe(np.random.default_rng(1).normal(size=(3000, 3)))
        self.assertTrue(scene.warnings)


if __name__ == "__main__":
    unittest.main()
