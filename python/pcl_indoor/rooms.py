# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Rooms of a building."""

from __future__ import annotations

import os
from typing import List, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._call import Points, Progress, scan_of, stations_of, tell, words


def segment_rooms(
    points: Points,
    *,
    preset: Optional[str] = None,
    voxel_size: Optional[float] = None,
    min_area: Optional[float] = None,
    threads: Optional[int] = None,
    stations: Union[str, "os.PathLike[str]", None] = None,
    ignore_stations: bool = False,
    unit: Optional[str] = None,
    up: Union[str, Sequence[float], None] = None,
    min_width: Optional[float] = None,
    persistence: Optional[float] = None,
    open_share: Optional[float] = None,
    habitable_area: Optional[float] = None,
    method: Optional[str] = None,
    interior_voxel_size: Optional[float] = None,
    euclidean_weight: Optional[float] = None,
    field_weight: Optional[float] = None,
    visibility_weight: Optional[float] = None,
    min_cluster_area: Optional[float] = None,
    sample_area: Optional[float] = None,
    landmark_spacing: Optional[float] = None,
    single_cluster: bool = False,
    dbscan_distance: Optional[float] = None,
    floor_weight: Optional[float] = None,
    ceiling_weight: Optional[float] = None,
    height_weight: Optional[float] = None,
    wall_weight: Optional[float] = None,
    exterior_weight: Optional[float] = None,
    progress: Optional[Progress] = None,
    messages: Optional[List[str]] = None,
) -> NDArray[np.uint32]:
    """Find the rooms of a building's scan, as the tool pcl_room_segmentation does.

    Parameters
    ----------
    points : array, Scan or path
        N x 3 coordinates, float32 or float64, of any strides, read where they lie; NaN where there
        is none; or what :func:`load` gives; or the path of a file.
    preset : default|thesis
        thesis: the method of the thesis with its parameters, and no more; the other options start
        from it (default: default)
    voxel_size : number
        side of a voxel, 0 = automatic: 0.1, more where surfaces have holes, m, at least 0 (default:
        0)
    min_area : number
        smallest room, m^2, at least 0 (default: 0.5)
    threads : number
        threads, 0 = automatic, at least 0 (default: 0)
    stations : text
        file with the positions of the scanner, x y z in each line, in frame and unit of the scan;
        without, as E57, PTX and VIEWPOINT of several files tell them (default: none)
    ignore_stations : flag
        do as if it were not known where the scanner stood
    unit : auto|m|cm|mm|ft|in
        unit of the coordinates; lengths of options and areas are in metres; auto: metres, but where
        rooms would be higher than 50 m (default: auto)
    up : auto|x|y|z|-x|-y|-z
        axis that points up, or a direction such as 0.1,0,0.99; auto: as floors, ceilings and walls
        tell it (default: auto)
    min_width : number
        narrowest room, m, at least 0 (default: 0.5)
    persistence : number
        widest passage between rooms, as share of the narrower one's width, from 0 to 1 (default:
        0.5)
    open_share : number
        most open border between rooms, as share of its area, from 0 to 1 (default: 0.55)
    habitable_area : number
        smallest room of an open plan, without a door to the next, m^2, at least 0 (default: 6.5)
    method : slab|field
        slab: walls below the ceiling; field: potential field and HDBSCAN, as in the thesis
        (default: slab)
    interior_voxel_size : number
        side of a voxel of the interior space and of -method field, rounded to a multiple of
        -voxel_size, m, greater than 0 (default: 0.2)
    euclidean_weight : number
        field: weight of the Euclidean distance; 0 = much slower, at least 0 (default: 0.7)
    field_weight : number
        field: weight of the distance through the potential field, at least 0 (default: 0.25)
    visibility_weight : number
        field: weight of the difference of what is visible, at least 0 (default: 0.05)
    min_cluster_area : number
        field: smallest cluster, m^2, greater than 0 (default: 2)
    sample_area : number
        field: neighbourhood of a pixel's core distance; larger leaves out more pixels, m^2, greater
        than 0 (default: 0.4)
    landmark_spacing : number
        field: between the places that visibility looks for; 0 = every pixel, m, at least 0
        (default: 1)
    single_cluster : flag
        field: HDBSCAN may find one room only
    dbscan_distance : number
        field: 0 = HDBSCAN; else DBSCAN* with this weighted distance, at least 0 (default: 0)
    floor_weight : number
        evidence for the interior: something below (w1 of the thesis), from 0 to 80 (default: 1.5)
    ceiling_weight : number
        the same: something above (w2), from 0 to 80 (default: 0.5)
    height_weight : number
        the same: both (w3), from 0 to 80 (default: 0.5)
    wall_weight : number
        the same: on both sides in all directions of the walls (w4 + w5), from 0 to 80 (default: 1)
    exterior_weight : number
        evidence for the exterior, from 0 to 80 (default: 1.5)
    progress : callable or None
        Is called with a stage, done and all while it works; what it raises ends the work.
    messages : list or None
        Gets what is odd, a line each; without it, the lines are warnings (PclIndoorWarning).

    Returns
    -------
    array
        N, uint32: the room of each point, 1 ... n; 0 = none.

    Raises
    ------
    InputError
        A ValueError: what is given cannot be used, one line as the tool says it.
    """
    scan = scan_of(points, messages, stations=stations_of(stations, ignore_stations))
    options = {
        "preset": preset,
        "voxel_size": voxel_size,
        "min_area": min_area,
        "threads": threads,
        "unit": unit,
        "up": up,
        "min_width": min_width,
        "persistence": persistence,
        "open_share": open_share,
        "habitable_area": habitable_area,
        "method": method,
        "interior_voxel_size": interior_voxel_size,
        "euclidean_weight": euclidean_weight,
        "field_weight": field_weight,
        "visibility_weight": visibility_weight,
        "min_cluster_area": min_cluster_area,
        "sample_area": sample_area,
        "landmark_spacing": landmark_spacing,
        "single_cluster": single_cluster,
        "dbscan_distance": dbscan_distance,
        "floor_weight": floor_weight,
        "ceiling_weight": ceiling_weight,
        "height_weight": height_weight,
        "wall_weight": wall_weight,
        "exterior_weight": exterior_weight,
    }
    rooms, lines = _core.segment_rooms(scan, words(options), progress)
    tell(lines, messages)
    return rooms
