#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""packages_agree.py SOURCE VERSION HOMEPAGE: what the files of all packages say is what CMake says: the version, the
home page (which may be empty), the libraries that are asked for, the tools. Skipped (77) without python3-yaml."""

import json
import re
import sys
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

try:
    import yaml
except ImportError:
    print("SKIPPED: python3-yaml is not installed")
    sys.exit(77)

# What CMake looks for: its names in vcpkg, conda and rosdep; None: not asked for there, with the reason
LIBRARIES = {
    "PCL": ("pcl", "pcl", "libpcl-all-dev"),
    "nlohmann_json": ("nlohmann-json", "nlohmann_json", "nlohmann-json-dev"),
    "PNG": ("libpng", "libpng", "libpng-dev"),
    "pugixml": ("pugixml", "pugixml", "pugixml-dev"),
    "LibArchive": ("libarchive", "libarchive", None),  # rosdep has no name for it
    "librsvg-2.0": (None, "librsvg", None),  # not required; vcpkg's is older, rosdep has no name
    "PkgConfig": (None, "pkg-config", "pkg-config"),  # finds librsvg only
    "OpenMP": (None, None, None),  # comes with the compiler
    "MPI": (None, None, None),  # not required: several machines
    "Torch": (None, None, None),  # not required: training
}
NO_LIBRARIES = {"vcpkg-cmake", "vcpkg-cmake-config", "cmake", "ninja"}


def found_by_cmake():
    """Name to the least version, of all that is built without tests and the Python package."""
    found = {}
    for path in [SOURCE / "CMakeLists.txt", *SOURCE.glob("*/**/CMakeLists.txt")]:
        if re.match("test|experiments|python|ros2|build", str(path.relative_to(SOURCE))):
            continue
        text = path.read_text()
        for name, version in re.findall(r"^\s*find_package\((\w+) ?([\d.]*)", text, re.MULTILINE):
            found[name] = version or found.get(name, "")
        for name, version in re.findall(r"pkg_check_modules\(.*? ([\w.-]+)>=([\d.]+)\)", text):
            found[name] = version
    return found


def expected(column):
    names = {LIBRARIES[name][column]: version for name, version in found_by_cmake().items()}
    names.pop(None, None)
    return names


def vcpkg():
    return json.loads((SOURCE / "packaging/vcpkg/pcl-indoor/vcpkg.json").read_text())


def conda():
    return yaml.safe_load((SOURCE / "packaging/conda/recipe.yaml").read_text())


def ros(folder):
    return xml.parse(SOURCE / folder / "package.xml").getroot()


def citation():
    return yaml.safe_load((SOURCE / "CITATION.cff").read_text())


class Packages(unittest.TestCase):
    def test_versions_are_the_projects(self):
        changelog = (SOURCE / "CHANGELOG.md").read_text()
        told = {
            "vcpkg": vcpkg()["version"],
            "conda": conda()["context"]["version"],
            "citation": citation()["version"],
            "ros": ros(".").findtext("version"),
            "ros node": ros("ros2/pcl_indoor_ros").findtext("version"),
            "changelog": re.search(r"^## (\d+\.\d+\.\d+)", changelog, re.MULTILINE).group(1),
        }
        self.assertEqual(told, dict.fromkeys(told, VERSION))
        self.assertEqual(conda()["package"]["version"], "${{ version }}")

    def test_home_pages_are_the_projects(self):
        python = re.search(r'^Homepage = "(.*)"', (SOURCE / "pyproject.toml").read_text(), re.MULTILINE)
        told = [
            python and python.group(1),
            vcpkg().get("homepage"),
            conda()["about"].get("homepage"),
            citation().get("url"),
            ros(".").findtext("url"),
            ros("ros2/pcl_indoor_ros").findtext("url"),
        ]
        self.assertEqual(told, [HOMEPAGE or None] * len(told))

    def test_all_that_cmake_looks_for_is_known_here(self):
        self.assertEqual(set(found_by_cmake()) - set(LIBRARIES), set())
        self.assertEqual(set(LIBRARIES) - set(found_by_cmake()), set())

    def test_vcpkg_asks_for_what_cmake_does(self):
        asked = {}
        for one in vcpkg()["dependencies"]:
            one = {"name": one} if isinstance(one, str) else one
            asked[one["name"]] = one.get("version>=", "")
        self.assertEqual(list(asked), sorted(asked))  # as its formatter has it
        for name in NO_LIBRARIES:
            asked.pop(name, None)
        wanted = expected(0)
        self.assertEqual(set(asked), set(wanted))
        self.assertEqual(asked["pcl"], wanted["pcl"] + ".0")

    def test_the_port_installs_the_tools(self):
        port = (SOURCE / "packaging/vcpkg/pcl-indoor/portfile.cmake").read_text()
        listed = re.search(r"TOOL_NAMES([\w\s]*?)AUTO_CLEAN", port).group(1).split()
        tools = {f"pcl_{path.stem}" for path in (SOURCE / "tools").glob("*.cpp")}
        self.assertEqual(listed, sorted(tools - {"pcl_eppf_train"}))  # which needs libtorch
        usage = (SOURCE / "packaging/vcpkg/pcl-indoor/usage").read_text()
        for name in re.findall(r"pcl_indoor::(\w+)", usage):
            self.assertTrue((SOURCE / name / "CMakeLists.txt").exists(), name)
        for option in re.findall(r"PCL_INDOOR_\w+", port):
            self.assertIn(option, (SOURCE / "CMakeLists.txt").read_text())

    def test_conda_asks_for_what_cmake_does(self):
        asked = {}
        for one in conda()["requirements"]["build"] + conda()["requirements"]["host"]:
            if not one.startswith("${{"):
                name, _, version = one.partition(" >=")
                asked[name] = version
        least = re.search(r"cmake_minimum_required\(VERSION ([\d.]+)\)", (SOURCE / "CMakeLists.txt").read_text())
        self.assertEqual(asked["cmake"], least.group(1))
        for name in NO_LIBRARIES:
            asked.pop(name, None)
        self.assertEqual(asked, expected(1))

    def test_licences_are_those_of_the_files(self):
        about = conda()["about"]
        for path in about["license_file"]:
            self.assertTrue((SOURCE / path).exists(), path)
        texts = {path.stem for path in (SOURCE / "LICENSES").iterdir()}
        for told in (about["license"], vcpkg()["license"]):
            self.assertEqual(set(told.split(" AND ")), texts)

    def test_ros_asks_for_what_cmake_does(self):
        package = ros(".")
        asked = {one.text for tag in ("depend", "build_depend") for one in package.findall(tag)}
        self.assertEqual(asked, set(expected(2)))
        self.assertEqual(package.findtext("export/build_type"), "cmake")

    def test_the_ros_node_asks_for_what_its_cmake_does(self):
        folder = SOURCE / "ros2/pcl_indoor_ros"
        found = set(re.findall(r"find_package\((\w+)", (folder / "CMakeLists.txt").read_text()))
        asked = {one.text for one in ros("ros2/pcl_indoor_ros") if one.tag.endswith("depend")}
        names = {"nlohmann_json": "nlohmann-json-dev"}
        self.assertEqual(asked, {names.get(name, name) for name in found})

    def test_workflows_call_what_is_there(self):
        bootstrap = (SOURCE / "bootstrap").read_text()
        workflows = sorted((SOURCE / ".github/workflows").glob("*.yml"))
        self.assertGreater(len(workflows), 1)
        for path in workflows:
            for name, job in yaml.safe_load(path.read_text())["jobs"].items():
                with self.subTest(workflow=path.name, job=name):
                    self.assertIn("runs-on", job)
                    for step in job["steps"]:
                        self.assertEqual(("run" in step) + ("uses" in step), 1)
                        for word in re.findall(r"\./bootstrap (\w+)", step.get("run", "")):
                            self.assertRegex(bootstrap, rf"(?m)^  {word}\)")


if __name__ == "__main__":
    SOURCE, VERSION, HOMEPAGE = Path(sys.argv[1]), sys.argv[2], sys.argv[3]
    unittest.main(argv=sys.argv[:1])
