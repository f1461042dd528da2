# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Buildings: their rooms, walls, openings and objects, as scene.json has them."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union, cast

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._call import (
    Points,
    Progress,
    Reals,
    is_path,
    paths_of,
    refuse_arrays,
    scan_of,
    stations_of,
    tell,
    words,
)

Position = Tuple[float, float, float]
Path = Union[str, "os.PathLike[str]"]
Labels = NDArray[np.uint32]


@dataclass(frozen=True)
class Box:
    """A box along the axes of the file: two corners, in the frame and unit of the file."""

    lower: Position
    upper: Position


@dataclass(frozen=True)
class UprightBox:
    """The box of the least ground area that stands along gravity."""

    center: Position  #: in the frame and unit of the file
    size: Position  #: length >= width, and height, metres
    yaw_degrees: float  #: of the length, counter-clockwise seen from above from axes["x"]


@dataclass(frozen=True)
class Storey:
    """A storey; 0 is the lowest."""

    number: int
    floor: float  #: height of its floor along the up axis, metres
    ceiling: float  #: height of its ceiling, metres
    area: float  #: of its rooms, m^2
    rooms: Tuple[int, ...]  #: their numbers


@dataclass(frozen=True)
class Neighbour:
    """A room that a person can pass to."""

    room: int
    position: Position  #: middle of the opening, on the floor
    width: float  #: metres
    area: float  #: m^2


@dataclass(frozen=True)
class Room:
    """A room; its number is that of its points in Scene.room_of_point."""

    number: int
    storey: int
    name: str  #: what it is for, such as kitchen, or unknown
    name_probability: float  #: 0 to 1
    name_top: Tuple[Tuple[str, float], ...]  #: the likeliest, the first first
    points: int
    box: Optional[Box]  #: None without points
    centroid: Optional[Position]
    area: float  #: of the floor inside the walls, m^2
    height: float  #: volume over area, metres
    volume: float  #: m^3
    seen: float  #: share of its border that was seen, 0 to 1
    floor_seen: float  #: share of the area, 0 to 1
    ceiling_seen: float  #: share of the area, 0 to 1
    footprint: Tuple[Tuple[Position, ...], ...]  #: closed lines on the floor, holes clockwise
    neighbours: Tuple[Neighbour, ...]
    voxel_resolution: float  #: edge of a voxel of its objects, metres
    seed_resolution: float  #: distance of supervoxels, metres
    remainder: int  #: points of no object
    objects: Tuple[int, ...]  #: their numbers


@dataclass(frozen=True)
class Wall:
    """A straight piece of wall."""

    number: int
    storey: int
    rooms: Tuple[int, ...]  #: that it bounds
    begin: Position  #: of its axis, at its foot; of one side if only that was seen
    end: Position
    height: float  #: metres
    thickness: Optional[float]  #: metres; None if only one side was seen


@dataclass(frozen=True)
class Column:
    """What stands in a room from its floor to its ceiling and is no wall."""

    number: int
    storey: int
    room: int  #: that it stands in
    position: Position  #: middle of its foot
    size: Position  #: length >= width, and height, metres; of a round one two diameters
    yaw_degrees: float  #: of the length, counter-clockwise seen from above from axes["x"]
    round: bool


@dataclass(frozen=True)
class Opening:
    """A door, a window or a passage."""

    number: int
    kind: str  #: door, window or passage
    rooms: Tuple[int, int]  #: 0 = outside, or not seen
    storey: int
    position: Position  #: middle of the lower edge
    width: float  #: metres
    height: float  #: metres
    sill: float  #: lower edge above the floor, metres
    head: float  #: upper edge above the floor, metres
    area: float  #: m^2
    open: bool  #: a person can pass, as it was scanned
    wall: Optional[int]  #: that it is in


@dataclass(frozen=True)
class SceneObject:
    """An object, or a floor, wall or ceiling; its number is that in Scene.object_of_point."""

    number: int
    room: int  #: 0 = none
    storey: Optional[int]  #: None without a room
    structure: str  #: floor, wall, ceiling, or none: an object
    name: Optional[str]  #: of its class; None without a model
    confidence: float  #: of the class, 0 to 1
    top: Tuple[Tuple[str, float], ...]  #: up to three classes, the likeliest first
    points: int
    box: Box
    centroid: Position
    upright_box: UprightBox


