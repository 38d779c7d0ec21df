# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""What vtkPolyDataIntersection promises around the computation: its settings, what it says of input that it cannot use,
and how paraview.simple and the menus know it."""

import numpy as np
import pytest
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData

import meshes
import states
from booleans import polydata
from intersections import intersection, update
from meshes import box, mesh
from surfacebooleans.vtk import vtkPolyDataIntersection

EMPTY_OPERAND, BAD_COORDINATE, BAD_INDEX, ABORTED, BAD_REQUEST, NOT_A_SURFACE, NO_CURVE = 1, 6, 7, 9, 10, 20, 40
CUBE, OTHER = box((0, 0, 0), (2, 2, 2)), box((1, 1, 1), (3, 3, 3))
PROPERTIES = {
    "Input": None,
    "Tool": None,
    "SplitFirstOutput": 1,
    "SplitSecondOutput": 1,
    "Tolerance": 0.0,
    "NumberOfThreads": 0,
}


# ---- settings ---------------------------------------------------------------------------------------


def test_the_defaults_are_those_of_the_source_document():
    tested = vtkPolyDataIntersection()
    assert tested.GetSplitFirstOutput() == tested.GetSplitSecondOutput() == 1
    assert tested.GetTolerance() == 0.0 and tested.GetNumberOfThreads() == 0
    assert tested.GetNumberOfInputPorts() == 2 and tested.GetNumberOfOutputPorts() == 3


def test_the_switches_of_section_5_3_choose_the_outputs():
    for first in (0, 1):
        for second in (0, 1):
            tested = vtkPolyDataIntersection()
            tested.SplitFirstOutputOn() if first else tested.SplitFirstOutputOff()
            tested.SplitSecondOutputOn() if second else tested.SplitSecondOutputOff()
            tested.SetInputData(polydata(CUBE))
            tested.SetToolData(polydata(OTHER))
            cut = update(tested)
            assert [split.is_empty for split in cut.splits] == [not first, not second]
            assert cut.length == 6.0 and cut.status == 0
            assert tested.GetCurvesOutput() is cut.curves
            assert tested.GetSplitInputOutput() is cut.splits[0].data
            assert tested.GetSplitToolOutput() is cut.splits[1].data


def test_the_tool_can_be_taken_away_again():
    tested = vtkPolyDataIntersection()
    tested.SetInputData(polydata(CUBE))
    tested.SetToolData(polydata(OTHER))
    assert update(tested).length == 6.0
    tested.RemoveTool()
    cut = update(tested)
    assert cut.status == NO_CURVE and cut.splits[1].is_empty and "itself" in cut.message


def test_the_field_data_tell_what_was_done():
    data = polydata(CUBE)
    note = numpy_to_vtk(np.array([7]), deep=True)
    note.SetName("Note")
    data.GetFieldData().AddArray(note)
    cut = intersection(data, OTHER)
    assert cut.message == "The result is complete." and cut.field_data["ContactCount"][0] > 0
    assert len(cut.field_data["StageNames"]) == len(cut.field_data["StageSeconds"]) > 2
    assert cut.splits[0].field_data["Note"].tolist() == [7] and "Note" not in cut.splits[1].field_data


def test_a_moved_tool_is_seen_and_a_tolerance_closes_a_gap():
    tested = vtkPolyDataIntersection()
    tested.SetInputData(polydata(CUBE))
    tool = polydata(OTHER)
    tested.SetToolData(tool)
    assert update(tested).length == 6.0
    points = numpy_to_vtk(OTHER.points + [1.0 + 1e-9, 0, 0], deep=True)
    tool.GetPoints().SetData(points)
    tool.GetPoints().Modified()
    tested.Modified()
    assert update(tested).status == NO_CURVE
    tested.SetTolerance(1e-6)
    cut = update(tested)
    assert cut.status == 0 and cut.length == pytest.approx(4.0, abs=1e-6)


# ---- bad and empty input ------------------------------------------------------------------------------


def assert_refused(cut, status, *words):
    assert cut.status == status, cut.message
    assert len(cut.errors) == 1 and cut.message in cut.errors[0]
    assert cut.message.endswith(".") and ". " not in cut.message and 20 < len(cut.message) < 300
    assert all(word in cut.message for word in words)
    assert cut.curves.GetNumberOfPoints() == cut.curves.GetNumberOfCells() == 0
    assert all(split.is_empty for split in cut.splits)


def test_coordinates_that_are_no_numbers():
    bad = box((1, 1, 1), (3, 3, 3))
    bad.points[3, 1] = np.nan
    assert_refused(intersection(CUBE, bad), BAD_COORDINATE, "Tool", "point 3")


def test_cells_that_name_points_which_do_not_exist():
    assert_refused(intersection(mesh(CUBE.points, CUBE.triangles + 1), OTHER), BAD_INDEX, "Input", "cell")


@pytest.mark.parametrize("tolerance", (-1.0, float("nan"), float("inf")))
def test_a_tolerance_that_is_no_length(tolerance):
    assert_refused(intersection(CUBE, OTHER, Tolerance=tolerance), BAD_REQUEST, "Tolerance")


def test_no_input_at_all():
    assert_refused(intersection(None, OTHER), BAD_REQUEST, "Input")


def test_what_is_no_surface():
    assert_refused(intersection(vtkImageData(), OTHER), NOT_A_SURFACE, "Input")
    assert_refused(intersection(CUBE, vtkImageData()), NOT_A_SURFACE, "Tool")


def test_surfaces_that_do_not_meet_are_no_error():
    cut = intersection(CUBE, meshes.moved(OTHER, (5, 0, 0)))
    assert cut.status == NO_CURVE and not cut.errors and not cut.warnings
    assert "do not meet" in cut.message and cut.curves.GetNumberOfCells() == cut.curves.GetNumberOfPoints() == 0
    for split, body in zip(cut.splits, (CUBE, OTHER)):
        assert len(split.body.triangles) == len(body.triangles) and split.number_of_patches == 1


def test_an_empty_surface_is_a_warning():
    for surfaces, name in (((vtkPolyData(), CUBE), "Input"), ((CUBE, vtkPolyData()), "Tool")):
        cut = intersection(*surfaces)
        assert not cut.errors and len(cut.warnings) == 1 and name in cut.warnings[0]
        assert cut.status == NO_CURVE and len(cut.polylines) == 0


def test_stopping_the_filter_leaves_nothing_and_it_can_run_again():
    ball = meshes.icosphere(5)
    tested = vtkPolyDataIntersection()
    tested.SetInputData(polydata(ball))
    tested.SetToolData(polydata(meshes.moved(ball, (0.3, 0.2, 0.1))))
    stop = tested.AddObserver("ProgressEvent", lambda *_: tested.SetAbortExecuteAndUpdateTime())
    cut = update(tested)
    assert cut.curves.GetNumberOfCells() == 0 and all(split.is_empty for split in cut.splits) and not cut.errors
    assert cut.field_data.get("Status", [ABORTED])[0] == ABORTED
    tested.RemoveObserver(stop)
    tested.SetAbortExecute(0)
    tested.Modified()
    assert update(tested).loops == 1


def test_one_surface_on_both_ports():
    data = polydata(CUBE)
    cut = intersection(data, data)
    assert cut.status == NO_CURVE and [split.number_of_patches for split in cut.splits] == [1, 1]


# ---- the proxy ------------------------------------------------------------------------------------------


@pytest.fixture
def session():
    simple.ResetSession()


def two_boxes():
    return [simple.Box(XLength=2, YLength=2, ZLength=2, Center=place) for place in ((0, 0, 0), (1, 1, 1))]


def total_length(proxy):
    proxy.UpdatePipeline()
    return proxy.FieldData["TotalLength"].GetRange()[0]


def test_the_properties_are_those_of_the_interface(session):
    first, second = two_boxes()
    proxy = simple.SurfaceIntersection(Input=first, Tool=second)
    assert set(proxy.ListProperties()) == set(PROPERTIES)
    for name, default in PROPERTIES.items():
        if default is not None:
            assert proxy.GetPropertyValue(name) == default
        text = proxy.GetProperty(name).SMProperty.GetDocumentation().GetDescription()
        assert len(text.strip()) > 40, name
    assert [proxy.SMProxy.GetOutputPortName(k) for k in range(3)] == ["Curves", "SplitInput", "SplitTool"]
    hint = proxy.GetHints().FindNestedElementByName("ShowInMenu")
    assert hint.GetAttribute("category") == "Surface Booleans" and hint.GetAttribute("icon").endswith(".svg")
    documentation = proxy.SMProxy.GetDocumentation()
    assert documentation.GetShortHelp() and documentation.GetLongHelp()
    assert all(name in documentation.GetDescription() for name in ("PatchId", "SeamPoint", "SegmentCellIds"))


def test_a_script_gets_curves_and_patches(session):
    first, second = two_boxes()
    proxy = simple.SurfaceIntersection(Input=first, Tool=second)
    assert total_length(proxy) == 6.0
    assert proxy.CellData["CurveId"].GetRange() == (0, 0) and proxy.CellData["SourceIds"].GetNumberOfComponents() == 2
    for port in (1, 2):
        part = simple.Threshold(
            Input=simple.OutputPort(proxy, port),
            Scalars=["CELLS", "PatchId"],
            ThresholdMethod="Between",
            LowerThreshold=1,
            UpperThreshold=1,
        )
        part.UpdatePipeline()
        whole = simple.OutputPort(proxy, port).GetDataInformation().GetNumberOfCells()
        assert 0 < part.GetDataInformation().GetNumberOfCells() < whole
    proxy.Tool = None
    proxy.UpdatePipeline()
    assert proxy.FieldData["Status"].GetRange() == (NO_CURVE, NO_CURVE)
    proxy.Tool = second
    assert total_length(proxy) == 6.0


@pytest.mark.parametrize("kind", states.KINDS)
def test_a_state_file_gives_the_same_pipeline(kind, session, tmp_path):
    first, second = two_boxes()
    proxy = simple.SurfaceIntersection(registrationName="Seam", Input=first, Tool=second, SplitSecondOutput=0)
    assert total_length(proxy) == 6.0
    states.replay(kind, tmp_path)
    again = simple.FindSource("Seam")
    assert again.SplitSecondOutput == 0 and total_length(again) == 6.0
