"""Results in folders: written whole or not at all, and found again."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path

from .errors import CagelessError, InputError

__all__ = ["make", "read", "write"]


def make(folder: str | os.PathLike[str]) -> Path:
    """Makes a folder and those above it.

    Raises
    ------
    InputError
        If a file is in the way or the system does not permit it.
    """
    path = Path(folder)
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"{path}: the folder cannot be made: {error.strerror}") from error
    return path


def write(
    folder: str | os.PathLike[str], name: str, content: bytes, *, create: bool = True
) -> Path:
    """Writes a file, which takes its name when it is complete.

    Raises
    ------
    InputError
        If there is no such folder, or a folder has this name.
    CagelessError
        If the system refuses, because the disk is full, say.
    """
    folder = make(folder) if create else Path(folder)
    path = folder / name
    if not folder.is_dir():
        raise InputError(f"{path}: the folder {folder} is not there; make it first")
    if path.is_dir():
        raise InputError(f"{path}: is a directory where a file is to be")
    try:
        handle, partial = tempfile.mkstemp(prefix=f".{name}.", dir=folder)
        try:
            with os.fdopen(handle, "wb") as file:
                file.write(content)
            umask = os.umask(0)
            os.umask(umask)
            os.chmod(partial, 0o666 & ~umask)
            os.replace(partial, path)
        except BaseException:
            os.unlink(partial)
            raise
    except OSError as error:
        raise CagelessError(f"{path}: {error.strerror}") from error
    return path


def read(path: Path) -> str:
    """The text of a file.

    Raises
    ------
    InputError
        If it cannot be read.
    """
    try:
        return path.read_text(encoding="utf-8")
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: cannot be read: it is not UTF-8") from error