class Scene:
    """What was found in the scan of a building.

    Positions are in the frame and unit of the file; lengths, areas and volumes in metres, m^2
    and m^3.

    Attributes
    ----------
    storeys, rooms, walls, columns, openings, objects : lists
        Of Storey, Room, Wall, Column, Opening and SceneObject. Room and object k are at place k - 1.
    room_of_point, object_of_point, structure_of_point : arrays or None
        N, uint32, in the order of the points; 0 = none. Structure is 1 floor, 2 wall, 3 ceiling, 4
        remainder (too small to be an object). None of scenes that were read from a file, and of
        scans that are read in parts.
    categories : list
        Names of the classes by number, the first is "none"; empty without a model.
    warnings : list
        What was odd, a line each.
    """

    def __init__(
        self,
        text: str,
        room_of_point: Optional[Labels] = None,
        object_of_point: Optional[Labels] = None,
        structure_of_point: Optional[Labels] = None,
    ) -> None:
        self._text = text
        found = json.loads(text)
        self.storeys: List[Storey] = [_storey(one) for one in found["storeys"]]
        self.rooms: List[Room] = [_room(one) for one in found["rooms"]]
        self.walls: List[Wall] = [_wall(one) for one in found.get("walls", [])]
        self.columns: List[Column] = [_column(one) for one in found.get("columns", [])]
        self.openings: List[Opening] = [_opening(one) for one in found.get("openings", [])]
        self.objects: List[SceneObject] = [_object(one) for one in found["objects"]]
        self.categories: List[str] = found.get("categories", [])
        self.warnings: List[str] = found["warnings"]
        self.room_of_point = room_of_point
        self.object_of_point = object_of_point
        self.structure_of_point = structure_of_point

    def __repr__(self) -> str:
        return (
            f"<pcl_indoor.Scene: {len(self.storeys)} storeys, {len(self.rooms)} rooms, "
            f"{len(self.objects)} objects>"
        )

    def to_dict(self) -> Dict[str, Any]:
        """The scene as scene.json has it (docs/guide/scene.md)."""
        scene: Dict[str, Any] = json.loads(self._text)
        return scene

    @property
    def category_of_point(self) -> Optional[Labels]:
        """N, uint32: the class of each point's object, a place in categories; None without labels
        or a model."""
        if self.object_of_point is None or not self.categories:
            return None
        number = {name: k for k, name in enumerate(self.categories)}
        of_object = [0] + [number[one.name or "none"] for one in self.objects]
        return np.array(of_object, dtype=np.uint32)[self.object_of_point]

    def save(
        self,
        path: Path,
        *,
        epsg: Optional[int] = None,
        resolution: Optional[float] = None,
    ) -> None:
        """Write it to a file, whole or not at all.

        Parameters
        ----------
        path : path
            Its ending says the format: .json as pcl_indoor_pipeline writes it; as pcl_indoor_export
            has them .ifc, .glb, .geojson, .dxf, .svg, and .pgm for maps and route graphs.
        epsg : number
            EPSG code of the coordinate system of the scan, 0 = not known; for .ifc and .geojson,
            from 0 to 1000000 (default: 0)
        resolution : number
            side of a cell of the maps, m, from 0.005 to 1 (default: 0.05)

        Raises
        ------
        InputError
            A ValueError: what is given cannot be used, one line as the tool says it.
        """
        name = os.fspath(path)
        options = {
            "epsg": epsg,
            "resolution": resolution,
        }
        if name.lower().endswith(".json"):
            _core.save_text(name, self._text)
        else:
            _core.export_scene(name, self._text, words(options))


def load_scene(path: Path) -> Scene:
    """Read a scene.json; it has no labels of points.

    Raises
    ------
    InputError
        A ValueError: the file is no whole scene.
    """
    return Scene(_core.read_scene(os.fspath(path)))


