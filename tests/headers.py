#!/usr/bin/env python3
"""Refuses headers and sources that lean on the includes of others, as far as a script can see it.

usage: headers.py   Prints one line per fault; exit status 1 if there are any.

A precompiled header brings the standard library to every source, so that a header without its own includes goes
unnoticed, and so does a source. Three rules stand in for compiling each header alone (make headers) and all sources
without the precompiled header (make NO_PCH=1), which take minutes:
1. For each name of the standard library, of fmt and of Eigen that a header or source uses, it or a header of the project
   that it includes has to include a header of the library that declares it, or for members of Eigen's matrices defines it.
2. A type that one header of the project alone defines is used only where that header is included, also through others.
3. A source with a header of its own includes it before any other, so that compiling the source checks the header.
"""
# SPDX-License-Identifier: GPL-3.0-or-later

import functools
import pathlib
import re
import sys

DECLARED = {
    "array": "array",
    "vector": "vector",
    "string": "string",
    "to_string": "string",
    "string_view": "string_view string",
    "optional nullopt": "optional",
    "variant visit monostate get_if holds_alternative": "variant",
    "map multimap": "map",
    "set": "set",
    "function": "functional",
    "unique_ptr shared_ptr make_unique make_shared": "memory",
    "span": "span",
    "pair move swap exchange forward": "utility map vector string memory algorithm functional",
    "tuple tie": "tuple",
    "sort stable_sort max min max_element min_element minmax_element clamp fill copy copy_n copy_if any_of all_of none_of": "algorithm",
    "count count_if find find_if transform rotate reverse unique lower_bound upper_bound equal replace remove_if": "algorithm",
    "nth_element for_each": "algorithm",
    "ranges": "algorithm ranges",
    "accumulate iota partial_sum": "numeric",
    "sqrt abs pow fma cbrt hypot isfinite lround llround floor ceil exp log sin cos atan2": "cmath",
    "int8_t uint8_t int16_t uint16_t int32_t uint32_t int64_t uint64_t": "cstdint",
    "size_t": "cstddef array string string_view vector map span memory",
    "numeric_limits": "limits",
    "numbers": "numbers",
    "chrono": "chrono",
    "filesystem": "filesystem",
    "atomic": "atomic",
    "thread": "thread",
    "mutex lock_guard": "mutex",
    "exception_ptr": "exception",
    "runtime_error": "stdexcept",
    "memcpy memcmp": "cstring",
    "bit_cast": "bit",
    "is_same_v conditional_t enable_if_t decay_t": "type_traits",
    "same_as": "concepts",
    "initializer_list": "initializer_list vector string",
    "bad_alloc": "new",
    "ostream ostringstream": "ostream iostream sstream fstream",
    "ifstream ofstream": "fstream",
    "istringstream stringstream": "sstream",
    "mt19937 mt19937_64 normal_distribution uniform_real_distribution": "random",
    "source_location": "source_location",
}
HEADERS_OF = {name: set(headers.split()) for names, headers in DECLARED.items() for name in names.split()}
# Members of Eigen's matrices that <Eigen/Core> declares and another header defines.
EIGEN = {
    r"\.(?:determinant|inverse)\(\)": "Eigen/LU",
    r"\.(?:cross|unitOrthogonal)\(|\bEigen::(?:AngleAxis|Quaternion)": "Eigen/Geometry",
    r"\bEigen::\w*EigenSolver": "Eigen/Eigenvalues",
    r"\.(?:llt|ldlt)\(\)|\bEigen::L[LD]L?T\b": "Eigen/Cholesky",
    r"\.jacobiSvd\(|\bEigen::JacobiSVD": "Eigen/SVD",
    r"\.\w*[hH]ouseholderQr\(|\bEigen::\w*HouseholderQR": "Eigen/QR",
}
WORDS = re.compile(r'//[^\n]*|"(?:\\.|[^"\\\n])*"')
ROOTS = (pathlib.Path("lib"), pathlib.Path("tests"))
PARTS = {f"lib/core/simd/{part}.h" for part in ("columns8", "lanes8", "lanes_x86", "lanes_portable")}  # of other headers


def found(name):
    """Returns the path of a header of the project, or None."""
    return next((root / name for root in ROOTS if (root / name).exists()), None)


@functools.cache
def reached(path):
    """Returns the headers of the project that a header includes, also through others, and itself."""
    seen = {path}
    for name in re.findall(r'^ *#include "([^"]+)"', path.read_text(encoding="utf-8"), re.M):
        if found(name):
            seen |= reached(found(name))
    return seen


@functools.cache
def homes():
    """Returns the headers that define each type with a name in capitals and small letters."""
    where = {}
    for path in (header for root in ROOTS for header in root.rglob("*.h")):
        code = WORDS.sub("", path.read_text(encoding="utf-8"))
        kinds = r"\b(?:struct|class|using|concept|typename|enum class)\s+([A-Z]\w*[a-z]\w*)(?!\w*;)"
        for name in re.findall(kinds, code):
            where.setdefault(name, set()).add(path)
    return where


@functools.cache
def includes(path):
    """Returns the headers of the library that a header includes, also through headers of the project."""
    text = path.read_text(encoding="utf-8")
    standard = set(re.findall(r"^ *#include <([\w./]+)>", text, re.M))
    for name in re.findall(r'^ *#include "([^"]+)"', text, re.M):
        if found(name):
            standard |= includes(found(name))
    return standard


def faults_of_library(path):
    """Yields a fault for each name of a library without an include."""
    code = WORDS.sub("", path.read_text(encoding="utf-8"))
    for name in sorted(set(re.findall(r"\bstd::(\w+)", code))):
        if name in HEADERS_OF and not HEADERS_OF[name] & includes(path):
            yield f"{path}: uses std::{name} and does not include <{min(HEADERS_OF[name], key=len)}>"
    if "fmt::" in code and not any(header.startswith("fmt/") for header in includes(path)):
        yield f"{path}: uses fmt and does not include <fmt/format.h>"
    for use, header in EIGEN.items():
        if re.search(use, code) and not {header, "Eigen/Dense"} & includes(path):
            yield f"{path}: uses {re.search(use, code)[0]} and does not include <{header}>"


def faults_of_header(path):
    """Yields a fault for each type without an include."""
    code = WORDS.sub("", path.read_text(encoding="utf-8"))
    for name in sorted(set(re.findall(r"(?<!::)(?<![\w.])(?:(?:io|dem|analysis|packing|fem|gws)::)?([A-Z]\w*[a-z]\w*)", code))):
        home = {header for header in homes().get(name, ()) if header.parts[0] in ("lib", path.parts[0])}
        if len(home) == 1 and not home & reached(path) and not re.search(rf"\b(?:struct|class) {name};", code):
            yield f"{path}: uses {name} and does not include {min(home)}"


def main():
    faults = []
    for path in sorted(header for root in ROOTS for header in root.rglob("*.h")):
        if str(path) in PARTS:
            continue
        faults.extend(faults_of_library(path))
        faults.extend(faults_of_header(path))
        source = path.with_suffix(".cpp")
        if source.exists():
            own = re.search(r'^#include "([^"]+)"', source.read_text(encoding="utf-8"), re.M)
            if not own or found(own[1]) != path:
                faults.append(f"{source}: does not include its own header before all others")
    for source in sorted(path for root in (*ROOTS, pathlib.Path("tools")) for path in root.rglob("*.cpp")):
        faults.extend(faults_of_library(source))
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
