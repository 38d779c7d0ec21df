# trace generated using paraview version 5.11.0
#import paraview
#paraview.compatibility.major = 5
#paraview.compatibility.minor = 11

#### import the simple module from the paraview
from paraview.simple import *
#### disable automatic camera reset on 'Show'
paraview.simple._DisableFirstRenderCameraReset()

# create a new 'Sphere'
sphere1 = Sphere(registrationName='Sphere1')

# get active view
renderView1 = GetActiveViewOrCreate('RenderView')

# show data in view
sphere1Display = Show(sphere1, renderView1, 'GeometryRepresentation')

# trace defaults for the display properties.
sphere1Display.Representation = 'Surface'
sphere1Display.ColorArrayName = [None, '']
sphere1Display.SelectTCoordArray = 'None'
sphere1Display.SelectNormalArray = 'Normals'
sphere1Display.SelectTangentArray = 'None'
sphere1Display.OSPRayScaleArray = 'Normals'
sphere1Display.OSPRayScaleFunction = 'PiecewiseFunction'
sphere1Display.SelectOrientationVectors = 'None'
sphere1Display.ScaleFactor = 0.1
sphere1Display.SelectScaleArray = 'None'
sphere1Display.GlyphType = 'Arrow'
sphere1Display.GlyphTableIndexArray = 'None'
sphere1Display.GaussianRadius = 0.005
sphere1Display.SetScaleArray = ['POINTS', 'Normals']
sphere1Display.ScaleTransferFunction = 'PiecewiseFunction'
sphere1Display.OpacityArray = ['POINTS', 'Normals']
sphere1Display.OpacityTransferFunction = 'PiecewiseFunction'
sphere1Display.DataAxesGrid = 'GridAxesRepresentation'
sphere1Display.PolarAxes = 'PolarAxesRepresentation'
sphere1Display.SelectInputVectors = ['POINTS', 'Normals']
sphere1Display.WriteLog = ''

# init the 'PiecewiseFunction' selected for 'ScaleTransferFunction'
sphere1Display.ScaleTransferFunction.Points = [-0.9749279022216797, 0.0, 0.5, 0.0, 0.9749279022216797, 1.0, 0.5, 0.0]

# init the 'PiecewiseFunction' selected for 'OpacityTransferFunction'
sphere1Display.OpacityTransferFunction.Points = [-0.9749279022216797, 0.0, 0.5, 0.0, 0.9749279022216797, 1.0, 0.5, 0.0]

# reset view to fit data
renderView1.ResetCamera(False)

# update the view to ensure updated data information
renderView1.Update()

# create a new 'Sphere'
sphere2 = Sphere(registrationName='Sphere2')

# Properties modified on sphere2
sphere2.Center = [0.3, 0.0, 0.0]

# show data in view
sphere2Display = Show(sphere2, renderView1, 'GeometryRepresentation')

# trace defaults for the display properties.
sphere2Display.Representation = 'Surface'
sphere2Display.ColorArrayName = [None, '']
sphere2Display.SelectTCoordArray = 'None'
sphere2Display.SelectNormalArray = 'Normals'
sphere2Display.SelectTangentArray = 'None'
sphere2Display.OSPRayScaleArray = 'Normals'
sphere2Display.OSPRayScaleFunction = 'PiecewiseFunction'
sphere2Display.SelectOrientationVectors = 'None'
sphere2Display.ScaleFactor = 0.1
sphere2Display.SelectScaleArray = 'None'
sphere2Display.GlyphType = 'Arrow'
sphere2Display.GlyphTableIndexArray = 'None'
sphere2Display.GaussianRadius = 0.005
sphere2Display.SetScaleArray = ['POINTS', 'Normals']
sphere2Display.ScaleTransferFunction = 'PiecewiseFunction'
sphere2Display.OpacityArray = ['POINTS', 'Normals']
sphere2Display.OpacityTransferFunction = 'PiecewiseFunction'
sphere2Display.DataAxesGrid = 'GridAxesRepresentation'
sphere2Display.PolarAxes = 'PolarAxesRepresentation'
sphere2Display.SelectInputVectors = ['POINTS', 'Normals']
sphere2Display.WriteLog = ''

# init the 'PiecewiseFunction' selected for 'ScaleTransferFunction'
sphere2Display.ScaleTransferFunction.Points = [-0.9749279022216797, 0.0, 0.5, 0.0, 0.9749279022216797, 1.0, 0.5, 0.0]

