# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""How functions of this package call the library: scans of arrays, options, warnings."""

from __future__ import annotations

import numbers
import os
import sys
import warnings
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from . import _core

#: N x 3 numbers.
Reals = Union[NDArray[np.float32], NDArray[np.float64]]
#: What a scan may be given as: N x 3 floats, what load() gives, or the path of a file.
Points = Union[Reals, Sequence[Sequence[float]], "_core.Scan", str, "os.PathLike[str]"]
#: Is told the stage, and that ``done`` of ``all`` parts of it are done.
Progress = Callable[[str, int, int], None]


class PclIndoorWarning(UserWarning):
    """What is odd about a scan and how it was taken, one line as the tools say it."""


def tell(lines: Sequence[str], messages: Optional[List[str]]) -> None:
    """Add lines to the list, or warn of them where there is none."""
    if messages is not None:
        messages.extend(lines)
        return
    level, frame = 2, sys._getframe(1)
    while frame.f_back and frame.f_globals.get("__name__", "").split(".")[0] == __package__:
        level, frame = level + 1, frame.f_back  # up to who called the package
    for line in lines:
        warnings.warn(line, PclIndoorWarning, stacklevel=level)


def words(options: Dict[str, Any]) -> List[str]:
    """Options as the tools' command lines have them; those that are None keep their default."""
    listed: List[str] = []
    for name, value in options.items():
        if value is None or value is False:
            continue
        listed.append("-" + name)
        if value is not True:
            listed.append(word(value))
    return listed


def word(value: Any) -> str:
    """One value as text: numbers so that they are read back as they are, several with commas."""
    if isinstance(value, str):
        return value
    if isinstance(value, os.PathLike):
        return str(os.fspath(value))
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    if isinstance(value, (list, tuple, np.ndarray)):
        return ",".join(word(part) for part in value)
    return str(value)


def is_path(points: Any) -> bool:
    """Is it the name of a file?"""
    return isinstance(points, (str, os.PathLike))


def paths_of(path: Any) -> List[str]:
    """The names of one file or of several."""
    return [os.fspath(one) for one in ([path] if is_path(path) else path)]


def place(name: str, value: Optional[Sequence[float]]) -> Tuple[float, float, float]:
    """Three finite numbers; the origin for None."""
    if value is None:
        return (0.0, 0.0, 0.0)
    numbers_of = [float(part) for part in value]
    if len(numbers_of) != 3 or not np.isfinite(numbers_of).all():
        raise _core.InputError(f"{name}: {value} is no place, three finite numbers are needed")
    return (numbers_of[0], numbers_of[1], numbers_of[2])


def refuse_arrays(*arrays: Any) -> None:
    """None may be given for points that have their own."""
    if any(array is not None for array in arrays):
        raise _core.InputError(
            "point_normals, point_colors and viewpoint go with an array of points, "
            "a file has its own"
        )


def stations_of(stations: Union[str, "os.PathLike[str]", None], is_ignored: bool) -> List[str]:
    """What is said of the places where the scanner stood."""
    return words({"stations": stations, "ignore_stations": is_ignored})


def scan_of(
    points: Points,
    messages: Optional[List[str]],
    point_normals: Optional[Reals] = None,
    point_colors: Optional[NDArray[np.uint8]] = None,
    viewpoint: Optional[Sequence[float]] = None,
    stations: Sequence[str] = (),
) -> _core.Scan:
    """The scan that a function was given; what is said of stations as stations_of() has it."""
    if isinstance(points, _core.Scan) or is_path(points):
        refuse_arrays(point_normals, point_colors, viewpoint)
    if isinstance(points, _core.Scan):
        if stations:
            raise _core.InputError(f"{stations[0][1:]} goes with load() where that was used")
        return points
    if is_path(points):
        scan = _core.load(paths_of(points), [*words({"points_at_once": 0}), *stations])
    else:
        scan = _core.scan_of(
            np.asarray(points),
            None if point_normals is None else np.asarray(point_normals),
            None if point_colors is None else np.asarray(point_colors),
            place("viewpoint", viewpoint),
            stations,
        )
    tell([f"{scan.name}: {note}" for note in scan.notes], messages)
    return scan
