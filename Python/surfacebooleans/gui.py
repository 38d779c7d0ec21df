# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Recipes for ParaView's window: the toolbar Surface Booleans and the macros call them, and so may scripts.

Each takes the sources that are selected in the Pipeline Browser (the first one is the Input, the second one the Tool;
select several with Ctrl; the toolbar asks by a dialog where the selection does not tell), makes the filter, shows its result in telling colours, hides what it is made of, and returns
the filter. What is wrong is said in the Output Messages; None is returned then.

    from surfacebooleans import gui
    gui.boolean("Difference")
"""

import functools
import itertools

from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkOutputWindow

from surfacebooleans.distance_map import show_distance

BLUE, RED, INK = [0.22, 0.47, 0.86], [0.90, 0.20, 0.15], [0.08, 0.10, 0.16]
MORE_COLOURS = [[0.95, 0.77, 0.20], [0.30, 0.69, 0.40], [0.58, 0.40, 0.74], [0.55, 0.47, 0.40]]
DEFECTS = {  # values of the array Defect
    0: ("sound", [0.80, 0.85, 0.92]),
    1: ("hole", [0.90, 0.20, 0.15]),
    2: ("more than two polygons", [0.58, 0.40, 0.74]),
    3: ("contradicting orientation", [0.93, 0.51, 0.93]),
    4: ("touching in a point", [0.10, 0.10, 0.12]),
    5: ("meets itself", [0.98, 0.60, 0.10]),
    6: ("no area", [0.55, 0.47, 0.40]),
    7: ("repeated", [0.30, 0.69, 0.40]),
    8: ("wrong way round", [0.95, 0.77, 0.20]),
}
SEE_THROUGH = 0.25  # opacity of what is only there for comparison


class _CannotStart(Exception):
    """There is nothing to work on; the text says what to do."""


def _told(recipe):
    """What keeps a recipe from starting is told in the Output Messages, not raised."""

    @functools.wraps(recipe)
    def telling(*arguments, **options):
        try:
            return recipe(*arguments, **options)
        except _CannotStart as reason:
            vtkOutputWindow.GetInstance().DisplayErrorText(f"{reason}\n")
            return None

    return telling


# ---- the recipes -------------------------------------------------------------------------------


@_told
def boolean(operation="Union", sources=None, inputs=1):
    """Surface Boolean of the selected sources, coloured by where its cells come from: blue Input, red Tool.

    Parameters
    ----------
    operation : {"Union", "Intersection", "Difference", "Symmetric Difference", "Resolve"}, optional
    sources : list of proxies, optional
        Instead of the selected ones.
    inputs : int, optional
        How many of them, from the first one on, are Inputs; all others are Tools.

    Returns
    -------
    proxy or None
        The filter; None if too few sources are selected, or one that is no surface.
    """
    least = 1 if operation == "Resolve" else 2
    sources = _sources(sources, least, None, f"{operation} takes the first one as Input, all others as Tools")
    _check_kinds("SurfaceBoolean", sources, inputs)
    result = simple.SurfaceBoolean(
        registrationName=operation, Input=sources[:inputs], Tool=sources[inputs:], Operation=operation
    )
    if _has_result(result):
        _show_sources(result, sources)
        _hide(sources)
    return _finished(result)


@_told
def curves(sources=None):
    """The curves in which the two selected sources meet (or one meets itself), thick, in the surfaces seen through.

    Parameters
    ----------
    sources : list of proxies, optional
        Instead of the selected ones: one or two.

    Returns
    -------
    proxy or None
        The filter Surface Intersection.
    """
    sources = _sources(sources, 1, 2, "the curves of two surfaces, or of one with itself")
    _check_kinds("SurfaceIntersection", sources)
    result = simple.SurfaceIntersection(registrationName="Curves", Input=sources[0], Tool=sources[1:])
    if _has_result(result):
        for source, colour in zip(sources, (BLUE, RED)):
            _show_through(source, colour)
        display = simple.Show(simple.OutputPort(result, 0), _view())
        _paint(display, INK)
        display.LineWidth = 4
        display.RenderLinesAsTubes = 1
    return _finished(result)


@_told
def distance_map(sources=None, histogram=True):
    """The first selected source coloured by its distance to the second one: blue inside, white on it, red outside.

    Parameters
    ----------
    sources : list of proxies, optional
        Instead of the selected ones: what is measured, and the surface.
    histogram : bool, optional
        Whether to show how often each distance occurs in a view beside.

    Returns
    -------
    proxy or None
        The filter Surface Distance.
    """
    sources = _sources(sources, 2, 2, "the first one is measured, the second one is the surface")
    _check_kinds("SurfaceDistance", sources)
    result = simple.SurfaceDistance(registrationName="Distance", Input=sources[0], Tool=sources[1])
    if _has_result(result):
        view = _view()
        show_distance(result, view)
        _hide(sources[:1])
        _show_through(sources[1], [0.7, 0.7, 0.7])
        if histogram:
            _show_histogram(result, view)
    return _finished(result)


@_told
def clip(sources=None):
    """The selected source clipped by a plane through its middle, with caps of another colour; the plane can be dragged.

    Parameters
    ----------
    sources : list of proxies, optional
        Instead of the selected one.

    Returns
    -------
    proxy or None
        The filter Closed Surface Clip.
    """
    (source,) = _sources(sources, 1, 1, "the closed surface to clip")
    _check_kinds("ClosedSurfaceClip", [source])
    bounds = source.GetDataInformation().GetBounds()
    middle = [(low + high) / 2 for low, high in zip(bounds[::2], bounds[1::2])]
    result = simple.ClosedSurfaceClip(
        registrationName="Clip", Input=source, Origin=middle, Normal=_axis_away_from(_view())
    )
    if _has_result(result):
        _show_sources(result, [source, "Cap"])
        _hide([source])
    return _finished(result)


@_told
def live_tool(operation="Difference", sources=None):
    """A Boolean whose Tool one can drag: move the box in the view, and the result follows.

    The Tool goes through a Transform, which becomes the active source, so that its box is in the view: drag it with the middle
    mouse button, or by its handles with the left one. Auto Apply is switched on, as by the button beside Apply. Where there is no
    graphics card the view is drawn by one light in place of five and without smoothed edges, and the result without the inner
    sides that one does not see, in less than half of the time.

    Parameters
    ----------
    operation : {"Union", "Intersection", "Difference", "Symmetric Difference"}, optional
    sources : list of proxies, optional
        Instead of the selected ones: the body and the tool.

    Returns
    -------
    proxy or None
        The Transform of the tool.
    """
    body, tool = _sources(sources, 2, 2, "the first one stays, the second one can be dragged")
    _check_kinds("SurfaceBoolean", [body, tool])
    moved = simple.Transform(registrationName=f"Drag {_name(tool)}", Input=tool)
    result = simple.SurfaceBoolean(registrationName=operation, Input=body, Tool=moved, Operation=operation)
    if _has_result(result):
        shown = _show_sources(result, [body, tool])
        _hide([body, tool])
        display = simple.Show(moved, _view())
        display.Representation = "Wireframe"  # drawn faster than what is seen through
        _paint(display, RED)
        _number_colours(shown.LookupTable, _view())
        _lighten(shown, _view())
    simple.GetSettingsProxy("GeneralSettings").AutoApply = 1
    return _finished(moved)


@_told
def point_cloud(sources=None):
    """The smooth surface of the selected cloud of points; with a second source, the cloud's solid without that body.

    The surface is coloured by its mean curvature, the difference by where it comes from: blue cloud, red body.

    Parameters
    ----------
    sources : list of proxies, optional
        Instead of the selected ones: a cloud, and a closed surface.

    Returns
    -------
    proxy or None
        The filter Point Set Surface or Point Set Boolean.
    """
    sources = _sources(sources, 1, 2, "a cloud of points, and a body to take away from it if there is one")
    _check_kinds("PointSetBoolean" if len(sources) == 2 else "PointSetSurface", sources)
    if len(sources) == 2:
        result = simple.PointSetBoolean(
            registrationName="Point Cloud", Input=sources[0], Tool=sources[1], Operation="Difference"
        )
        if _has_result(result):
            _show_sources(result, sources)
            _hide(sources)
        return _finished(result)
    result = simple.PointSetSurface(registrationName="Point Cloud", Input=sources[0], GenerateSurface=1)
    if _has_result(result):
        mesh, view = simple.OutputPort(result, 1), _view()
        display = simple.Show(mesh, view)
        display.Representation = "Surface"
        _colour_about_zero(display, "MeanCurvature", mesh, view)
        simple.Hide(simple.OutputPort(result, 0), view)
        _hide(sources)
    return _finished(result)


@_told
def check(sources=None):
    """What is wrong with the selected surface, and where: thick lines and points upon it, and the verdict in words.

    Parameters
    ----------
    sources : list of proxies, optional
        Instead of the selected one.

    Returns
    -------
    proxy or None
        The filter Surface Check.
    """
    (source,) = _sources(sources, 1, 1, "the surface to check")
    _check_kinds("SurfaceCheck", [source])
    result = simple.SurfaceCheck(registrationName="Check", Input=source)
    if _has_result(result):
        view = _view()
        surface = simple.Show(simple.OutputPort(result, 0), view)
        surface.Representation = "Surface"
        places = simple.Show(simple.OutputPort(result, 1), view)
        places.Representation = "Surface"
        places.LineWidth, places.PointSize = 4, 10
        table = simple.GetColorTransferFunction("Defect")
        _name_values(table, DEFECTS)
        for display in (surface, places):  # not by ColorBy, which warns where there is no defect
            display.ColorArrayName, display.LookupTable = ["CELLS", "Defect"], table
        _show_legend(surface, table, view)
        _show_verdict(result, view)
        _hide([source])
    return _finished(result)


@_told
def show_tool(result=None):
    """Show the Tools of the selected filter, so that one can see through them; hide them if they are shown so already.

    Parameters
    ----------
    result : proxy, optional
        Instead of the selected filter.

    Returns
    -------
    proxy or None
        The filter; None if it has no Tool.
    """
    result = result or simple.GetActiveSource()
    tools = getattr(result, "Tool", None)
    tools = [tools] if isinstance(tools, servermanager.Proxy) else list(tools or [])
    if not tools:
        raise _CannotStart("Select a filter that has a Tool in the Pipeline Browser first, such as a Difference.")
    view = _view()
    displays = [simple.GetDisplayProperties(tool, view) for tool in tools]
    shown = all(display.Visibility and display.Opacity == SEE_THROUGH for display in displays)
    for tool, colour in zip(tools, itertools.cycle([RED, *MORE_COLOURS])):
        if shown:
            simple.Hide(tool, view)
        else:
            _show_through(tool, colour)
    return _finished(result)


@_told
def blocks(result=None):
    """The selected result in a colour for each block of multi-block data that its parts come from, with their names.

    Parameters
    ----------
    result : proxy, optional
        Instead of the selected source: a filter of this plugin, or what follows it, with the array BlockId.

    Returns
    -------
    proxy or None
        The source; None if it has no such array.
    """
    result = result or simple.GetActiveSource()
    if result is not None:
        result.UpdatePipeline()
    places = {"CELLS": "CellData", "POINTS": "PointData"}
    place = next((name for name, data in places.items() if "BlockId" in _arrays(result, data)), None)
    if place is None:
        raise _CannotStart(
            "Select a result with the array BlockId in the Pipeline Browser first: that of a filter of Surface Booleans "
            "whose Input or Tool is multi-block."
        )
    colours = itertools.cycle([BLUE, RED, *MORE_COLOURS])
    names = {k: (name, next(colours)) for k, name in enumerate(_words(result, "BlockNames"))}
    names[-1] = ("no block", [0.7, 0.7, 0.7])
    view = _view()
    display = simple.Show(result, view)
    display.Representation = "Surface"
    simple.ColorBy(display, (place, "BlockId"), separate=True)
    table = simple.GetColorTransferFunction("BlockId", display, separate=True)
    _name_values(table, names)
    _show_legend(display, table, view)
    return _finished(result)


def chosen(ports):
    """The sources that the toolbar's dialog was given, from the ids of their proxies and the numbers of their ports."""
    session = servermanager.ActiveConnection.Session
    return [
        simple.OutputPort(servermanager._getPyProxy(session.GetRemoteObject(proxy)), port) for proxy, port in ports
    ]