def describe(
    points: Union[Points, Sequence[Path]],
    *,
    point_normals: Optional[Reals] = None,
    point_colors: Optional[NDArray[np.uint8]] = None,
    voxel_size: Optional[float] = None,
    min_area: Optional[float] = None,
    model: Union[str, "os.PathLike[str]", None] = None,
    network: Optional[str] = None,
    remove_outliers: bool = False,
    threads: Optional[int] = None,
    columns: Optional[str] = None,
    stations: Union[str, "os.PathLike[str]", None] = None,
    ignore_stations: bool = False,
    unit: Optional[str] = None,
    up: Union[str, Sequence[float], None] = None,
    voxel_resolution: Optional[float] = None,
    seed_resolution: Optional[float] = None,
    preset: Optional[str] = None,
    partition: Optional[str] = None,
    points_at_once: Optional[int] = None,
    ignore_normals: bool = False,
    normals: Optional[str] = None,
    progress: Optional[Progress] = None,
    messages: Optional[List[str]] = None,
) -> Scene:
    """Find rooms, walls, doors, windows and objects of a building, and what the objects are, as the
    tool pcl_indoor_pipeline does.

    Parameters
    ----------
    points : array, Scan or path
        N x 3 coordinates, float32 or float64, of any strides, read where they lie; NaN where there
        is none; or what :func:`load` gives; or the path of a file.
        A folder, or a list of paths, are the stations of one building.
    point_normals : array or None
        N x 3, float32 or float64, unit length: normals that the points have.
    point_colors : array or None
        N x 3, uint8: red, green, blue of the points.
    voxel_size : number
        side of a voxel of the rooms, 0 = automatic: 0.1, more where surfaces have holes, m, at
        least 0 (default: 0)
    min_area : number
        smallest room, m^2, at least 0 (default: 0.5)
    model : text
        file of a classifier that pcl_eppf_train has made; bundled = furniture, doors and windows,
        none = no classes (default: bundled)
    network : auto|all|none
        where a network of voxels votes on what is floor, wall or ceiling, on what is one object and
        on names of the bundled model; auto: in rooms whose ceiling was not seen (default: auto)
    remove_outliers : flag
        leave out points of a room that lie alone (pcl::ScanOutlierRemoval); their object is 0
    threads : number
        threads, 0 = automatic, from 0 to 1024 (default: 0)
    columns : text
        columns of a table (XYZ, CSV, PTS), such as x,y,z,_,r,g,b, of which _ is left out; without,
        as its header says, or by their number (default: none)
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
    voxel_resolution : number
        edge of a voxel of the objects, 0 = automatic: 0.03, more in rooms with sparse points, m, at
        least 0 (default: 0)
    seed_resolution : number
        distance of supervoxels, at least -voxel_resolution, 0 = automatic: four times that, m, at
        least 0 (default: 0)
    preset : default|thesis
        thesis: rooms and objects by the methods of the thesis with their parameters, and no more
        (default: default)
    partition : graph|lccp
        how supervoxels are joined (default: graph)
    points_at_once : number
        scans with more points are read from disk in parts, so memory depends on the largest rooms
        only; 0 = always load all, points (default: 20000000)
    ignore_normals : flag
        estimate normals although there are some
    normals : voxels|rrht|multi_scale
        how normals are estimated where the input has none; voxels: planes of the objects' voxels;
        rrht: Robust Randomized Hough Transform; multi_scale: planes at several scales (default:
        voxels)
    progress : callable or None
        Is called with a stage, done and all while it works; what it raises ends the work.
    messages : list or None
        Gets what is odd, a line each; without it, the lines are warnings (PclIndoorWarning).

    Returns
    -------
    Scene

    Raises
    ------
    InputError
        A ValueError: what is given cannot be used, one line as the tool says it.
    """
    said = stations_of(stations, ignore_stations)
    if is_path(points) or _are_paths(points):
        refuse_arrays(point_normals, point_colors)
        reading = {"columns": columns, "points_at_once": points_at_once}
        scan = _core.load(paths_of(points), [*words(reading), *said])
    else:
        scan = scan_of(cast(Points, points), [], point_normals, point_colors, stations=said)
    options = {
        "voxel_size": voxel_size,
        "min_area": min_area,
        "model": model,
        "network": network,
        "remove_outliers": remove_outliers,
        "threads": threads,
        "unit": unit,
        "up": up,
        "voxel_resolution": voxel_resolution,
        "seed_resolution": seed_resolution,
        "preset": preset,
        "partition": partition,
        "ignore_normals": ignore_normals,
        "normals": normals,
    }
    text, rooms, objects, structure = _core.describe(scan, words(options), progress)
    is_whole = not scan.is_read_in_parts
    scene = Scene(text, *((rooms, objects, structure) if is_whole else ()))
    tell([f"{scan.name}: {line}" for line in scene.warnings], messages)
    return scene


