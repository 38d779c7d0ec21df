# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The subcommands of the command line: what each is called with, and the recipe that it calls."""

from dataclasses import dataclass
from typing import Callable

import numpy as np

from surfacebooleans.clipping import clip, cut, triangulate_contours
from surfacebooleans.meshes import as_surface, points_of
from surfacebooleans.point_sets import (
    CLOUD_OPERATIONS,
    point_set_boolean,
    point_set_intersection,
    point_set_points,
    point_set_surface,
)
from surfacebooleans.surfaces import boolean, check, distance, distance_field, intersection, split


@dataclass
class Command:
    """A subcommand."""

    name: str
    summary: str  # one line for the list of all
    description: str  # what one wants to know before using it
    files: str  # how many it takes: a key of FILES
    recipe: Callable  # (arguments, meshes, options of all recipes) -> {path or None: result}
    arguments: Callable = lambda parser: None  # adds options to the parser


# The positional arguments; the mark at the end says how many of its kind, as argparse has it.
FILES = {
    "1": ("file",),
    "1..2": ("file", "tool?"),
    "2": ("file", "tool"),
    "1..": ("file", "other*"),
    "2..": ("file", "other+"),
}


# ---- Booleans ----------------------------------------------------------------------------------


def _boolean_arguments(parser):
    parser.add_argument("--curves", metavar="FILE", help="write the curves in which the surfaces meet, too")
    _add_tolerance(parser)


def _boolean(operation, all_are_inputs):
    def recipe(arguments, meshes, common):
        a, b = (meshes, None) if all_are_inputs else (meshes[:1], meshes[1:])
        surface, curves = boolean(a, b, operation, tolerance=arguments.tolerance, curves=True, **common)
        return {arguments.output: surface, arguments.curves: curves}

    return recipe


# ---- curves and distances ----------------------------------------------------------------------


def _curves_arguments(parser):
    parser.add_argument("--split-file", metavar="FILE", help="write the first surface, cut along the curves, too")
    parser.add_argument("--split-tool", metavar="FILE", help="write the second one, too")
    _add_tolerance(parser)


def _curves(arguments, meshes, common):
    results = {arguments.output: intersection(*meshes, tolerance=arguments.tolerance, **common)}
    if len(meshes) == 2 and (arguments.split_file or arguments.split_tool):
        first, second = split(*meshes, tolerance=arguments.tolerance, **common)
        results.update({arguments.split_file: first, arguments.split_tool: second})
    return results


def _sign_arguments(parser):
    parser.add_argument("--unsigned", action="store_true", help="without sign")
    parser.add_argument("--negate", action="store_true", help="positive inside")
    parser.add_argument(
        "--sign",
        choices=("pseudonormal", "winding-number"),
        default="pseudonormal",
        help="what tells inside: the nearest facet (exact for closed surfaces), or how often the surface winds "
        "around a point (for surfaces with holes)",
    )


def _distance_arguments(parser):
    _sign_arguments(parser)
    parser.add_argument(
        "--maximum", type=float, default=0.0, metavar="D", help="farther points get this distance, which saves time"
    )
    parser.add_argument(
        "--nearest", action="store_true", help="add the arrays NearestPoint, NearestCellId and Direction"
    )
    parser.add_argument(
        "--second",
        metavar="FILE",
        help="write the tool with its distances to the first file, too (then also Hausdorff)",
    )


def _distance(arguments, meshes, common):
    options = {"maximum": arguments.maximum, "nearest": arguments.nearest, **_signs(arguments), **common}
    if not arguments.second:
        return {arguments.output: distance(*meshes, **options)}
    first, second = distance(*meshes, second=True, **options)
    return {arguments.output: first, arguments.second: second}


def _signs(arguments):
    return {"signed": not arguments.unsigned, "negate": arguments.negate, "sign": arguments.sign}


def _field_arguments(parser):
    _sign_arguments(parser)
    size = parser.add_mutually_exclusive_group()
    size.add_argument(
        "--dimensions", type=int, nargs=3, default=(64, 64, 64), metavar="N", help="samples along x, y and z (64 64 64)"
    )
    size.add_argument(
        "--spacing", type=float, metavar="D", help="from one sample to the next; 0: 1/100 of the longest side"
    )
    parser.add_argument(
        "--margin", type=float, default=0.1, metavar="SHARE", help="beyond the surface's box, of its longest side (0.1)"
    )
    parser.add_argument(
        "--band", type=float, default=0.0, metavar="D", help="farther samples get this distance, which saves time"
    )


def _field(arguments, meshes, common):
    names = ("dimensions", "spacing", "margin", "band")
    sampling = {name: getattr(arguments, name) for name in names}
    return {arguments.output: distance_field(meshes[0], **sampling, **_signs(arguments), **common)}


def _check_arguments(parser):
    parser.add_argument("--defects", metavar="FILE", help="write the edges and points where something is wrong, too")
    parser.add_argument("--no-self-intersections", action="store_true", help="do not look for these, which saves time")


def _check(arguments, meshes, common):
    surface, defects = check(meshes[0], self_intersections=not arguments.no_self_intersections, **common)
    return {arguments.output: surface, arguments.defects: defects} if arguments.defects else {arguments.output: surface}