# ---- what they share ---------------------------------------------------------------------------


def _sources(sources, least, most, what):
    """The given or the selected sources, up to date; refused if they are too few or too many."""
    sources = simple.active_objects.get_selected_sources() if sources is None else list(sources)
    if len(sources) < least or (most is not None and len(sources) > most):
        count = {1: "one source", 2: "two sources"}[least]
        count = count if most == least else f"{count} or more" if most is None else "one or two sources"
        raise _CannotStart(
            f"Select {count} in the Pipeline Browser first (Ctrl and click adds one): {what}. "
            f"Selected are {len(sources)}."
        )
    for source in sources:
        source.UpdatePipeline()
    return sources


def _check_kinds(kind, sources, inputs=1):
    """Refuse a source that the filter cannot take at its place: the filter itself could only say what class it is of."""
    prototype = servermanager.ProxyManager().GetPrototypeProxy("filters", kind)
    for k, source in enumerate(sources):
        place = "Input" if k < inputs else "Tool"
        connection = prototype.GetProperty(place)
        connection.RemoveAllUncheckedProxies()
        connection.AddUncheckedInputConnection(source.SMProxy, getattr(source, "Port", 0))
        fits = connection.IsInDomains()
        connection.RemoveAllUncheckedProxies()
        if not fits:
            wanted = "points" if kind.startswith("PointSet") and place == "Input" else "surfaces"
            raise _CannotStart(
                f"{_name(source)} cannot be the {place} of {prototype.GetXMLLabel()}, which takes {wanted}: "
                "Extract Surface makes such of other data."
            )


