# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""The examples of a page of the documentation, and a run of all of them."""

import os
import re
import subprocess
from collections import namedtuple
from pathlib import Path

Block = namedtuple("Block", "kind text file line")
NUMBER = r"-?\d[\d,]*(?:\.\d+)?"


def blocks(page):
    """All fenced blocks: kind, text, the file that the line above names (`name`:), the line in the page."""
    found, before, inside = [], "", None
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        if inside is None and line.startswith("```"):
            name = re.fullmatch(r"`([\w./-]+)`:", before)
            inside = Block(line[3:].strip(), [], name and name.group(1), number)
        elif line.startswith("```"):
            found.append(inside._replace(text="\n".join(inside.text) + "\n"))
            inside, before = None, ""
        elif inside is not None:
            inside.text.append(line)
        elif line.strip():
            before = line.strip()
    if inside is not None:
        raise ValueError(f"{page}:{inside.line}: the block does not end")
    return found


def _value(word):
    return float(word.replace(",", ""))


def says(told, line):
    """Is the line among those that were told? Spaces do not count, ... is anything, numbers may be off by a twentieth."""
    words = re.split(rf"(\.\.\.|{NUMBER})", " ".join(line.split()))
    pattern = ""
    for word in words:
        if word == "...":
            pattern += ".*"
        elif re.fullmatch(NUMBER, word):
            pattern += f"({NUMBER})"
        else:
            pattern += re.escape(word)
    numbers = [_value(word) for word in words if re.fullmatch(NUMBER, word)]
    for candidate in told.splitlines():
        match = re.fullmatch(pattern, " ".join(candidate.split()))
        if match and all(
            abs(_value(one) - other) <= max(0.05 * abs(other), 0.051)
            for one, other in zip(match.groups(), numbers)
        ):
            return True
    return False


def run(page, folder, environment):
    """Runs a page as a reader does, top to bottom: writes the files that it names, runs the blocks of sh, and holds what
    they say to the blocks of text. Indented blocks are not run. Raises AssertionError at the first that does not hold."""
    told = None
    counts = {"sh": 0, "text": 0}
    for block in blocks(Path(page)):
        place = f"{page}:{block.line}"
        if block.file:
            (Path(folder) / block.file).write_text(block.text, encoding="utf-8")
        elif block.kind == "sh":
            done = subprocess.run(
                ["bash", "-euo", "pipefail", "-c", block.text],
                cwd=folder,
                env={**os.environ, **environment},
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                text=True,
            )
            told = done.stdout
            assert done.returncode == 0, f"{place}: exit status {done.returncode}\n{block.text}\n{told}"
        elif block.kind == "text" and told is not None:
            for line in block.text.splitlines():
                assert says(told, line), f"{place}: this was not said: {line}\nbut\n{told}"
        else:
            raise AssertionError(f"{place}: a block of '{block.kind}' that nobody runs: what file is it?")
        if block.kind in counts and not block.file:
            counts[block.kind] += 1
    assert all(counts.values()), f"{page}: commands and what they say are missing: {counts}"
