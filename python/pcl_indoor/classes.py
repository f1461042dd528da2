# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""What an object is: its descriptor and its class."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Dict, List, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._call import Points, Reals, is_path, paths_of, scan_of, words


def object_of(
    points: Points, messages: Optional[List[str]], point_normals: Optional[Reals] = None
) -> Union[_core.Scan, str]:
    """One object: of a file, which may be a mesh, the path."""
    if point_normals is None and is_path(points):
        return paths_of(points)[0]
    return scan_of(points, messages, point_normals)


def descriptor(
    points: Points,
    *,
    point_normals: Optional[Reals] = None,
    normal_neighbors: Optional[int] = None,
    preset: Optional[str] = None,
    descriptor: Optional[str] = None,
    pairs: Optional[int] = None,
    scale: Optional[float] = None,
    seed: Optional[int] = None,
    threads: Optional[int] = None,
    bins: Union[str, Sequence[int], None] = None,
    grid_size: Optional[int] = None,
    weighting_constant: Optional[float] = None,
    keep_noise: bool = False,
    surface_angle: Optional[str] = None,
    normal_angle: Optional[str] = None,
    sampling: Optional[str] = None,
    without: Optional[str] = None,
    normals: Optional[str] = None,
    messages: Optional[List[str]] = None,
) -> NDArray[np.float32]:
    """Describe an object by a histogram, as the tool pcl_eppf_estimation does.

    Parameters
    ----------
    points : array, Scan or path
        N x 3 coordinates, float32 or float64, of any strides, read where they lie; NaN where there
        is none; or what :func:`load` gives; or the path of a file.
        The points are of one object, in metres; of a mesh (OFF, OBJ, PLY with faces) points are
        drawn.
    point_normals : array or None
        N x 3, float32 or float64, unit length: normals that the points have.
    normal_neighbors : number
        neighbours of a normal, where the file has no normals, points, at least 3 (default: 20)
    preset : default|thesis
        thesis: -descriptor eppf, the descriptor of the thesis (default: default)
    descriptor : pair_harmonics|eppf|eppf_short
        what tells most, or EPPF as in the thesis, or its short form (default: pair_harmonics)
    pairs : number
        point pairs drawn per object, from 1 to 4294967295 (default: 20000)
    scale : number
        length the distance bins spread over; 0: each object's own extent, m, at least 0 (default:
        0)
    seed : number
        the same seed draws the same pairs (default: 5489)
    threads : number
        threads; 0: all of the machine (default: 1)
    bins : text
        bins of distance, surface angle, normal angle, occupancy; shells and degree of harmonics,
        distances from the middle (default: default)
    grid_size : number
        edge of the occupancy grid, 2 to 64; 0: from the number of points; -1: the descriptor's own,
        voxels, from -1 to 64 (default: -1)
    weighting_constant : number
        larger gives near pairs more weight, greater than 1 (default: 1.2)
    keep_noise : flag
        do not measure and lower the noise of points
    surface_angle : joint|maximum|minimum|mean|random|both|default
        how two angles become one (default: default)
    normal_angle : between|around_line|default
        which angle two normals have (default: default)
    sampling : uniform|stratified|default
        how pairs are chosen (default: default)
    without : none|distance|surface_angle|normal_angle|occupancy|harmonics
        a feature to leave out (default: none)
    normals : outward|given|ignored|mostly_outward|default
        the side of a surface they point to (default: default)
    messages : list or None
        Gets what is odd, a line each; without it, the lines are warnings (PclIndoorWarning).

    Returns
    -------
    array
        1200 values (540 of eppf_short), float32, at least 0, with the sum 1.

    Raises
    ------
    InputError
        A ValueError: what is given cannot be used, one line as the tool says it.
    """
    options = {
        "normal_neighbors": normal_neighbors,
        "preset": preset,
        "descriptor": descriptor,
        "pairs": pairs,
        "scale": scale,
        "seed": seed,
        "threads": threads,
        "bins": bins,
        "grid_size": grid_size,
        "weighting_constant": weighting_constant,
        "keep_noise": keep_noise,
        "surface_angle": surface_angle,
        "normal_angle": normal_angle,
        "sampling": sampling,
        "without": without,
        "normals": normals,
    }
    return _core.descriptor(object_of(points, messages, point_normals), words(options))


@dataclass(frozen=True)
class Classification:
    """What an object was taken for."""

    #: The likeliest class; empty if the object cannot be described.
    name: str
    #: Its probability.
    confidence: float
    #: Of all classes above 0, the likeliest first.
    probabilities: Dict[str, float]


def classify(
    objects: Sequence[Points],
    *,
    floor_distances: Optional[Sequence[Optional[float]]] = None,
    model: Union[str, "os.PathLike[str]"] = "bundled",
    threads: Optional[int] = None,
    normal_neighbors: Optional[int] = None,
    messages: Optional[List[str]] = None,
) -> List[Classification]:
    """Name the classes of objects, as the tool pcl_eppf_classify does.

    Parameters
    ----------
    objects : list of arrays, Scans or paths
        Each is one object: N x 3, float32 or float64, metres, z up; or what :func:`load` gives; or
        the path of a cloud or a mesh.
    floor_distances : list or None
        How far the lowest point of each object is above the floor, metres; None where that is not
        known. The bundled model knows more with it.
    model : text or path
        File of a classifier that pcl_eppf_train has made; bundled = furniture, doors and windows
        (default: bundled)
    threads : number
        threads; 0: all of the machine (default: 0)
    normal_neighbors : number
        neighbours of a normal, where a file has no normals, points, at least 3 (default: 20)
    messages : list or None
        Gets what is odd, a line each; without it, the lines are warnings (PclIndoorWarning).

    Returns
    -------
    list of Classification
        One per object.

    Raises
    ------
    InputError
        A ValueError: what is given cannot be used, one line as the tool says it.
    """
    if isinstance(objects, (np.ndarray, _core.Scan, str, os.PathLike)):
        raise _core.InputError("objects: give a list of objects, also of one")
    distances: Sequence[Optional[float]] = (
        [None] * len(objects) if floor_distances is None else floor_distances
    )
    if len(distances) != len(objects):
        raise _core.InputError(
            f"floor_distances: there are {len(distances)} for {len(objects)} objects"
        )
    options = {
        "model": model,
        "threads": threads,
        "normal_neighbors": normal_neighbors,
    }
    inputs = [(object_of(one, messages), distance) for one, distance in zip(objects, distances)]
    names, found = _core.classify(inputs, words(options))
    return [classification(names, probabilities) for probabilities in found]


def classification(names: Sequence[str], probabilities: Sequence[float]) -> Classification:
    """The probabilities of one object with their names."""
    pairs: List[Tuple[str, float]] = sorted(zip(names, probabilities), key=lambda pair: -pair[1])
    likely = {name: probability for name, probability in pairs if probability > 0}
    name, confidence = next(iter(likely.items()), ("", 0.0))
    return Classification(name, confidence, likely)
