"""Writes files so that no reader sees half of one."""
# SPDX-License-Identifier: GPL-3.0-or-later
import contextlib
import errno
import fcntl
import os
import pathlib
import re
import secrets
import stat


def followed(path):
    """Returns the file that a path leads to through links. The file need not exist.

    Raises PermissionError for a link that another user put into a folder of all users, such as /tmp.
    """
    path = pathlib.Path(path)
    if path.is_symlink():
        link, folder = path.lstat(), path.absolute().parent.stat()
        if folder.st_mode & stat.S_ISVTX and link.st_uid not in (os.geteuid(), folder.st_uid):
            raise PermissionError(errno.EACCES, "is a link of another user in a folder of all users")
    return pathlib.Path(os.path.realpath(path))


def put(path, content):
    """Writes text or bytes to a temporary file with an unpredictable name and renames it, so that no reader sees half of it.

    A link keeps pointing to its file. A replaced file keeps its permissions. Devices and pipes are written in place. Temporary
    files of killed processes are removed. Raises OSError; nothing is replaced then.
    """
    target, content = followed(path), content.encode() if isinstance(content, str) else content
    old = target.stat() if target.exists() else None
    if old and not stat.S_ISREG(old.st_mode):
        target.write_bytes(content)
        return
    prefix = f".{target.name[:200]}."
    _remove_left(target.parent, prefix)
    temporary = target.with_name(f"{prefix}{secrets.token_hex(8)}.tmp")
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW | os.O_CLOEXEC
    descriptor = os.open(temporary, flags, 0o600 if old else 0o666)
    try:
        with os.fdopen(descriptor, "wb") as file:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            if old:
                os.fchmod(file.fileno(), stat.S_IMODE(old.st_mode) & 0o777)
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
            temporary.replace(target)
    except OSError:
        temporary.unlink(missing_ok=True)
        raise


def _remove_left(folder, prefix):
    """Removes temporary files with this prefix that no process writes any more."""
    for entry in os.scandir(folder):
        if entry.name.startswith(prefix) and re.fullmatch(r"[0-9a-f]{16}\.tmp", entry.name[len(prefix):]):
            with contextlib.suppress(OSError), open(entry.path, "rb", opener=_no_link) as file:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
                os.unlink(entry.path)


def _no_link(path, flags):
    return os.open(path, flags | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC)
