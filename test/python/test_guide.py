# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""The Python code of the guide runs."""

import os
import shutil
import sys
import tempfile
import unittest
import warnings
from pathlib import Path

import flat

sys.path.insert(0, str(Path(__file__).parents[1] / "support"))
import pages


class Guide(unittest.TestCase):
    def test_its_code_runs(self):
        blocks = [block.text for block in pages.blocks(GUIDE) if block.kind == "python"]
        self.assertGreater(len(blocks), 1)
        here = os.getcwd()
        with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
            warnings.simplefilter("ignore")
            shutil.copy(flat.SCAN, Path(folder) / "scan.pcd")
            os.chdir(folder)
            self.addCleanup(os.chdir, here)
            names = {}
            for block in blocks:
                exec(block, names)
            for name in ("scene.json", "building.ifc"):
                self.assertTrue(Path(name).exists())
            os.chdir(here)
        self.assertGreater(names["objects"].max(), 3)


if __name__ == "__main__":
    GUIDE = Path(sys.argv.pop())
    unittest.main()
