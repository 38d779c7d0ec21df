# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The demo: an elephant is fused with its pedestal and drilled through, in one Surface Boolean.

    make demo

Writes the elephant, the result, a state file to open in ParaView and a picture into the folder
given as argument (build/demo), and ends with exit status 1 if the result is not what it has to be.
"""

from paraview import simple

import demo_picture
import demo_report
from demo_elephant import write_elephant


def cylinder(name, radius, height, center, azimuth=None):
    """A fine cylinder, upright, or lying in the direction of an azimuth (degrees from x to z)."""
    upright = simple.Cylinder(registrationName=f"{name} upright", Radius=radius, Height=height)
    upright.Resolution = 256 if radius > 0.05 else 96
    placed = simple.Transform(registrationName=name, Input=upright)
    placed.Transform.Rotate = [0, 0, 0] if azimuth is None else [azimuth, 0, -90]
    placed.Transform.Translate = center
    return placed


def make_bodies(elephant_file):
    """Elephant and pedestal; they run through each other, as parts of an assembly do."""
    mesh = simple.LegacyVTKReader(registrationName="Mesh", FileNames=[str(elephant_file)])
    elephant = simple.GenerateSurfaceNormals(registrationName="Elephant", Input=mesh, Splitting=0)
    drum = cylinder("Drum", radius=0.25, height=0.19, center=[0, -0.545, -0.05])
    plinth = cylinder("Plinth", radius=0.29, height=0.05, center=[0, -0.64, -0.05])
    return [elephant, drum, plinth]


def make_tools():
    """A drill from flank to flank, and a ring of twelve pegs around the drum."""
    drill = cylinder("Drill", radius=0.072, height=0.8, center=[-0.075, -0.17, 0.02], azimuth=75)
    peg = cylinder("Peg", radius=0.036, height=0.12, center=[0.255, -0.53, -0.05], azimuth=0)
    pegs = simple.AngularPeriodicFilter(registrationName="Pegs", Input=peg)
    pegs.Axis = "Axis Y"
    pegs.Center = [0, 0, -0.05]
    pegs.IterationMode = "Manual"
    pegs.NumberOfPeriods = 12
    pegs.RotationAngle = 30
    return [drill, pegs]


def boolean(name, operation, bodies, tools=()):
    return simple.SurfaceBoolean(
        registrationName=name, Input=list(bodies), Tool=list(tools), Operation=operation
    )


def main(folder):
    """Write everything into the folder; whether the results are what they have to be."""
    folder.mkdir(parents=True, exist_ok=True)
    bodies = make_bodies(write_elephant(folder / "elephant.vtk"))
    tools = make_tools()
    for source in bodies + tools:
        source.UpdatePipeline()  # so that the times below are those of the Booleans alone

    drilled = boolean("Drilled", "Difference", bodies, tools)
    drilled.UpdatePipeline()
    # Not .vtp: as ParaView writes it, Debian 12 cannot read it again (README).
    result_file = folder / "drilled_elephant.vtk"
    simple.SaveData(str(result_file), proxy=drilled)

    demo_report.print_operands(drilled, bodies + tools)
    results = {
        "A": boolean("A", "Union", bodies),
        "B": boolean("B", "Union", tools),
        "A - B": drilled,
        "A | B": boolean("A or B", "Union", bodies, tools),
        "A & B": boolean("A and B", "Intersection", bodies, tools),
        "A ^ B": boolean("A xor B", "Symmetric Difference", bodies, tools),
    }
    right = demo_report.print_results(results)
    right = demo_report.print_identities(results) and right
    right = demo_report.print_file(result_file) and right
    demo_report.print_stages("A - B", drilled)
    for name, result in results.items():
        if result is not drilled:
            simple.Delete(result)

    picture = folder / "drilled_elephant.png"
    demo_picture.draw(picture, operands=(bodies, tools), result=drilled)
    simple.SaveState(str(folder / "demo.pvsm"))
    print(f"\nPicture: {picture}\nResult:  {result_file}")
    print(f"State:   {folder / 'demo.pvsm'} (open it from: make gui)")
    return right


if __name__ == "__main__":
    demo_report.run(main, "SurfaceBoolean")
