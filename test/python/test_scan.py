# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
import gc
import tempfile
import unittest
from pathlib import Path

import numpy as np

import flat
import pcl_indoor


class Load(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_points_and_fields(self):
        path = self.folder / "some.pcd"
        rng = np.random.default_rng(3)
        xyz = rng.normal(size=(50, 3)).astype(np.float32)
        weight = rng.normal(size=50).astype(np.float32)
        xyz[7, 1] = np.nan
        flat.save(path, x=xyz[:, 0], y=xyz[:, 1], z=xyz[:, 2], weight=weight)
        scan = pcl_indoor.load(path)
        self.assertEqual(scan.name, str(path))
        self.assertEqual(len(scan), 50)
        self.assertEqual(list(scan.fields), ["x", "y", "z", "weight"])
        np.testing.assert_array_equal(scan.fields["weight"], weight)
        np.testing.assert_array_equal(scan.fields["y"], xyz[:, 1])
        self.assertEqual(scan.points.shape, (50, 3))
        self.assertTrue(np.isnan(scan.points[7]).all())
        keep = np.arange(50) != 7
        np.testing.assert_array_equal(scan.points[keep], xyz[keep])
        np.testing.assert_array_equal(scan.offset, np.zeros(3))
        self.assertIsNone(scan.normals)
        self.assertIsNone(scan.colors)

    def test_fields_have_the_types_of_the_file(self):
        path = self.folder / "types.pcd"
        types = ["f4", "f8", "i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8"]
        names = ["x", "y", "z", *types]
        kinds = ["f4"] * 3 + types
        values = np.zeros(2, dtype={"names": names, "formats": kinds})
        values["x"] = [1, 2]
        values["u8"] = [3, 2**64 - 1]
        values["i8"] = [-(2**63), 2**63 - 1]
        header = (
            f"VERSION .7\nFIELDS {' '.join(names)}\n"
            f"SIZE {' '.join(kind[1] for kind in kinds)}\n"
            f"TYPE {' '.join(kind[0].upper() for kind in kinds)}\n"
            f"COUNT {' '.join('1' for _ in kinds)}\n"
            "WIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA binary\n"
        )
        path.write_bytes(header.encode() + values.tobytes())
        fields = pcl_indoor.load(path, messages=[]).fields
        for name in types:
            self.assertEqual(fields[name].dtype, np.dtype(name))
            np.testing.assert_array_equal(fields[name], values[name])

    def test_arrays_are_views_that_keep_their_scan(self):
        path = self.folder / "some.pcd"
        xyz = np.random.default_rng(4).normal(size=(1000, 3)).astype(np.float32)
        flat.save(path, x=xyz[:, 0], y=xyz[:, 1], z=xyz[:, 2])
        scan = pcl_indoor.load(path)
        self.assertEqual(scan.points.ctypes.data, scan.points.ctypes.data)
        points, x = scan.points, scan.fields["x"]
        del scan
        gc.collect()
        np.testing.assert_array_equal(points, xyz)
        np.testing.assert_array_equal(x, xyz[:, 0])
        with self.assertRaises(ValueError):
            points[0, 0] = 1.0

    def test_large_coordinates_have_an_offset(self):
        path = self.folder / "utm.xyz"
        rng = np.random.default_rng(5)
        places = rng.uniform(0, 10, size=(100, 3)) + [690000.0, 5336000.0, 515.0]
        np.savetxt(path, places, fmt="%.4f")
        scan = pcl_indoor.load(path)
        np.testing.assert_allclose(scan.points + scan.offset, places, atol=1e-4)
        self.assertGreater(scan.offset[0], 600000)

    def test_normals_and_colors(self):
        path = self.folder / "all.ply"
        rng = np.random.default_rng(6)
        lines = []
        normals = rng.normal(size=(20, 3))
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        colors = rng.integers(0, 256, size=(20, 3))
        for place, normal, color in zip(rng.normal(size=(20, 3)), normals, colors):
            lines.append(" ".join(map(str, [*place, *normal, *color])))
        reals = "".join(f"property float {name}\n" for name in "x y z nx ny nz".split())
        whole = "".join(f"property uchar {name}\n" for name in "red green blue".split())
        path.write_text(
            f"ply\nformat ascii 1.0\nelement vertex 20\n{reals}{whole}end_header\n"
            + "\n".join(lines)
            + "\n"
        )
        scan = pcl_indoor.load(path)
        np.testing.assert_allclose(scan.normals, normals, atol=1e-6)
        np.testing.assert_array_equal(scan.colors, colors)

    def test_columns_of_a_table(self):
        path = self.folder / "table.csv"
        np.savetxt(path, np.arange(40).reshape(10, 4), delimiter=",")
        scan = pcl_indoor.load(path, columns="_,x,y,z", messages=[])
        np.testing.assert_array_equal(scan.points[0], [1, 2, 3])

    def test_several_stations(self):
        paths = []
        for k in range(2):
            paths.append(self.folder / f"station{k}.pcd")
            xyz = np.random.default_rng(k).normal(size=(30, 3)).astype(np.float32)
            flat.save(paths[-1], x=xyz[:, 0], y=xyz[:, 1], z=xyz[:, 2])
        scan = pcl_indoor.load(paths)
        self.assertEqual(len(scan), 60)
        np.testing.assert_array_equal(scan.fields["station"], [1] * 30 + [2] * 30)
        self.assertEqual([name for name, _ in scan.stations], ["station0.pcd", "station1.pcd"])

    def test_positions_of_stations(self):
        paths = []
        for k in range(2):
            paths.append(self.folder / f"station{k}.pcd")
            xyz = np.random.default_rng(k).normal(size=(30, 3)).astype(np.float32)
            flat.save(paths[-1], x=xyz[:, 0], y=xyz[:, 1], z=xyz[:, 2])
        positions = self.folder / "positions.csv"
        positions.write_text("0 0 1.5\n4 0 1.5\n")
        scan = pcl_indoor.load(paths, stations=positions)
        self.assertEqual([list(place) for _, place in scan.stations], [[0, 0, 1.5], [4, 0, 1.5]])
        scan = pcl_indoor.load(paths, stations=positions, ignore_stations=True)
        self.assertEqual([place for _, place in scan.stations], [None, None])
        with self.assertRaisesRegex(pcl_indoor.InputError, "2 positions for the 3 stations"):
            pcl_indoor.load([*paths, paths[0]], stations=positions)
        with self.assertRaisesRegex(pcl_indoor.InputError, "goes with load"):
            pcl_indoor.segment_rooms(scan, stations=positions)

    def test_normals_look_at_the_station(self):
        rng = np.random.default_rng(8)
        plane = np.column_stack([rng.uniform(0, 1, (2000, 2)), np.zeros(2000)]).astype(np.float32)
        positions = self.folder / "positions.csv"
        for height in (2.0, -2.0):
            positions.write_text(f"0.5 0.5 {height}\n")
            normals = pcl_indoor.estimate_normals(plane, stations=positions, messages=[])
            self.assertGreater(np.mean(normals[:, 2] * height > 0), 0.99)

    def test_a_file_that_is_none_is_told_as_the_tools_tell_it(self):
        cases = {"missing.pcd": None, "text.pcd": b"no cloud", "empty.ply": b""}
        for name, content in cases.items():
            path = self.folder / name
            if content is not None:
                path.write_bytes(content)
            with self.subTest(name), self.assertRaises(pcl_indoor.InputError) as caught:
                pcl_indoor.load(path)
            line = flat.complaint("room_segmentation", path, self.folder / "out.pcd")
            self.assertEqual(str(caught.exception), line)


if __name__ == "__main__":
    unittest.main()
