"""Text as people and programs write it: its encoding, its separators, its numbers."""
# SPDX-License-Identifier: GPL-3.0-or-later
import csv
import pathlib
import re

from .errors import StudyError

_BLANKS = str.maketrans({"\u00a0": " ", "\u2007": " ", "\u202f": " "})
_NOT_SEPARATING = re.compile(r'"[^"]*"|\[[^\]]*\]')


def read_text(path):
    """Returns the text of a file, without its byte-order mark. Raises StudyError where it is no UTF-8 text, OSError included."""
    try:
        content = pathlib.Path(path).read_bytes()
    except OSError as error:
        raise StudyError(f"{path}: cannot be read: {error.strerror}") from error
    if content.startswith(b"\x89HDF"):
        raise StudyError(f"{path}: an HDF5 file where a text belongs")
    if content.startswith((b"\xff\xfe", b"\xfe\xff")):
        raise StudyError(f"{path}: UTF-16 text; convert it to UTF-8: iconv -f UTF-16 -t UTF-8 FILE > NEW")
    if b"\0" in content:
        raise StudyError(f"{path}: holds zero bytes: not a text file")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = len((content[:error.start] + b".").splitlines())
        raise StudyError(f"{path}: line {line}: is not UTF-8; convert the file, from Latin-1 by: "
                         "iconv -f WINDOWS-1252 -t UTF-8 FILE > NEW") from error


def separator_of(header):
    """Returns what separates the names of a header: a tab, a semicolon or a comma outside of quotes and units."""
    bare = _NOT_SEPARATING.sub("", header)
    return next((separator for separator in "\t;," if separator in bare), "\t")


def cells(line, separator):
    """Returns the cells of a line without quotes and the blanks around them."""
    parts = next(csv.reader([line], delimiter=separator)) if '"' in line else line.split(separator)
    return [part.translate(_BLANKS).strip() for part in parts]


def number(word):
    """Returns the number that a word is, NaN included. Raises StudyError with the way to write it where it is none."""
    try:
        if word.isascii() and "_" not in word:
            return float(word)
    except ValueError:
        pass
    if re.fullmatch(r"[+-]?\d*,\d+([eE][+-]?\d+)?", word):
        raise StudyError(f"'{word}' is no number: write {word.replace(',', '.')}, with a decimal point")
    raise StudyError(f"'{word}' is no number")
