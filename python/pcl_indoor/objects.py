# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Objects of a room, and what they are found from."""

from __future__ import annotations

import os
from typing import Any, List, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._call import Points, Reals, scan_of, stations_of, tell, words


def fill(name: str, array: Optional[NDArray[Any]], values: NDArray[Any]) -> None:
    """Copy values into the array that was given for them, if one was."""
    if array is None:
        return
    if array.shape != values.shape or array.dtype != values.dtype:
        raise _core.InputError(
            f"{name}: the array is {array.shape} of {array.dtype}, "
            f"it must be {values.shape} of {values.dtype}"
        )
    array[...] = values


def segment_objects(
    points: Points,
    *,
    point_normals: Optional[Reals] = None,
    point_colors: Optional[NDArray[np.uint8]] = None,
    viewpoint: Optional[Sequence[float]] = None,
    preset: Optional[str] = None,
    voxel_resolution: Optional[float] = None,
    seed_resolution: Optional[float] = None,
    partition: Optional[str] = None,
    level: Optional[float] = None,
    ignore_normals: bool = False,
    remove_outliers: bool = False,
    threads: Optional[int] = None,
    unit: Optional[str] = None,
    up: Union[str, Sequence[float], None] = None,
    ransac_share: Optional[float] = None,
    removal_radius: Optional[float] = None,
    spatial_weight: Optional[float] = None,
    normal_weight: Optional[float] = None,
    colour_weight: Optional[float] = None,
    fpfh_weight: Optional[float] = None,
    min_segment: Optional[int] = None,
    min_points: Optional[int] = None,
    graph_scale: Optional[float] = None,
    concavity_tolerance: Optional[float] = None,
    curvature_threshold: Optional[float] = None,
    ratio_threshold: Optional[float] = None,
    camera: Optional[str] = None,
    orientation: Optional[str] = None,
    structure: Optional[NDArray[np.uint32]] = None,
    messages: Optional[List[str]] = None,
) -> NDArray[np.uint32]:
    """Find the objects of a room's scan, as the tool pcl_noise_resilient_lccp does.

    For a building with several rooms there is :func:`describe`.

    Parameters
    ----------
    points : array, Scan or path
        N x 3 coordinates, float32 or float64, of any strides, read where they lie; NaN where there
        is none; or what :func:`load` gives; or the path of a file.
    point_normals : array or None
        N x 3, float32 or float64, unit length: normals that the points have.
    point_colors : array or None
        N x 3, uint8: red, green, blue of the points.
    viewpoint : three numbers or None
        Where the scanner stood, in the coordinates of the points; None is their origin.
    preset : auto|objects|parts|single_view|thesis|thesis_kinect
        what is wanted; objects: whole ones in a room; parts: seats, backs and arms apart;
        single_view: a table with small objects; thesis, thesis_kinect: the method of the thesis with
        its parameters for laser scans or the Kinect, and no more; auto: single_view if one camera
        saw a table, at most 1.4 m away, up to 2 m if most of it is small, or if all is within 0.7 m
        of height and 1.5 m across; else objects (default: auto)
    voxel_resolution : number
        edge of a voxel; 0 = 0.03 for rooms, 0.005 for a single view, the former raised for sparse
        scans, m, at least 0 (default: 0)
    seed_resolution : number
        distance of supervoxels; 0 = 0.12 for rooms, 0.02 for a single view, and if only one of the
        two is given, a seed is four voxels, m, at least 0 (default: 0)
    partition : auto|graph|felzenszwalb|lccp
        how supervoxels are joined: by whole borders to pieces, and these by what was learned, by
        the thesis's graph segmentation, or over all convex edges; auto: graph, for the thesis's
        presets felzenszwalb (default: auto)
    level : number
        for -partition graph: probability of being one object from which pieces are joined; higher
        gives smaller segments; -1 = where that gives whole objects, in single views 0.9, from -1 to
        1 (default: -1)
    ignore_normals : flag
        estimate normals although the input has some
    remove_outliers : flag
        leave out points that lie alone (pcl::ScanOutlierRemoval); their object is 0
    threads : number
        threads, 0 = automatic (default: 0)
    unit : m|cm|mm|ft|in
        unit of the coordinates; lengths of options are in metres (default: m)
    up : auto|x|y|z|-x|-y|-z
        axis that points up, or a direction such as 0.1,0,0.99; auto: as floors, ceilings and walls
        tell it (default: auto)
    ransac_share : number
        for the thesis's presets: planes of at least this share of all points are taken off by
        RANSAC, as floor, walls and ceiling; 0 = none, from 0 to 1 (default: 0)
    removal_radius : number
        for the thesis's presets: neighbourhood of normals and of the points that are counted; 0 =
        2.5 times the distance of points, m, at least 0 (default: 0)
    spatial_weight : number
        weight of distance, over the distance of supervoxels, from 0 to 1000000 (default: 0.2)
    normal_weight : number
        weight of the difference of normals, 0 to 1, from 0 to 1000000 (default: 0.5)
    colour_weight : number
        for the thesis's presets: weight of the difference of colours (CIELab), 1 for black and
        white; needs points with colours, from 0 to 1000000 (default: 0)
    fpfh_weight : number
        for the thesis's presets: weight of the difference of FPFH, 0 to 1, from 0 to 1000000
        (default: 0)
    min_segment : number
        smallest segment; 0 = 4 for rooms, 6 for a single view, supervoxels, at least 0 (default: 0)
    min_points : number
        for -partition graph: segments of fewer points, or smaller than a supervoxel, are the
        remainder, points (default: 100)
    graph_scale : number
        for -partition felzenszwalb; higher gives larger segments, at least 0 (default: 3)
    concavity_tolerance : number
        for -partition felzenszwalb and lccp: bend up to which concave edges count as convex,
        degrees, from 0 to 180 (default: 10)
    curvature_threshold : number
        curvature above which points are taken out if not convex, from 0 to 0.3333333333333333
        (default: 0.03)
    ratio_threshold : number
        ratio of points in front of and behind the surface that is not convex, from 0 to 1 (default:
        0.2)
    camera : auto|single|none
        voxels grow with the distance from one camera along z or -z; auto: if the input is the view
        of a table (default: auto)
    orientation : auto|viewpoint|graph|free_space
        which way estimated normals are turned: to the file's sensor origin, as their neighbours, or
        to the free space; auto: viewpoint for one camera, else free_space (default: auto)
    structure : array or None
        N, uint32, gets what of the building each point is: 1 floor, 2 wall, 3 ceiling, 4 remainder
        (too small to be told), 0 anything else.
    messages : list or None
        Gets what is odd, a line each; without it, the lines are warnings (PclIndoorWarning).

    Returns
    -------
    array
        N, uint32: the object of each point, 1 ... n; 0 = not finite, an outlier or of none.

    Raises
    ------
    InputError
        A ValueError: what is given cannot be used, one line as the tool says it.
    """
    scan = scan_of(points, messages, point_normals, point_colors, viewpoint)
    options = {
        "preset": preset,
        "voxel_resolution": voxel_resolution,
        "seed_resolution": seed_resolution,
        "partition": partition,
        "level": level,
        "ignore_normals": ignore_normals,
        "remove_outliers": remove_outliers,
        "threads": threads,
        "unit": unit,
        "up": up,
        "ransac_share": ransac_share,
        "removal_radius": removal_radius,
        "spatial_weight": spatial_weight,
        "normal_weight": normal_weight,
        "colour_weight": colour_weight,
        "fpfh_weight": fpfh_weight,
        "min_segment": min_segment,
        "min_points": min_points,
        "graph_scale": graph_scale,
        "concavity_tolerance": concavity_tolerance,
        "curvature_threshold": curvature_threshold,
        "ratio_threshold": ratio_threshold,
        "camera": camera,
        "orientation": orientation,
    }
    objects, structures, lines = _core.segment_objects(scan, words(options))
    tell(lines, messages)
    fill("structure", structure, structures)
    return objects


