#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""exports.py SOURCE NM LIBRARY...: the shared libraries export every function that a public header declares without
defining it, and of their own functions no other than those that a header marks with PCL_INDOOR_EXPORTS."""

import re
import subprocess
import sys
from pathlib import Path

MARK = "PCL_INDOOR_EXPORTS"
FEWEST = 200  # declarations in public headers; fewer: they were not understood


def without_comments(text):
    """The same length, with blanks in place of comments, texts and lines of the preprocessor."""
    blank = lambda match: re.sub(r"[^\n]", " ", match.group())
    text = re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', blank, text, flags=re.DOTALL)
    return re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", blank, text, flags=re.MULTILINE)


def declared_name(statement):
    """The name of the function that a statement declares; None if it declares none."""
    depth = 0
    for token in re.finditer(r"operator\s*(?:\(\)|[^\s\w(]+|\w+)|[<>(=]", statement):
        if token.group().startswith("operator"):
            return re.sub(r"\s", "", token.group())
        depth += {"<": 1, ">": -1}.get(token.group(), 0)
        if depth == 0 and token.group() == "=":
            return None
        if depth == 0 and token.group() == "(":
            name = re.search(r"~?\w+\s*$", statement[: token.start()])
            return name.group().strip() if name else None
    return None


def past_braces(text, position):
    """Behind the brace that closes the one before a position."""
    depth = 1
    while depth > 0:
        depth += {"{": 1, "}": -1}.get(text[position], 0)
        position += 1
    return position


def declarations(text):
    """Functions that are declared and not defined, as (class or "", name, is marked); templates are left out."""
    text = without_comments(text)
    scopes, start, position, depth = [], 0, 0, 0
    while position < len(text):
        letter = text[position]
        depth += {"(": 1, "[": 1, ")": -1, "]": -1}.get(letter, 0)
        position += 1
        if depth > 0 or letter not in ";{}":
            continue
        head = text[start : position - 1].strip()
        head = re.sub(r"^((public|protected|private)\s*:\s*)+", "", head)
        start = position
        scope = scopes[-1] if scopes else None
        if letter == "{":
            declared = re.match(r"(template\s*<.*>\s*)?(?:class|struct)\s+(?:%s\s+)?(\w+)" % MARK, head, re.DOTALL)
            if re.match(r"(inline\s+)?namespace\b", head):
                scopes.append(None)
            elif declared and not declared_name(head):
                scopes.append((declared.group(2), bool(declared.group(1)), MARK in head))
            else:  # a body, the values of an enumeration or of a variable
                position = past_braces(text, position)
                if not declared_name(head):
                    position = text.index(";", position) + 1
                start = position
        elif letter == "}":
            scopes.pop()
            if scope is not None:
                start = position = text.index(";", position) + 1
        else:
            name = declared_name(head)
            is_other = re.match(r"(using|typedef|static_assert|friend|extern|template\s*<\s*\w)", head)
            is_inline = re.search(r"\b(inline|constexpr)\b", head.split("(")[0])
            if name and not is_other and not is_inline and not re.search(r"=\s*(default|delete|0)$", head):
                if scope is None:
                    yield "", name, MARK in head
                elif not scope[1]:
                    yield scope[0], name, scope[2]


def exported(nm, library):
    """The functions that a library defines and shows, as (class or "", name), but for templates and the compiler's own."""
    lines = subprocess.run([nm, "-D", "-C", "--defined-only", library], check=True, capture_output=True, text=True)
    for line in lines.stdout.splitlines():
        kind, signature = line.split(maxsplit=2)[1:] if line[0] != " " else line.split(maxsplit=1)
        found = re.match(r"(?:pcl::)((?:\w+::)*?)(?:(\w+)(?:\[abi:\w+\])?::)?(~?\w+|operator[^\s(]+)(?:\[abi:\w+\])?\(", signature)
        if kind == "T" and found:
            owner = found.group(2) or ""
            yield ("" if owner[:1].islower() else owner), found.group(3)


def main():
    source, nm, libraries = Path(sys.argv[1]), sys.argv[2], sys.argv[3:]
    headers = [*source.glob("*/include/**/*.h*"), *source.glob("ml/*/include/**/*.h*")]
    built = {re.sub(r"^libpcl_indoor_|\.so.*$", "", Path(library).name) for library in libraries}
    if "training" not in built:
        headers = [header for header in headers if "training" not in header.parts]
    public = {d[:2] for h in headers for d in declarations(h.read_text())}
    private = [*source.glob("*/src/**/*.h"), *source.glob("ml/*/src/**/*.h")]
    marked = {d[:2] for h in [*headers, *private] for d in declarations(h.read_text()) if d[2]}
    shown = {function for library in libraries for function in exported(nm, library)}
    problems = [f"{'::'.join(filter(None, f))}: is declared by a public header, but not exported" for f in public - shown]
    problems += [f"{'::'.join(filter(None, f))}: is exported, but no header marks it" for f in shown - marked]
    if len(public) < FEWEST:
        problems.append(f"only {len(public)} declarations are found in public headers")
    print("\n".join(sorted(problems)) or f"{len(public)} functions of public headers, {len(shown)} that are exported")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
