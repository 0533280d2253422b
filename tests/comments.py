#!/usr/bin/env python3
"""Refuses comments that open without their subject, and licence lines that continue a sentence.

usage: comments.py [FILE...]   Without files: all sources, scripts, studies and settings of the tree. Prints one line per
fault; exit status 1 if there are any.

A comment is a block of whole lines, or what follows code on its line. Only its first word counts: "Of a sphere, m3" and
"That of the next one" make the reader search for the noun that "Volume of a sphere (m3)" begins with.
"""
# SPDX-License-Identifier: GPL-3.0-or-later

import ast
import io
import pathlib
import re
import sys
import tokenize

OPENING = re.compile(r"(Of|Those|That of|What|The same|Whose)\b")
GLUED = re.compile(r"\S.*\bSPDX-License-Identifier")
# Strings and numbers with separators are matched first, so that no comment begins inside of them.
CPP = re.compile(
    r'R"(?P<mark>[^(\s]*)\((?:.|\n)*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"|\b\d[\w.]*(?:\'\w+)+|\'(?:\\.|[^\'\\\n])*\''
    r"|(?P<comment>//[^\n]*|/\*(?:.|\n)*?\*/)"
)
QUOTED = re.compile(r"'[^']*'|\"(?:\\.|[^\"\\])*\"")
FOLDERS = ("lib", "tools", "tests", "pipelines", "data")
SUFFIXES = {".cpp", ".h", ".c", ".py", ".sh", ".bash", ".bats", ".awk", ".mk", ".toml"}


def pieces_of_cpp(text):
    """Yields (line, whether code precedes it, text) of each comment or comment line."""
    for found in CPP.finditer(text):
        if found["comment"]:
            begin = text.rfind("\n", 0, found.start()) + 1
            words = found["comment"].lstrip("/*!< ").rstrip()
            yield text.count("\n", 0, begin) + 1, bool(text[begin : found.start()].strip()), words


def pieces_of_python(text):
    """Yields the same for Python, with docstrings as comments of one line."""
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT and not (token.start[0] == 1 and token.string.startswith("#!")):
            yield token.start[0], bool(token.line[: token.start[1]].strip()), token.string.lstrip("#! ")
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.Module, ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            words = ast.get_docstring(node)
            if words:
                yield node.body[0].lineno, True, words.splitlines()[0]


def pieces_of_lines(text):
    """Yields the same for languages whose comments run from # to the end of the line."""
    for number, line in enumerate(text.splitlines(), 1):
        bare = line.strip()
        if number == 1 and bare.startswith("#!"):
            continue
        if bare.startswith("# shellcheck "):
            continue
        if bare.startswith("#"):
            yield number, False, bare.lstrip("#! ")
            continue
        found = re.search(r"\s#\s+(.*)", QUOTED.sub(lambda quoted: "_" * len(quoted.group()), line))
        if found:
            yield number, True, line[found.start(1) :]


def faults(path):
    """Returns the faults of a file, a line each."""
    text = path.read_text(encoding="utf-8")
    python = path.suffix == ".py" or re.match(r"#!.*python", text) is not None
    cpp = path.suffix in (".cpp", ".h", ".c")
    pieces = sorted((pieces_of_cpp if cpp else pieces_of_python if python else pieces_of_lines)(text), key=lambda p: p[0])
    found, before = [], -1
    for line, after_code, words in pieces:
        if after_code or line != before + 1:
            opening = OPENING.match(words)
            if opening:
                found.append(f'{path}:{line}: opens with "{opening[1]}"; begin with the subject: {words[:60]}')
        if GLUED.match(words):
            found.append(f"{path}:{line}: the licence continues a sentence; put it on a line of its own")
        before = -1 if after_code else line
    return found


def tree():
    """Returns the files of the tree that hold comments."""
    root = pathlib.Path(__file__).resolve().parent.parent
    files = [root / "Makefile", root / ".ci" / "run", root / ".clang-tidy", root / "tools" / "plot"]
    for folder in FOLDERS:
        files += (path for path in (root / folder).rglob("*") if path.suffix in SUFFIXES)
    return sorted(path for path in files if path.is_file())


def main():
    """Prints the faults of the files that are named, or of the tree."""
    found = [fault for path in (list(map(pathlib.Path, sys.argv[1:])) or tree()) for fault in faults(path)]
    if found:
        sys.exit("\n".join(found))


if __name__ == "__main__":
    main()
