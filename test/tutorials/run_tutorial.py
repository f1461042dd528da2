#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""run_tutorial.py PAGE SOURCE BUILD CMAKE FOLDER...: runs a tutorial as it is written, where the simulation's plans are as in
the project's folder and the programs of the FOLDERs are installed. A page that builds a program gets the project installed
from BUILD."""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
import pages


def main(page, source, build, cmake, programs):
    with tempfile.TemporaryDirectory() as name:
        folder, place = Path(name, "here"), Path(name, "installed")
        folder.mkdir()
        (place / "bin").mkdir(parents=True)
        (folder / "simulation").symlink_to(source / "simulation")
        python = place / "bin/python3"
        python.write_text(f'#!/bin/sh\nexec "{sys.executable}" "$@"\n')
        python.chmod(0o755)
        environment = {
            "PATH": os.pathsep.join([str(place / "bin"), *programs, os.environ["PATH"]]),
            "PYTHONPATH": str(build / "python"),
            "PYTHONDONTWRITEBYTECODE": "1",
        }
        if any(block.kind == "cmake" for block in pages.blocks(page)):
            install = [cmake, "--install", build, "--prefix", place]
            subprocess.run(install, stdout=subprocess.DEVNULL, check=True)
            environment["CMAKE_PREFIX_PATH"] = str(place)
        pages.run(page, folder, environment)


if __name__ == "__main__":
    try:
        main(*(Path(one).resolve() for one in sys.argv[1:4]), sys.argv[4], sys.argv[5:])
    except AssertionError as problem:
        sys.exit(str(problem))
