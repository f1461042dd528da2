# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Scans in files."""

from __future__ import annotations

import os
from typing import List, Optional, Sequence, Union

from . import _core
from ._call import paths_of, stations_of, tell, words


def load(
    path: Union[str, "os.PathLike[str]", Sequence[Union[str, "os.PathLike[str]"]]],
    *,
    columns: Optional[str] = None,
    stations: Union[str, "os.PathLike[str]", None] = None,
    ignore_stations: bool = False,
    messages: Optional[List[str]] = None,
) -> _core.Scan:
    """Read the scan of a building, or of an object, whole.

    Parameters
    ----------
    path : path or list of paths
        PCD, PLY, LAS, LAZ, E57, PTX, a table of numbers (XYZ, CSV, PTS) or a mesh, packed or not;
        a folder of them, or several, are the stations of one building.
    columns : text
        columns of a table (XYZ, CSV, PTS), such as x,y,z,_,r,g,b, of which _ is left out; without,
        as its header says, or by their number (default: none)
    stations : text
        file with the positions of the scanner, x y z in each line, in frame and unit of the scan;
        without, as E57, PTX and VIEWPOINT of several files tell them (default: none)
    ignore_stations : flag
        do as if it were not known where the scanner stood
    messages : list or None
        Gets what is odd, a line each; without it, the lines are warnings (PclIndoorWarning).

    Returns
    -------
    Scan
        Its points (N x 3, float32, minus offset), fields, normals, colors, offset and stations.

    Raises
    ------
    InputError
        A ValueError: there is no such file, or it is no scan or damaged, one line as the tools
        say it.
    """
    reading = words({"columns": columns, "points_at_once": 0})
    scan = _core.load(paths_of(path), [*reading, *stations_of(stations, ignore_stations)])
    tell([f"{scan.name}: {note}" for note in scan.notes], messages)
    return scan
