# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Inputs that change with time: a filter has the time steps of all its inputs, and follows a Tool that moves alone."""

import numpy as np
import pytest
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline, vtkTrivialProducer

import clouds
import meshes
from booleans import arrays_of, points_of, polydata
from surfacebooleans.vtk import (
    vtkPointSetBooleanFilter,
    vtkPointSetIntersectionFilter,
    vtkPolyDataBooleanOperationFilter,
    vtkPolyDataDistance,
    vtkPolyDataIntersection,
)


class MovingCube(VTKPythonAlgorithmBase):
    """A cube of side 2 whose lower corner is at x = time, at the steps given."""

    def __init__(self, steps):
        super().__init__(nInputPorts=0, outputType="vtkPolyData")
        self.steps = steps

    def RequestInformation(self, request, inputs, outputs):
        info = outputs.GetInformationObject(0)
        info.Set(vtkStreamingDemandDrivenPipeline.TIME_STEPS(), self.steps, len(self.steps))
        info.Set(vtkStreamingDemandDrivenPipeline.TIME_RANGE(), (self.steps[0], self.steps[-1]), 2)
        return 1

    def RequestData(self, request, inputs, outputs):
        info = outputs.GetInformationObject(0)
        time = info.Get(vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP()) or 0.0
        vtkPolyData.GetData(outputs, 0).ShallowCopy(cube(time))
        return 1


def cube(x):
    return polydata(meshes.box((x, 0, 0), (x + 2, 2, 2)))


def still(data):
    producer = vtkTrivialProducer()
    producer.SetOutput(data)
    return producer


def ball():
    """A scanned ball of radius 1 about x = -0.5: a quarter of a cap of it is inside of the cube at x = 0."""
    points, normals = clouds.sphere(2000)
    return clouds.cloud(points - [0.5, 0, 0], normals)


def volume(output):
    return arrays_of(output.GetFieldData())["ResultVolume"][0]


def extent(output):
    return points_of(output)[:, 0].min(), points_of(output)[:, 0].max()


def furthest(output):
    return np.abs(arrays_of(output.GetPointData())["Distance"]).max()


BALL, CAP = 4 / 3 * np.pi, np.pi * 0.5**2 * (3 - 0.5) / 3
# A filter, its Input that stands still, what is measured of its first output, and that for the Tool at 0, 1 and 3.
FILTERS = {
    "Boolean": (vtkPolyDataBooleanOperationFilter, lambda: cube(0), volume, (8.0, 12.0, 16.0)),
    "Distance": (vtkPolyDataDistance, lambda: cube(0), furthest, (0.0, 1.0, 3.0)),
    "Intersection": (vtkPolyDataIntersection, lambda: polydata(meshes.box((-1, 0.5, 0.5), (9, 1, 1))), extent, ((0.0, 2.0), (1.0, 3.0), (3.0, 5.0))),
    "PointSetIntersection": (vtkPointSetIntersectionFilter, ball, lambda output: points_of(output)[:, 0].min(), (0.0, None, None)),
    "PointSetBoolean": (vtkPointSetBooleanFilter, ball, volume, (8 + BALL - CAP / 4, 8 + BALL, 8 + BALL)),
}


def time_steps(tested, port):
    info = tested.GetOutputInformation(port)
    return info.Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS()), info.Get(vtkStreamingDemandDrivenPipeline.TIME_RANGE())


@pytest.mark.parametrize("name", FILTERS)
def test_a_moving_tool_moves_the_result_of_a_still_input(name):
    make, still_input, measure, wanted = FILTERS[name]
    tested = make()
    producer, mover = still(still_input()), MovingCube([0.0, 1.0, 3.0])
    tested.SetInputConnection(0, producer.GetOutputPort())
    tested.SetInputConnection(1, mover.GetOutputPort())
    tested.UpdateInformation()
    for port in range(tested.GetNumberOfOutputPorts()):
        assert time_steps(tested, port) == ((0.0, 1.0, 3.0), (0.0, 3.0))
    for time, value in [*zip((0.0, 1.0, 3.0), wanted), (0.0, wanted[0])]:
        tested.UpdateTimeStep(time)
        output = tested.GetOutputDataObject(0)
        if value is None:
            assert output.GetNumberOfPoints() == 0
        else:
            assert measure(output) == pytest.approx(value, rel=0.006, abs=1e-9)


@pytest.mark.parametrize("name", FILTERS)
def test_the_time_steps_of_all_inputs_are_those_of_the_output(name):
    tested = FILTERS[name][0]()
    movers = [MovingCube([0.0, 1.0]), MovingCube([0.5, 1.0, 3.0])]
    for port, mover in enumerate(movers):
        tested.SetInputConnection(port, mover.GetOutputPort())
    tested.UpdateInformation()
    for port in range(tested.GetNumberOfOutputPorts()):
        assert time_steps(tested, port) == ((0.0, 0.5, 1.0, 3.0), (0.0, 3.0))


def test_several_tools_move_by_themselves():
    movers = [MovingCube([0.0, 1.0]), MovingCube([0.5, 1.0, 3.0])]
    tested = vtkPolyDataBooleanOperationFilter()
    tested.SetInputData(cube(0))
    for mover in movers:
        tested.AddInputConnection(1, mover.GetOutputPort())
    tested.UpdateInformation()
    assert time_steps(tested, 0) == time_steps(tested, 1) == ((0.0, 0.5, 1.0, 3.0), (0.0, 3.0))
    for time, wanted in ((0.0, 8), (1.0, 12), (3.0, 16)):
        tested.UpdateTimeStep(time)
        assert volume(tested.GetOutput()) == pytest.approx(wanted)
