"""The folder in which compiled modules are kept, and how an entry of it is made, checked and replaced."""

import atexit
import fcntl
import functools
import hashlib
import json
import os
import shutil
import stat
import tempfile
import threading
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from treeline._messages import InputWarning

RECORD = "treeline.json"  #: of an entry: the hashes of its files, and what the maker says of it
_one_at_a_time = threading.Lock()


def find_place() -> Path | None:
    """As for the code of `treeline drive`: TREELINE_CACHE, else `treeline` in XDG_CACHE_HOME, else ~/.cache/treeline.
    None where TREELINE_CACHE is set and empty, or nothing of these is an absolute path."""
    named = os.environ.get("TREELINE_CACHE")
    if named is not None:
        return Path(named).absolute() if named else None
    cache = os.environ.get("XDG_CACHE_HOME", "")
    home = os.environ.get("HOME", "")
    if os.path.isabs(cache):
        return Path(cache) / "treeline"
    return Path(home) / ".cache" / "treeline" if os.path.isabs(home) else None


def reason_to_distrust(folder: Path) -> str | None:
    """Why others could put code of theirs into a folder; None where they cannot."""
    for place in (folder, *folder.parents):
        status = place.stat()
        if status.st_uid != os.geteuid() and (place == folder or status.st_uid != 0):
            return f"\"{place}\" belongs to the user of number {status.st_uid}"
        is_of_others = status.st_mode & stat.S_IWOTH or (status.st_mode & stat.S_IWGRP and (
            place == folder or status.st_gid != os.getegid()))
        if is_of_others and (place == folder or not status.st_mode & stat.S_ISVTX):
            return f"others may write to \"{place}\""
    return None


@functools.cache
def find_temporary() -> Path:
    """A folder that lives as long as this process."""
    folder = tempfile.mkdtemp(prefix="treeline_")
    atexit.register(remove_own, folder, os.getpid())
    return Path(folder)


def remove_own(folder: str, process: int) -> None:
    """Removes a folder at the end of the process that made it, and not at that of its children."""
    if os.getpid() == process:
        shutil.rmtree(folder, ignore_errors=True)


def find_folder() -> Path:
    """The folder of the entries; where none can be kept one of this process."""
    place = find_place()
    if place is None:
        return find_temporary()
    folder = place / "python"
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        folder = folder.resolve()
        doubt = None if os.access(folder, os.W_OK) else f"\"{folder}\" cannot be written to"
        doubt = doubt or reason_to_distrust(folder)
    except OSError as fault:
        doubt = f"\"{folder}\": {fault.strerror}"
    if doubt is None:
        return folder
    warnings.warn(f"compiled code is not kept: {doubt}. Name a folder of your own in TREELINE_CACHE.", InputWarning,
                  stacklevel=2)
    return find_temporary()


@contextmanager
def lock(folder: Path, key: str) -> Iterator[None]:
    """Holds an entry against other processes and threads: a byte of the file `lock` for each entry. Where the file
    system has no locks, two may make the same entry, of which one stays."""
    with _one_at_a_time, open(folder / "lock", "ab") as file:
        try:
            fcntl.lockf(file, fcntl.LOCK_EX, 1, int(key[:15], 16))
        except OSError:
            pass
        yield


def hash_file(file: Path) -> str:
    with open(file, "rb") as opened:
        return hashlib.file_digest(opened, "sha256").hexdigest()


def read_entry(entry: Path) -> dict[str, Any] | None:
    """The record of an entry whose files are all as they were made; None where any is not."""
    try:
        with open(entry / RECORD, encoding="utf-8") as file:
            record: dict[str, Any] = json.load(file)
        intact = all(hash_file(entry / name) == digest for name, digest in record["files"].items())
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return None
    return record if intact else None


def publish(made: Path, entry: Path, told: dict[str, Any]) -> None:
    """Puts a folder in the place of an entry, at once: no other process sees a part of it. `told` goes to the record."""
    files = {file.name: hash_file(file) for file in sorted(made.iterdir())}
    (made / RECORD).write_text(json.dumps({**told, "files": files}), encoding="utf-8")
    if entry.exists():  # it was damaged
        os.rename(entry, tempfile.mkdtemp(dir=made.parent) + "/damaged")
    try:
        os.rename(made, entry)
    except OSError:
        if read_entry(entry) is None:  # else another process was faster
            raise
