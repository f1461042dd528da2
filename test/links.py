#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""links.py SOURCE: every link of a page to another page, a heading or a file of the project leads somewhere."""

import re
import sys
from pathlib import Path

OUTSIDE = re.compile(r"build|demo|(.*/)?node_modules/")  # as .gitignore has it


def prose(page):
    """Without its fenced blocks."""
    return re.sub(r"^```.*?^```", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)


def headings(page):
    """As their links are written."""
    for title in re.findall(r"^#+ (.*)", prose(page), re.MULTILINE):
        title = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", title)
        yield re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


def problems_of(source):
    pages = [page for page in source.rglob("*.md") if not OUTSIDE.match(str(page.relative_to(source)))]
    links = 0
    for page in sorted(pages):
        for link in re.findall(r"\]\(([^)\s]+)\)", prose(page)):
            path, _, heading = link.partition("#")
            if re.match(r"[a-z]+:", link):
                continue
            links += 1
            target = page.parent / path if path else page
            if not target.exists():
                yield f"{page.relative_to(source)}: there is no {link}"
            elif heading and target.suffix == ".md" and heading not in headings(target):
                yield f"{page.relative_to(source)}: {link} has no such heading"
    if links < 100:
        yield "hardly a link was found: the check is broken"


if __name__ == "__main__":
    found = list(problems_of(Path(sys.argv[1]).resolve()))
    print("\n".join(found))
    sys.exit(1 if found else 0)