# init the 'PiecewiseFunction' selected for 'OpacityTransferFunction'
sphere2Display.OpacityTransferFunction.Points = [-0.9749279022216797, 0.0, 0.5, 0.0, 0.9749279022216797, 1.0, 0.5, 0.0]

# update the view to ensure updated data information
renderView1.Update()

# create a new 'Surface Boolean'
surfaceBoolean1 = SurfaceBoolean(registrationName='SurfaceBoolean1', Input=sphere1,
    Tool=sphere2)

# Properties modified on surfaceBoolean1
surfaceBoolean1.Operation = 'Difference'

# show data in view
surfaceBoolean1Display = Show(surfaceBoolean1, renderView1, 'GeometryRepresentation')

# get color transfer function/color map for 'SourceId'
sourceIdLUT = GetColorTransferFunction('SourceId')

# trace defaults for the display properties.
surfaceBoolean1Display.Representation = 'Surface'
surfaceBoolean1Display.ColorArrayName = ['CELLS', 'SourceId']
surfaceBoolean1Display.LookupTable = sourceIdLUT
surfaceBoolean1Display.SelectTCoordArray = 'None'
surfaceBoolean1Display.SelectNormalArray = 'Normals'
surfaceBoolean1Display.SelectTangentArray = 'None'
surfaceBoolean1Display.OSPRayScaleArray = 'Normals'
surfaceBoolean1Display.OSPRayScaleFunction = 'PiecewiseFunction'
surfaceBoolean1Display.SelectOrientationVectors = 'None'
surfaceBoolean1Display.ScaleFactor = 0.1
surfaceBoolean1Display.SelectScaleArray = 'SourceId'
surfaceBoolean1Display.GlyphType = 'Arrow'
surfaceBoolean1Display.GlyphTableIndexArray = 'SourceId'
surfaceBoolean1Display.GaussianRadius = 0.005
surfaceBoolean1Display.SetScaleArray = ['POINTS', 'Normals']
surfaceBoolean1Display.ScaleTransferFunction = 'PiecewiseFunction'
surfaceBoolean1Display.OpacityArray = ['POINTS', 'Normals']
surfaceBoolean1Display.OpacityTransferFunction = 'PiecewiseFunction'
surfaceBoolean1Display.DataAxesGrid = 'GridAxesRepresentation'
surfaceBoolean1Display.PolarAxes = 'PolarAxesRepresentation'
surfaceBoolean1Display.SelectInputVectors = ['POINTS', 'Normals']
surfaceBoolean1Display.WriteLog = ''

# init the 'PiecewiseFunction' selected for 'ScaleTransferFunction'
surfaceBoolean1Display.ScaleTransferFunction.Points = [-0.9749279022216797, 0.0, 0.5, 0.0, 0.9749279022216797, 1.0, 0.5, 0.0]

# init the 'PiecewiseFunction' selected for 'OpacityTransferFunction'
surfaceBoolean1Display.OpacityTransferFunction.Points = [-0.9749279022216797, 0.0, 0.5, 0.0, 0.9749279022216797, 1.0, 0.5, 0.0]

# hide data in view
Hide(sphere1, renderView1)

# hide data in view
Hide(sphere2, renderView1)

# show color bar/color legend
surfaceBoolean1Display.SetScalarBarVisibility(renderView1, True)

# update the view to ensure updated data information
renderView1.Update()

# get opacity transfer function/opacity map for 'SourceId'
sourceIdPWF = GetOpacityTransferFunction('SourceId')

# get 2D transfer function for 'SourceId'
sourceIdTF2D = GetTransferFunction2D('SourceId')

#================================================================
# addendum: following script captures some of the application
# state to faithfully reproduce the visualization during playback
#================================================================

# get layout
layout1 = GetLayout()

#--------------------------------
# saving layout sizes for layouts

# layout/tab size in pixels
layout1.SetSize(844, 279)

#-----------------------------------
# saving camera placements for views

# current camera placement for renderView1
renderView1.CameraPosition = [0.0, 0.0, 3.2903743041222895]
renderView1.CameraParallelScale = 0.8516115354228021

#--------------------------------------------
# uncomment the following to render all views
# RenderAllViews()
# alternatively, if you want to write images, you can use SaveScreenshot(...).