def _has_result(result):
    """Update a filter. False if nothing came out of it: ParaView has shown the error then, or it is told here."""
    result.UpdatePipeline()
    ports = range(result.SMProxy.GetNumberOfOutputPorts())
    if any(result.GetDataInformation(port).GetNumberOfPoints() for port in ports):
        return True
    if result.FieldData["Status"].GetRange()[0] == 0:
        vtkOutputWindow.GetInstance().DisplayWarningText(f"{_name(result)}: the result is empty.\n")
    return False


def _finished(result):
    simple.SetActiveSource(result)
    simple.Render(_view())
    return result


def _view():
    return simple.GetActiveViewOrCreate("RenderView")


def _axis_away_from(view):
    """The axis along which the camera looks most: a cap across it is seen in full."""
    ahead = [to - at for at, to in zip(view.CameraPosition, view.CameraFocalPoint)]
    most = max(range(3), key=lambda k: abs(ahead[k]))
    return [(1.0 if ahead[k] > 0 else -1.0) if k == most else 0.0 for k in range(3)]


def _hide(sources):
    for source in sources:
        simple.Hide(source, _view())


def _name(source):
    if isinstance(source, str):
        return source
    return servermanager.ProxyManager().GetProxyName("sources", source) or "Input"


def _show_sources(result, sources):
    """Show a filter's surface with a colour for each source, and their names in the legend. Returns how it is shown."""
    view = _view()
    display = simple.Show(simple.OutputPort(result, 0), view)
    display.Representation = "Surface"
    simple.ColorBy(display, ("CELLS", "SourceId"), separate=True)
    table = simple.GetColorTransferFunction("SourceId", display, separate=True)
    colours = itertools.cycle([BLUE, RED, *MORE_COLOURS])
    _name_values(table, {k: (_name(source), next(colours)) for k, source in enumerate(sources)})
    _show_legend(display, table, view)
    return display