def estimate_normals(
    points: Points,
    *,
    viewpoint: Optional[Sequence[float]] = None,
    radius: Optional[float] = None,
    k: Optional[int] = None,
    stations: Union[str, "os.PathLike[str]", None] = None,
    ignore_stations: bool = False,
    orientation: Optional[str] = None,
    threads: Optional[int] = None,
    sampling: Optional[str] = None,
    bin_angle: Optional[float] = None,
    triples: Optional[int] = None,
    no_refinement: bool = False,
    seed: Optional[int] = None,
    curvature: Optional[NDArray[np.float32]] = None,
    messages: Optional[List[str]] = None,
) -> NDArray[np.float32]:
    """Estimate normals that stay sharp at edges, as the tool pcl_hough_normals does.

    Parameters
    ----------
    points : array, Scan or path
        N x 3 coordinates, float32 or float64, of any strides, read where they lie; NaN where there
        is none; or what :func:`load` gives; or the path of a file.
    viewpoint : three numbers or None
        Where the scanner stood, in the coordinates of the points; None is their origin.
    radius : number
        of the neighbourhood; 0 = from the resolution of the cloud, m, at least 0 (default: 0)
    k : number
        neighbours instead of a radius; 0 = by radius, points, at least 0 (default: 0)
    stations : text
        file with the positions of the scanner, x y z in each line, in frame and unit of the scan;
        without, as E57, PTX and VIEWPOINT of several files tell them (default: none)
    ignore_stations : flag
        do as if it were not known where the scanner stood
    orientation : viewpoint|graph|free_space
        which way normals are turned: to the station that measured the point, or the file's sensor
        origin where that is not known, as their neighbours, or to the free space between the
        surfaces (default: viewpoint)
    threads : number
        threads, 0 = automatic (default: 0)
    sampling : cubes|points
        how triples of neighbours are picked; cubes: evenly where density varies (default: cubes)
    bin_angle : number
        size of a bin of the accumulators, degrees, from 1 to 45 (default: 12)
    triples : number
        largest number of triples per point; 0 = from the confidence bounds (default: 0)
    no_refinement : flag
        take the mean of the votes instead of fitting a plane
    seed : number
        seed of the triples (default: 5489)
    curvature : array or None
        N, float32, gets the curvature at each point, 0 to 1/3.
    messages : list or None
        Gets what is odd, a line each; without it, the lines are warnings (PclIndoorWarning).

    Returns
    -------
    array
        N x 3, float32, unit length; NaN where no plane was found.

    Raises
    ------
    InputError
        A ValueError: what is given cannot be used, one line as the tool says it.
    """
    said = stations_of(stations, ignore_stations)
    scan = scan_of(points, messages, viewpoint=viewpoint, stations=said)
    options = {
        "radius": radius,
        "k": k,
        "orientation": orientation,
        "threads": threads,
        "sampling": sampling,
        "bin_angle": bin_angle,
        "triples": triples,
        "no_refinement": no_refinement,
        "seed": seed,
    }
    normals, curvatures = _core.estimate_normals(scan, words(options))
    fill("curvature", curvature, curvatures)
    return normals
