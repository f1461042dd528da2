#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""licences.py SOURCE: every file that git knows tells its copyright and licence, by a header or by REUSE.toml, as REUSE 3.3
has it; LICENSES holds the texts of exactly the licences that are used. Where reuse is installed, it is asked, too."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

SKIPPED = 77
IS_NO_WORK = re.compile(r"(^|/)(LICENSES/.*|(LICEN[CS]E|COPYING)([-.][^/]*)?|REUSE\.toml|[^/]*\.license)$")
# REUSE-IgnoreStart
LICENCE = re.compile(rb"SPDX-License-Identifier: ([A-Za-z0-9.+-]+)")
COPYRIGHT = re.compile(rb"(SPDX-FileCopyrightText:|Copyright \(c\)) *\d{4}")
# REUSE-IgnoreEnd


def pattern_of(glob):
    """As REUSE.toml means it: * stays in a folder, ** does not."""
    parts = re.split(r"(\*\*|\*)", glob)
    signs = {"**": ".*", "*": "[^/]*"}
    return re.compile("".join(signs.get(part, re.escape(part)) for part in parts) + r"\Z")


def annotations_of(source):
    import tomllib

    content = tomllib.loads((source / "REUSE.toml").read_text())
    if content["version"] != 1:
        sys.exit("REUSE.toml: version must be 1")
    for annotation in content["annotations"]:
        for name in ("SPDX-FileCopyrightText", "SPDX-License-Identifier"):
            if not annotation.get(name):
                sys.exit(f"REUSE.toml: {annotation['path']} has no {name}")
        paths = annotation["path"]
        for path in [paths] if isinstance(paths, str) else paths:
            yield path, pattern_of(path), annotation


def licence_of(path, bytes_of_file, annotations, used):
    """None if nobody tells it."""
    head = bytes_of_file[:4000]
    own = LICENCE.search(head) if COPYRIGHT.search(head) else None
    told = None
    for glob, pattern, annotation in annotations:
        if pattern.match(path):
            told = annotation
            if not own or annotation.get("precedence") == "override":
                used.add(glob)
    if own and not (told and told.get("precedence") == "override"):
        return own.group(1).decode()
    return told and told["SPDX-License-Identifier"]


def problems_of(source, files):
    annotations = list(annotations_of(source))
    used, licences = set(), set()
    for path in files:
        content = (source / path).read_bytes() if (source / path).is_file() else b""
        if not content or IS_NO_WORK.search(path):
            continue
        licence = licence_of(path, content, annotations, used)
        if licence is None:
            yield f"{path}: has neither a header with copyright and licence nor a line of REUSE.toml"
        else:
            licences.add(licence)
    for glob, _, _ in annotations:
        if glob not in used:
            yield f"REUSE.toml: {glob} stands for no file without a header"
    texts = {path.stem for path in (source / "LICENSES").glob("*.txt")}
    for licence in sorted(licences ^ texts):
        yield f"LICENSES/{licence}.txt: " + ("is missing" if licence in licences else "is the licence of no file")
    if (source / "LICENSE").read_bytes() != (source / "LICENSES/BSD-3-Clause.txt").read_bytes():
        yield "LICENSE: is not LICENSES/BSD-3-Clause.txt"


def reads_toml(reuse):
    """Is it there, and not from before REUSE.toml?"""
    if not shutil.which(reuse):
        return False
    said = subprocess.run([reuse, "--version"], capture_output=True, text=True).stdout
    version = re.search(r"(\d+)\.", said)
    return version is not None and int(version.group(1)) >= 4


def main(source):
    if sys.version_info < (3, 11):
        print("Python 3.11 reads TOML, this one is older")
        return SKIPPED
    git = ["git", "-c", f"safe.directory={source}", "-C", str(source), "ls-files", "-z"]
    try:
        listed = subprocess.run(git, capture_output=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        print("This is no checkout: git does not know its files")
        return SKIPPED
    problems = list(problems_of(source, listed.decode().split("\0")[:-1]))
    print("\n".join(problems))
    lint = 0
    if reads_toml("reuse"):
        lint = subprocess.run(["reuse", "--root", source, "lint"]).returncode
    return 1 if problems or lint else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve()))