def _name_values(table, names):
    """A word and a colour for each value."""
    table.InterpretValuesAsCategories = 1
    table.Annotations = [text for value, (word, _) in names.items() for text in (str(value), word)]
    table.IndexedColors = [part for _, colour in names.values() for part in colour]


def _number_colours(table, view):
    """Find the colours of the two sources by number, not by word, which for each cell takes VTK longer than the Boolean."""
    first, second = table.IndexedColors[:3], table.IndexedColors[3:]
    table.InterpretValuesAsCategories, table.NumberOfTableValues = 0, 2
    table.RGBPoints = [-0.5, *first, 1.5, *second]
    table.AutomaticRescaleRangeMode = "Never"
    bar = simple.GetScalarBar(table, view)
    bar.DrawTickMarks = bar.DrawTickLabels = bar.AddRangeLabels = 0


def _show_legend(display, table, view):
    """The names of the values, without a title."""
    display.SetScalarBarVisibility(view, True)
    bar = simple.GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = "", ""


def _arrays(source, data):
    """The names of the arrays on a source's cells or points."""
    return [] if source is None else getattr(source, data).keys()


def _words(result, field):
    """All values of a field array of texts. The server makes one text of them, since not all of the data are wanted here."""
    joined = simple.PythonAnnotation(Input=result, ArrayAssociation="Field Data")
    array = f"inputs[0].VTKObject.GetFieldData().GetAbstractArray({field!r})"
    joined.Expression = f"chr(10).join(map({array}.GetValue, range({array}.GetNumberOfValues())))"
    joined.UpdatePipeline()
    text = servermanager.Fetch(joined).GetColumn(0).GetValue(0)
    simple.Delete(joined)
    return text.split("\n")