# ---- planes ------------------------------------------------------------------------------------


def _clip_arguments(parser):
    parser.add_argument(
        "--plane",
        type=float,
        nargs=6,
        action="append",
        metavar=("OX", "OY", "OZ", "NX", "NY", "NZ"),
        help="origin and normal; kept is what lies where the normal points. May be given several times",
    )
    parser.add_argument(
        "--box",
        type=float,
        nargs=6,
        metavar=("X0", "X1", "Y0", "Y1", "Z0", "Z1"),
        help="keep the inside of this box",
    )
    parser.add_argument("--inside-out", action="store_true", help="keep all the rest instead")
    parser.add_argument("--outline", metavar="FILE", help="write the outlines of the caps, too")
    parser.add_argument("--point-data", action="store_true", help="pass point arrays, and interpolate them")
    _add_tolerance(parser)


def _clip(arguments, meshes, common):
    options = {
        "box": arguments.box,
        "inside_out": arguments.inside_out,
        "pass_point_data": arguments.point_data,
        "tolerance": arguments.tolerance,
        **common,
    }
    if not arguments.outline:
        return {arguments.output: clip(meshes[0], arguments.plane, **options)}
    clipped, outline = clip(meshes[0], arguments.plane, outline=True, **options)
    return {arguments.output: clipped, arguments.outline: outline}


def _cut_arguments(parser):
    parser.add_argument(
        "--plane",
        type=float,
        nargs=6,
        default=(0, 0, 0, 0, 0, 1),
        metavar=("OX", "OY", "OZ", "NX", "NY", "NZ"),
        help="origin and normal of the plane of offset 0 (0 0 0 0 0 1)",
    )
    place = parser.add_mutually_exclusive_group()
    place.add_argument(
        "--offsets",
        type=float,
        nargs="+",
        default=[0.0],
        metavar="D",
        help="planes at these distances along the normal (0)",
    )
    place.add_argument(
        "--count", type=_number_of_planes, metavar="N", help="as many planes, in even steps through the whole surface"
    )
    parser.add_argument("--outlines", action="store_true", help="closed lines instead of triangles")
    _add_tolerance(parser)


def _number_of_planes(word):
    if int(word) < 1:
        raise ValueError
    return int(word)


_number_of_planes.__name__ = "number of planes"  # as argparse calls it


def _cut(arguments, meshes, common):
    origin, normal = arguments.plane[:3], arguments.plane[3:]
    surface = as_surface(meshes[0])
    offsets = arguments.offsets if arguments.count is None else _even_offsets(surface, origin, normal, arguments.count)
    outlines, tolerance = arguments.outlines, arguments.tolerance
    return {
        arguments.output: cut(
            surface, origin, normal, offsets=offsets, outlines=outlines, tolerance=tolerance, **common
        )
    }


def _even_offsets(surface, origin, normal, count):
    """The middles of as many slices of equal thickness."""
    heights = (points_of(surface) - origin) @ (normal / np.linalg.norm(normal))
    low, high = heights.min(), heights.max()
    return low + (high - low) * (np.arange(count) + 0.5) / count


def _fill(arguments, meshes, common):
    return {arguments.output: triangulate_contours(meshes[0], progress=common["progress"])}


# ---- points ------------------------------------------------------------------------------------


def _cloud_arguments(parser):
    parser.add_argument(
        "--width", type=float, default=0.0, metavar="H", help="detail smaller than this is noise (3.15 spacings)"
    )
    parser.add_argument("--flip", action="store_true", help="turn all normals over")


def _points_arguments(parser):
    _cloud_arguments(parser)
    parser.add_argument("--keep-places", action="store_true", help="only add the arrays, do not move the points")


def _points(arguments, meshes, common):
    options = {"project": not arguments.keep_places, "width": arguments.width, "flip": arguments.flip}
    return {arguments.output: point_set_points(meshes[0], **options, **common)}


def _points_mesh_arguments(parser):
    _cloud_arguments(parser)
    parser.add_argument(
        "--cell-size", type=float, default=0.0, metavar="D", help="about the edge of the triangles (two spacings)"
    )


def _points_mesh(arguments, meshes, common):
    options = {"cell_size": arguments.cell_size, "width": arguments.width, "flip": arguments.flip}
    return {arguments.output: point_set_surface(meshes[0], **options, **common)}


def _points_curves_arguments(parser):
    _cloud_arguments(parser)
    parser.add_argument(
        "--plane",
        type=float,
        nargs=6,
        metavar=("OX", "OY", "OZ", "NX", "NY", "NZ"),
        help="origin and normal of a plane, instead of a tool",
    )
    parser.add_argument(
        "--chord-error", type=float, default=0.0, metavar="D", help="how far lines may be from the curve (spacing/10)"
    )


def _points_curves(arguments, meshes, common):
    if (len(meshes) == 2) == (arguments.plane is not None):
        arguments.parser.error("give either a tool or --plane")
    tool = arguments.plane or meshes[1]
    options = {"chord_error": arguments.chord_error, "width": arguments.width, "flip": arguments.flip}
    return {arguments.output: point_set_intersection(meshes[0], tool, **options, **common)}


