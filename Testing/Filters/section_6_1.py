# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The source document's section 6.1: a Boolean as a pipeline of its parts (Figure 4), beside Surface Boolean.

    . build/env.sh && pvpython Testing/Filters/section_6_1.py [section_6_1.pvsm]

Surface Intersection cuts both surfaces along each other, Surface Distance says on which side of the other one every
cell lies, two Thresholds keep what belongs to the result, Reverse Sense turns over what comes from inside (in a
difference), and Append puts the two parts together. Prints both volumes for a cone and a cylinder; with a file name, it
makes that state file instead (section_6_1.pvsm beside this script).

The Thresholds take the distances of the cells' centres instead of those of their points: on a cut all distances are
zero, and a triangle may have all its points there.
"""

import sys

from paraview import simple

OUTSIDE, INSIDE = "Above Upper Threshold", "Below Lower Threshold"
KEPT = {"Union": (OUTSIDE, OUTSIDE), "Intersection": (INSIDE, INSIDE), "Difference": (OUTSIDE, INSIDE)}


def boolean_of_parts(first, second, operation, name="Section 6.1"):
    """The pipeline of Figure 4; its last filter is returned."""
    cut = simple.SurfaceIntersection(registrationName=f"{name}: cut", Input=first, Tool=second)
    distance = simple.SurfaceDistance(
        registrationName=f"{name}: distance",
        Input=simple.OutputPort(cut, 1),
        Tool=simple.OutputPort(cut, 2),
        ComputeSecondDistance=1,
        ComputeCellCenterDistance=1,
    )
    parts = []
    for port, side in enumerate(KEPT[operation]):
        kept = simple.Threshold(
            registrationName=f"{name}: part {port + 1}",
            Input=simple.OutputPort(distance, port),
            Scalars=["CELLS", "Distance"],
            ThresholdMethod=side,
            LowerThreshold=0.0,
            UpperThreshold=0.0,
        )
        parts.append(simple.ExtractSurface(registrationName=f"{name}: surface {port + 1}", Input=kept))
    if operation == "Difference":
        parts[1] = simple.ReverseSense(
            registrationName=f"{name}: turned over", Input=parts[1], ReverseCells=1, ReverseNormals=1
        )
    return simple.AppendGeometry(registrationName=f"{name}: result", Input=parts)


def cone_and_cylinder():
    """The solids of the source document's Figure 1."""
    cone = simple.Cone(registrationName="Cone", Radius=0.5, Height=1.125, Resolution=96, Direction=[0, 0, 1])
    cylinder = simple.Cylinder(
        registrationName="Cylinder", Radius=0.25, Height=1.25, Resolution=96, Center=[0, 0, -0.1875]
    )
    return cone, cylinder


def difference(result, proxy):
    """The volume that is in one of two solids and not in the other."""
    both = simple.SurfaceBoolean(Input=result, Tool=proxy, Operation="Symmetric Difference")
    both.UpdatePipeline()
    return both.FieldData["ResultVolume"].GetRange()[0]


def volume(proxy):
    """Of any closed surface, as Surface Boolean measures it."""
    measured = simple.SurfaceBoolean(Input=proxy, Operation="Resolve")
    measured.UpdatePipeline()
    return measured.FieldData["OperandVolume"].GetRange()[0]


def save(state):
    """The difference as a state file: what is left of the cone, and the curve."""
    result = boolean_of_parts(*cone_and_cylinder(), "Difference")
    view = simple.GetActiveViewOrCreate("RenderView")
    simple.ColorBy(simple.Show(result, view), ("CELLS", "SourceId"))
    curve = simple.Show(simple.OutputPort(simple.FindSource("Section 6.1: cut"), 0), view)
    simple.ColorBy(curve, None)
    curve.AmbientColor = curve.DiffuseColor = [0, 0, 0]
    curve.LineWidth = 4
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [2.4, -2.2, 1.6], [0, 0, 0], [0, 0, 1]
    simple.ResetCamera(view)
    simple.SaveState(state)


def main():
    cone, cylinder = cone_and_cylinder()
    same = True
    for operation in KEPT:
        parts = boolean_of_parts(cone, cylinder, operation, operation)
        whole = simple.SurfaceBoolean(Input=cone, Tool=cylinder, Operation=operation)
        volumes, apart = (volume(parts), volume(whole)), difference(parts, whole)
        same = same and apart == 0.0
        print(f"{operation}: pipeline {volumes[0]:.12f}, Surface Boolean {volumes[1]:.12f}, ", end="")
        print(f"in one but not both {apart:g}")
    if not same:
        raise SystemExit("The pipeline and Surface Boolean differ.")


if __name__ == "__main__":
    save(sys.argv[1]) if len(sys.argv) > 1 else main()
