"""Files that appear whole."""
# SPDX-License-Identifier: GPL-3.0-or-later
import os


def put(path, text):
    """Writes a file under a temporary name and renames it, so that make never meets half of it."""
    temporary = path.with_name(f"{path.name}.{os.getpid()}")
    temporary.write_text(text, encoding="utf-8")
    temporary.replace(path)
