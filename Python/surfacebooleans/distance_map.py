# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Shows the result of Surface Distance, or of Surface Distance Field, in colours that diverge about zero."""


def show_distance(proxy=None, view=None, array="Distance"):
    """Show the proxy (the active one by default) coloured by its distance, and return its representation.

    White is zero, blue inside (negative), red outside; the range is symmetric, so that equal distances on both sides
    have equally strong colours. The legend is shown.
    """
    from paraview import simple

    proxy = proxy or simple.GetActiveSource()
    view = view or simple.GetActiveViewOrCreate("RenderView")
    proxy.UpdatePipeline()
    values = proxy.PointData[array]
    if values is None:
        raise ValueError(f"there is no point array {array}; apply Surface Distance first")
    shown = simple.Show(proxy, view)
    if shown.Representation == "Outline":
        shown.SetRepresentationType("Slice")  # an image
    simple.ColorBy(shown, ("POINTS", array))
    colours = simple.GetColorTransferFunction(array)
    colours.ApplyPreset("Cool to Warm", True)
    largest = max(abs(end) for end in values.GetRange()) or 1.0
    colours.RescaleTransferFunction(-largest, largest)
    simple.GetOpacityTransferFunction(array).RescaleTransferFunction(-largest, largest)
    colours.AutomaticRescaleRangeMode = "Never"  # it would lose the symmetry
    shown.SetScalarBarVisibility(view, True)
    simple.Render(view)
    return shown
