# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Keywords and what docstrings say of them are what the tools say with -h."""

import inspect
import re
import unittest

import flat
import pcl_indoor

OUTPUT = ["map", "dxf", "json", "check", "colour", "double", "memory_limit", "quiet", "h"]
FILES = ["columns", "input_dir", "output_dir", "nearest", "descriptor"]
PIPELINE = ["report", "ifc", "geojson", "epsg", "single_process"]
FUNCTIONS = [
    ("room_segmentation", pcl_indoor.segment_rooms, OUTPUT + ["columns"]),
    ("noise_resilient_lccp", pcl_indoor.segment_objects, OUTPUT + ["columns"]),
    ("hough_normals", pcl_indoor.estimate_normals, OUTPUT + ["columns"]),
    ("eppf_estimation", pcl_indoor.descriptor, OUTPUT + ["input_dir", "output_dir"]),
    ("eppf_classify", pcl_indoor.classify, OUTPUT + FILES),
    ("indoor_pipeline", pcl_indoor.describe, OUTPUT + PIPELINE),
    ("indoor_export", pcl_indoor.Scene.save, OUTPUT),
]


def options_of(tool):
    """Name, value and meaning of each option, as -h shows them."""
    _, text = flat.run(tool, "-h")
    return re.findall(r"^    -([a-z_]+)(?: (\S+))? = (.*)$", text, re.MULTILINE)


class Keywords(unittest.TestCase):
    def test_are_the_options_of_the_tool(self):
        for tool, function, left_out in FUNCTIONS:
            keywords = inspect.signature(function).parameters
            text = " ".join(function.__doc__.split())
            options = options_of(tool)
            self.assertGreater(len(options), 3)
            for name, value, meaning in options:
                if name in left_out:
                    continue
                shown = {"": "flag", "X": "number", "TEXT": "text"}.get(value, value)
                with self.subTest(tool=tool, option=name):
                    self.assertIn(name, keywords)
                    self.assertIn(f"{name} : {shown} {meaning}", text)
                    self.assertIs(keywords[name].kind, inspect.Parameter.KEYWORD_ONLY)
                    self.assertEqual(keywords[name].default, False if value == "" else None)

    def test_every_parameter_is_told(self):
        for name in pcl_indoor.__all__:
            function = getattr(pcl_indoor, name)
            if name == "__version__":
                continue
            self.assertTrue(function.__doc__, name)
            if not inspect.isfunction(function):
                continue
            for parameter in inspect.signature(function).parameters:
                if len(inspect.signature(function).parameters) > 1:
                    self.assertRegex(inspect.getdoc(function), rf"(?m)^{parameter} : ")


if __name__ == "__main__":
    unittest.main()