def _points_boolean_arguments(parser):
    parser.add_argument(
        "--operation",
        choices=[operation.replace(" ", "-") for operation in CLOUD_OPERATIONS],
        default="union",
        help="what is inside the cloud or the tool, both, the cloud alone, the tool alone (union)",
    )
    _points_mesh_arguments(parser)
    parser.add_argument("--points", metavar="FILE", help="write what is left of the cloud, too")
    parser.add_argument("--curves", metavar="FILE", help="write the seam, too")


def _points_boolean(arguments, meshes, common):
    options = {"cell_size": arguments.cell_size, "width": arguments.width, "flip": arguments.flip}
    surface, points, curves = point_set_boolean(
        *meshes, arguments.operation, points=True, curves=True, **options, **common
    )
    return {arguments.output: surface, arguments.points: points, arguments.curves: curves}


def _add_tolerance(parser):
    parser.add_argument(
        "--tolerance",
        type=float,
        default=0.0,
        metavar="D",
        help="how far points may be moved before the exact computation starts: closes gaps far smaller than it (0)",
    )


COMMANDS = (
    Command(
        "union",
        "what is inside any of the surfaces",
        "The surface around everything that is inside any of the files.",
        "2..",
        _boolean("union", True),
        _boolean_arguments,
    ),
    Command(
        "intersection",
        "what is inside all of them",
        "The surface around everything that is inside all of the files.",
        "2..",
        _boolean("intersection", True),
        _boolean_arguments,
    ),
    Command(
        "difference",
        "the first one minus all others",
        "The surface around what is inside the first file and inside none of the others.",
        "2..",
        _boolean("difference", False),
        _boolean_arguments,
    ),
    Command(
        "symmetric-difference",
        "what is inside one of two, but not both",
        "The surface around what is inside one of the two files, but not inside both.",
        "2",
        _boolean("symmetric difference", False),
        _boolean_arguments,
    ),
    Command(
        "resolve",
        "a surface without its own overlaps",
        "The surface around everything that is inside any of the files, where each surface's own overlaps and "
        "self-intersections are taken away, too.",
        "1..",
        _boolean("resolve", True),
        _boolean_arguments,
    ),
    Command(
        "curves",
        "the curves in which two surfaces meet",
        "The curves in which two surfaces meet, or, with one file, in which a surface meets itself. Surfaces may be "
        "open.",
        "1..2",
        _curves,
        _curves_arguments,
    ),
    Command(
        "distance",
        "the distance of points to a surface",
        "The first file (surface, cloud or grid) with the array Distance: how far each of its points is from the "
        "tool, negative "
        "inside. The report has minimum, maximum, mean, RMS and quantiles.",
        "2",
        _distance,
        _distance_arguments,
    ),
    Command(
        "field",
        "the distance to a surface on an image",
        "An image (.vti) of the distance around a surface: its contour at 0 is the surface, others are offsets of it.",
        "1",
        _field,
        _field_arguments,
    ),
    Command(
        "check",
        "what is wrong with a surface, and where",
        "The surface with marks where it is open, crosses itself or is otherwise unfit for a Boolean. The report has "
        "the verdict, what cures it, and all counts.",
        "1",
        _check,
        _check_arguments,
    ),
    Command(
        "clip",
        "a closed surface cut by planes, and closed again",
        "A closed surface cut by any number of planes and a box, and closed again with caps.",
        "1",
        _clip,
        _clip_arguments,
    ),
    Command(
        "cut",
        "filled cross-sections of a closed surface",
        "Filled cross-sections of a closed surface, one or a series, each polygon with its area and perimeter.",
        "1",
        _cut,
        _cut_arguments,
    ),
    Command(
        "fill",
        "closed contours of one plane, filled",
        "The closed contours (lines) of one plane filled with triangles; a contour within a contour is a hole.",
        "1",
        _fill,
    ),
    Command(
        "points",
        "scanned points, moved onto their smooth surface",
        "The points of a cloud, moved onto the smooth surface that they sample (moving least squares), with normals, "
        "curvatures "
        "and marks where the scan is bad.",
        "1",
        _points,
        _points_arguments,
    ),
    Command(
        "points-mesh",
        "a mesh of scanned points",
        "A triangle mesh of the smooth surface that a cloud of points samples; closed if the cloud is.",
        "1",
        _points_mesh,
        _points_mesh_arguments,
    ),
    Command(
        "points-curves",
        "where a surface or a plane meets that of scanned points",
        "The curves in which a surface or a plane meets the smooth surface of a cloud of points, without meshing the "
        "cloud. Of a "
        "CAD file, the exact surfaces are cut.",
        "1..2",
        _points_curves,
        _points_curves_arguments,
    ),
    Command(
        "points-boolean",
        "the solid of scanned points with or without a body",
        "The union, intersection or difference of the solid that a closed cloud of points encloses with a closed "
        "surface. Of a CAD "
        "file, the exact surfaces are used.",
        "2",
        _points_boolean,
        _points_boolean_arguments,
    ),
)
