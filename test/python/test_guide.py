# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""The Python code of the guide runs."""

import os
import re
import shutil
import sys
import tempfile
import unittest
import warnings
from pathlib import Path

import flat


class Guide(unittest.TestCase):
    def test_its_code_runs(self):
        blocks = re.findall(r"^```python\n(.*?)^```", GUIDE.read_text(), re.MULTILINE | re.DOTALL)
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