def _are_paths(points: Any) -> bool:
    return isinstance(points, (list, tuple)) and len(points) > 0 and all(map(is_path, points))


def _position(values: Sequence[float]) -> Position:
    return (values[0], values[1], values[2])


def _box(found: Dict[str, Any]) -> Box:
    return Box(_position(found["lower"]), _position(found["upper"]))


def _storey(found: Dict[str, Any]) -> Storey:
    return Storey(
        found["storey"], found["floor"], found["ceiling"], found["area"], tuple(found["rooms"])
    )


def _neighbour(found: Dict[str, Any]) -> Neighbour:
    return Neighbour(found["room"], _position(found["position"]), found["width"], found["area"])


def _room(found: Dict[str, Any]) -> Room:
    has_points = "box" in found
    return Room(
        number=found["room"],
        storey=found["storey"],
        name=found.get("name", "unknown"),
        name_probability=found.get("name_probability", 0.0),
        name_top=tuple((one["name"], one["probability"]) for one in found.get("name_top", [])),
        points=found["points"],
        box=_box(found["box"]) if has_points else None,
        centroid=_position(found["centroid"]) if has_points else None,
        area=found["area"],
        height=found["height"],
        volume=found["volume"],
        seen=found.get("seen", 1.0),
        floor_seen=found.get("floor_seen", 1.0),
        ceiling_seen=found.get("ceiling_seen", 1.0),
        footprint=tuple(tuple(map(_position, line)) for line in found["footprint"]),
        neighbours=tuple(map(_neighbour, found["neighbours"])),
        voxel_resolution=found["voxel_resolution"],
        seed_resolution=found["seed_resolution"],
        remainder=found["remainder"],
        objects=tuple(found["objects"]),
    )


def _wall(found: Dict[str, Any]) -> Wall:
    return Wall(
        number=found["wall"],
        storey=found["storey"],
        rooms=tuple(found["rooms"]),
        begin=_position(found["begin"]),
        end=_position(found["end"]),
        height=found["height"],
        thickness=found.get("thickness"),
    )


def _column(found: Dict[str, Any]) -> Column:
    return Column(
        number=found["column"],
        storey=found["storey"],
        room=found["room"],
        position=_position(found["position"]),
        size=_position(found["size"]),
        yaw_degrees=found["yaw_degrees"],
        round=found["round"],
    )


def _opening(found: Dict[str, Any]) -> Opening:
    return Opening(
        number=found["opening"],
        kind=found["kind"],
        rooms=(found["rooms"][0], found["rooms"][1]),
        storey=found["storey"],
        position=_position(found["position"]),
        width=found["width"],
        height=found["height"],
        sill=found["sill"],
        head=found["head"],
        area=found["area"],
        open=found["open"],
        wall=found.get("wall"),
    )


def _object(found: Dict[str, Any]) -> SceneObject:
    upright = found["upright_box"]
    return SceneObject(
        number=found["object"],
        room=found["room"],
        storey=found.get("storey"),
        structure=found["structure"],
        name=found.get("class"),
        confidence=found.get("confidence", 0.0),
        top=tuple((one["class"], one["confidence"]) for one in found.get("top", [])),
        points=found["points"],
        box=_box(found["box"]),
        centroid=_position(found["centroid"]),
        upright_box=UprightBox(
            _position(upright["center"]), _position(upright["size"]), upright["yaw_degrees"]
        ),
    )