def _show_verdict(result, view):
    """The verdict in words, in a corner of the view; it follows the filter."""
    words = simple.PythonAnnotation(registrationName="Verdict", Input=result, ArrayAssociation="Field Data")
    words.Expression = (
        "__import__('textwrap').fill(inputs[0].VTKObject.GetFieldData().GetAbstractArray('Verdict').GetValue(0), 80)"
    )
    display = simple.Show(words, view)
    display.FontSize, display.WindowLocation = 12, "Lower Left Corner"


def _show_through(source, colour):
    """Show a source in one colour, so that one can see what is behind and inside of it."""
    display = simple.Show(source, _view())
    display.Representation = "Surface"
    _paint(display, colour)
    display.Opacity = SEE_THROUGH


def _paint(display, colour):
    """One colour for all of it."""
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = colour


def _lighten(display, view):
    """Without a graphics card: draw only what one sees of a closed surface from outside, by one light, with no smoothed edges."""
    if "llvmpipe" in view.GetRenderWindow().ReportCapabilities():
        view.UseFXAA = view.UseLight = 0
        if not view.AdditionalLights:
            simple.AddLight(view=view).Coords = "Headlight"
        display.BackfaceRepresentation = "Cull Backface"


def _colour_about_zero(display, array, data, view):
    """Colours that diverge about zero."""
    simple.ColorBy(display, ("POINTS", array))
    table = simple.GetColorTransferFunction(array)
    table.ApplyPreset("Cool to Warm", True)
    largest = max(abs(end) for end in data.PointData[array].GetRange()) or 1.0
    table.RescaleTransferFunction(-largest, largest)
    display.SetScalarBarVisibility(view, True)


def _show_histogram(result, view):
    """How often each distance occurs, in a view below, in the same colours."""
    layout, chart = simple.GetLayout(view), simple.CreateView("XYHistogramChartView")
    place = layout.SplitVertical(layout.GetViewLocation(view), 0.7)
    layout.AssignView(place + 1, chart)
    bars = simple.Show(simple.OutputPort(result, 0), chart)
    bars.SelectInputArray = ["POINTS", "Distance"]
    bars.BinCount = 60
    bars.LookupTable = simple.GetColorTransferFunction("Distance")
    bars.UseColorMapping = 1
    chart.ShowLegend = 0
    chart.LeftAxisTitle, chart.BottomAxisTitle = "Points", "Distance"
    simple.SetActiveView(view)
