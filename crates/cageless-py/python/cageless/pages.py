"""Report pages as files."""

from __future__ import annotations

import os
from pathlib import Path

from .errors import CagelessError, InputError

__all__ = ["write"]


def write(path: str | os.PathLike[str], page: str) -> Path:
    """Writes a page.

    Raises
    ------
    InputError
        If there is no such folder, or the path is one.
    CagelessError
        If the system refuses, because the disk is full, say.
    """
    path = Path(path)
    try:
        path.write_text(page, encoding="utf-8")
    except (FileNotFoundError, NotADirectoryError) as error:
        message = f"{path}: the folder {path.parent} is not there; make it first"
        raise InputError(message) from error
    except IsADirectoryError as error:
        raise InputError(f"{path}: is a directory where a file is to be") from error
    except OSError as error:
        raise CagelessError(f"{path}: {error.strerror}") from error
    return path
