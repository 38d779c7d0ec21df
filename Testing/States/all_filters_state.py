# state file generated using paraview version 5.11.0
import paraview
paraview.compatibility.major = 5
paraview.compatibility.minor = 11

#### import the simple module from the paraview
from paraview.simple import *
#### disable automatic camera reset on 'Show'
paraview.simple._DisableFirstRenderCameraReset()

# ----------------------------------------------------------------
# setup views used in the visualization
# ----------------------------------------------------------------

# Create a new 'Render View'
renderView1 = CreateView('RenderView')
renderView1.AxesGrid = 'GridAxes3DActor'
renderView1.OrientationAxesVisibility = 0
renderView1.StereoType = 0
renderView1.CameraPosition = [1.95, -1.2, 10.0]
renderView1.CameraFocalPoint = [1.95, -1.2, 0.0]
renderView1.CameraFocalDisk = 1.0
renderView1.CameraParallelScale = 2.15
renderView1.CameraParallelProjection = 1

SetActiveView(None)

# ----------------------------------------------------------------
# setup view layouts
# ----------------------------------------------------------------

# create new layout object 'All filters'
allfilters = CreateLayout(name='All filters')
allfilters.AssignView(0, renderView1)
allfilters.SetSize(400, 400)

# ----------------------------------------------------------------
# restore active view
SetActiveView(renderView1)
# ----------------------------------------------------------------

# ----------------------------------------------------------------
# setup the data processing pipelines
# ----------------------------------------------------------------

# create a new 'Legacy VTK Reader'
kittenvtk = LegacyVTKReader(registrationName='kitten.vtk', FileNames=['data/kitten.vtk'])

# create a new 'Legacy VTK Reader'
knotvtk = LegacyVTKReader(registrationName='knot.vtk', FileNames=['data/knot.vtk'])

# create a new 'Transform'
tool = Transform(registrationName='Tool', Input=knotvtk)
tool.Transform = 'Transform'

# init the 'Transform' selected for 'Transform'
tool.Transform.Translate = [0.05, 0.02, 0.1]

# create a new 'Point Set Surface'
skin = PointSetSurface(registrationName='Skin', Input=kittenvtk)
skin.GenerateSurface = 1
skin.CellSize = 0.03

# create a new 'NURBS Reader'
screwstep = NURBSReader(registrationName='screw.step', FileName='data/screw.step')
screwstep.ChordError = 0.002

# create a new 'Legacy VTK Reader'
elephantvtk = LegacyVTKReader(registrationName='elephant.vtk', FileNames=['data/elephant.vtk'])

# create a new 'Surface Check'
check = SurfaceCheck(registrationName='Check', Input=elephantvtk)
check.SelfIntersections = 0

# create a new 'Surface Boolean'
drilled = SurfaceBoolean(registrationName='Drilled', Input=elephantvtk,
    Tool=tool)
drilled.Operation = 'Difference'

# create a new 'Closed Surface Clip'
clipped = ClosedSurfaceClip(registrationName='Clipped', Input=drilled)
clipped.Normal = [0.0, 0.2, 1.0]
clipped.Planes = [0.1, 0.0, 0.0, 1.0, 0.0, 0.0]
clipped.Box = [1.0, -1.0, 1.0, -1.0, 1.0, -1.0]
clipped.GenerateOutline = 1

# create a new 'Surface Distance Field'
field = SurfaceDistanceField(registrationName='Field', Input=drilled)
field.Dimensions = [24, 20, 28]
field.Margin = 0.02

# create a new 'Closed Surface Cut'
outline = ClosedSurfaceCut(registrationName='Outline', Input=drilled)
outline.Triangulate = 0

# create a new 'Contour Triangulator'
filled = ContourTriangulator(registrationName='Filled', Input=outline)

# create a new 'Closed Surface Cut'
slices = ClosedSurfaceCut(registrationName='Slices', Input=drilled)
slices.Normal = [1.0, 0.0, 0.0]
slices.Offsets = [-0.1, 0.0, 0.1, 0.2]
slices.Triangulate = 0

# create a new 'Transform'
screw = Transform(registrationName='Screw', Input=screwstep)
screw.Transform = 'Transform'

# init the 'Transform' selected for 'Transform'
screw.Transform.Translate = [0.7607, -0.73, -0.0356]
screw.Transform.Rotate = [-90.0, 0.0, 0.0]
screw.Transform.Scale = [0.0425, 0.0425, 0.0425]

# create a new 'Surface Intersection'
seam = SurfaceIntersection(registrationName='Seam', Input=elephantvtk,
    Tool=tool)
seam.SplitSecondOutput = 0

# create a new 'Surface Distance'
distance = SurfaceDistance(registrationName='Distance', Input=drilled,
    Tool=tool)
distance.ComputeSecondDistance = 1
distance.ComputeNearestPoint = 1

# create a new 'Point Set Intersection'
ring = PointSetIntersection(registrationName='Ring', Input=kittenvtk,
    Tool=screw)
ring.Plane = 'Plane'
ring.ChordError = 0.002

# create a new 'Point Set Boolean'
knob = PointSetBoolean(registrationName='Knob', Input=kittenvtk,
    Tool=screw)
knob.CellSize = 0.03

# ----------------------------------------------------------------
# setup the visualization in view 'renderView1'
# ----------------------------------------------------------------

# show data from drilled
drilledDisplay = Show(drilled, renderView1, 'GeometryRepresentation')

# get 2D transfer function for 'SourceId'
sourceIdTF2D = GetTransferFunction2D('SourceId')

# get color transfer function/color map for 'SourceId'
sourceIdLUT = GetColorTransferFunction('SourceId')
sourceIdLUT.AutomaticRescaleRangeMode = 'Never'
sourceIdLUT.TransferFunction2D = sourceIdTF2D
sourceIdLUT.RGBPoints = [0.0, 0.231373, 0.298039, 0.752941, 1.0, 0.865003, 0.865003, 0.865003, 2.0, 0.705882, 0.0156863, 0.14902]
sourceIdLUT.ScalarRangeInitialized = 1.0

# trace defaults for the display properties.
drilledDisplay.Representation = 'Surface'
drilledDisplay.ColorArrayName = ['CELLS', 'SourceId']
drilledDisplay.LookupTable = sourceIdLUT
drilledDisplay.LineWidth = 2.0
drilledDisplay.SelectTCoordArray = 'None'
drilledDisplay.SelectNormalArray = 'None'
drilledDisplay.SelectTangentArray = 'None'
drilledDisplay.OSPRayScaleFunction = 'PiecewiseFunction'
drilledDisplay.SelectOrientationVectors = 'None'
drilledDisplay.ScaleFactor = 0.14576468401387074
drilledDisplay.SelectScaleArray = 'SourceId'
drilledDisplay.GlyphType = 'Arrow'
drilledDisplay.GlyphTableIndexArray = 'SourceId'
drilledDisplay.GaussianRadius = 0.007288234200693537
drilledDisplay.SetScaleArray = [None, '']
drilledDisplay.ScaleTransferFunction = 'PiecewiseFunction'
drilledDisplay.OpacityArray = [None, '']
drilledDisplay.OpacityTransferFunction = 'PiecewiseFunction'
drilledDisplay.DataAxesGrid = 'GridAxesRepresentation'
drilledDisplay.PolarAxes = 'PolarAxesRepresentation'
drilledDisplay.SelectInputVectors = [None, '']
drilledDisplay.WriteLog = ''

# find source
seam_1 = FindSource('Seam')

# show data from seam_1
seam_1Display = Show(OutputPort(seam_1, 1), renderView1, 'GeometryRepresentation')

# get 2D transfer function for 'PatchId'
patchIdTF2D = GetTransferFunction2D('PatchId')

# get color transfer function/color map for 'PatchId'
patchIdLUT = GetColorTransferFunction('PatchId')
patchIdLUT.AutomaticRescaleRangeMode = 'Never'
patchIdLUT.TransferFunction2D = patchIdTF2D
patchIdLUT.RGBPoints = [0.0, 0.231373, 0.298039, 0.752941, 4.5, 0.865003, 0.865003, 0.865003, 9.0, 0.705882, 0.0156863, 0.14902]
patchIdLUT.ScalarRangeInitialized = 1.0

# trace defaults for the display properties.
seam_1Display.Representation = 'Surface'
seam_1Display.ColorArrayName = ['CELLS', 'PatchId']
seam_1Display.LookupTable = patchIdLUT
seam_1Display.LineWidth = 2.0
seam_1Display.SelectTCoordArray = 'None'
seam_1Display.SelectNormalArray = 'None'
seam_1Display.SelectTangentArray = 'None'
seam_1Display.Position = [1.3, -0.0, 0.0]
seam_1Display.OSPRayScaleArray = 'SeamPoint'
seam_1Display.OSPRayScaleFunction = 'PiecewiseFunction'
seam_1Display.SelectOrientationVectors = 'None'
seam_1Display.ScaleFactor = 0.14576468401387074
seam_1Display.SelectScaleArray = 'PatchId'
seam_1Display.GlyphType = 'Arrow'
seam_1Display.GlyphTableIndexArray = 'PatchId'
seam_1Display.GaussianRadius = 0.007288234200693537
seam_1Display.SetScaleArray = ['POINTS', 'SeamPoint']
seam_1Display.ScaleTransferFunction = 'PiecewiseFunction'
seam_1Display.OpacityArray = ['POINTS', 'SeamPoint']
seam_1Display.OpacityTransferFunction = 'PiecewiseFunction'
seam_1Display.DataAxesGrid = 'GridAxesRepresentation'
seam_1Display.PolarAxes = 'PolarAxesRepresentation'
seam_1Display.SelectInputVectors = [None, '']
seam_1Display.WriteLog = ''

# init the 'PolarAxesRepresentation' selected for 'PolarAxes'
seam_1Display.PolarAxes.Translation = [1.3, -0.0, 0.0]

# show data from distance
distanceDisplay = Show(distance, renderView1, 'GeometryRepresentation')

# get 2D transfer function for 'Distance'
distanceTF2D = GetTransferFunction2D('Distance')
distanceTF2D.ScalarRangeInitialized = 1
distanceTF2D.Range = [-0.10510463267564774, 0.8816996812820435, 0.0, 1.0]

# get color transfer function/color map for 'Distance'
distanceLUT = GetColorTransferFunction('Distance')
distanceLUT.AutomaticRescaleRangeMode = 'Never'
distanceLUT.TransferFunction2D = distanceTF2D
distanceLUT.RGBPoints = [-0.10510463267564774, 0.231373, 0.298039, 0.752941, 0.38829752430319786, 0.865003, 0.865003, 0.865003, 0.8816996812820435, 0.705882, 0.0156863, 0.14902]
distanceLUT.ScalarRangeInitialized = 1.0

# trace defaults for the display properties.
distanceDisplay.Representation = 'Surface'
distanceDisplay.ColorArrayName = ['POINTS', 'Distance']
distanceDisplay.LookupTable = distanceLUT
distanceDisplay.LineWidth = 2.0
distanceDisplay.SelectTCoordArray = 'None'
distanceDisplay.SelectNormalArray = 'None'
distanceDisplay.SelectTangentArray = 'None'
distanceDisplay.Position = [2.6, -0.0, 0.0]
distanceDisplay.OSPRayScaleArray = 'Distance'
distanceDisplay.OSPRayScaleFunction = 'PiecewiseFunction'
distanceDisplay.SelectOrientationVectors = 'NearestPoint'
distanceDisplay.ScaleFactor = 0.14576468401387074
distanceDisplay.SelectScaleArray = 'Distance'
distanceDisplay.GlyphType = 'Arrow'
distanceDisplay.GlyphTableIndexArray = 'Distance'
distanceDisplay.GaussianRadius = 0.007288234200693537
distanceDisplay.SetScaleArray = ['POINTS', 'Distance']
distanceDisplay.ScaleTransferFunction = 'PiecewiseFunction'
distanceDisplay.OpacityArray = ['POINTS', 'Distance']
distanceDisplay.OpacityTransferFunction = 'PiecewiseFunction'
distanceDisplay.DataAxesGrid = 'GridAxesRepresentation'
distanceDisplay.PolarAxes = 'PolarAxesRepresentation'
distanceDisplay.SelectInputVectors = ['POINTS', 'NearestPoint']
distanceDisplay.WriteLog = ''

# init the 'PiecewiseFunction' selected for 'ScaleTransferFunction'
distanceDisplay.ScaleTransferFunction.Points = [-1.5480167619625066e-16, 0.0, 0.5, 0.0, 0.4311649916789658, 1.0, 0.5, 0.0]

# init the 'PiecewiseFunction' selected for 'OpacityTransferFunction'
distanceDisplay.OpacityTransferFunction.Points = [-1.5480167619625066e-16, 0.0, 0.5, 0.0, 0.4311649916789658, 1.0, 0.5, 0.0]

# init the 'PolarAxesRepresentation' selected for 'PolarAxes'
distanceDisplay.PolarAxes.Translation = [2.6, -0.0, 0.0]

# show data from field
fieldDisplay = Show(field, renderView1, 'UniformGridRepresentation')

# get opacity transfer function/opacity map for 'Distance'
distancePWF = GetOpacityTransferFunction('Distance')
distancePWF.Points = [-0.10510463267564774, 0.0, 0.5, 0.0, 0.8816996812820435, 1.0, 0.5, 0.0]
distancePWF.ScalarRangeInitialized = 1

# trace defaults for the display properties.
fieldDisplay.Representation = 'Surface'
fieldDisplay.ColorArrayName = ['POINTS', 'Distance']
fieldDisplay.LookupTable = distanceLUT
fieldDisplay.LineWidth = 2.0
fieldDisplay.SelectTCoordArray = 'None'
fieldDisplay.SelectNormalArray = 'None'
fieldDisplay.SelectTangentArray = 'None'
fieldDisplay.Position = [3.9000000000000004, -0.0, 0.0]
fieldDisplay.OSPRayScaleArray = 'Distance'
fieldDisplay.OSPRayScaleFunction = 'PiecewiseFunction'
fieldDisplay.SelectOrientationVectors = 'None'
fieldDisplay.ScaleFactor = 0.15159527137442558
fieldDisplay.SelectScaleArray = 'Distance'
fieldDisplay.GlyphType = 'Arrow'
fieldDisplay.GlyphTableIndexArray = 'Distance'
fieldDisplay.GaussianRadius = 0.007579763568721278
fieldDisplay.SetScaleArray = ['POINTS', 'Distance']
fieldDisplay.ScaleTransferFunction = 'PiecewiseFunction'
fieldDisplay.OpacityArray = ['POINTS', 'Distance']
fieldDisplay.OpacityTransferFunction = 'PiecewiseFunction'
fieldDisplay.DataAxesGrid = 'GridAxesRepresentation'
fieldDisplay.PolarAxes = 'PolarAxesRepresentation'
fieldDisplay.ScalarOpacityUnitDistance = 0.0921928979029117
fieldDisplay.ScalarOpacityFunction = distancePWF
fieldDisplay.TransferFunction2D = distanceTF2D
fieldDisplay.OpacityArrayName = ['POINTS', 'Distance']
fieldDisplay.ColorArray2Name = ['POINTS', 'Distance']
fieldDisplay.IsosurfaceValues = [0.38829752430319786]
fieldDisplay.SliceFunction = 'Plane'
fieldDisplay.Slice = 13
fieldDisplay.SelectInputVectors = [None, '']
fieldDisplay.WriteLog = ''

# init the 'PiecewiseFunction' selected for 'ScaleTransferFunction'
fieldDisplay.ScaleTransferFunction.Points = [-0.10510463267564774, 0.0, 0.5, 0.0, 0.8816996812820435, 1.0, 0.5, 0.0]

# init the 'PiecewiseFunction' selected for 'OpacityTransferFunction'
fieldDisplay.OpacityTransferFunction.Points = [-0.10510463267564774, 0.0, 0.5, 0.0, 0.8816996812820435, 1.0, 0.5, 0.0]

# init the 'PolarAxesRepresentation' selected for 'PolarAxes'
fieldDisplay.PolarAxes.Translation = [3.9000000000000004, -0.0, 0.0]

# show data from check
checkDisplay = Show(check, renderView1, 'GeometryRepresentation')

# get 2D transfer function for 'ShellId'
shellIdTF2D = GetTransferFunction2D('ShellId')

# get color transfer function/color map for 'ShellId'
shellIdLUT = GetColorTransferFunction('ShellId')
shellIdLUT.AutomaticRescaleRangeMode = 'Never'
shellIdLUT.TransferFunction2D = shellIdTF2D
shellIdLUT.RGBPoints = [0.0, 0.231373, 0.298039, 0.752941, 5.878906683738906e-39, 0.865003, 0.865003, 0.865003, 1.1757813367477812e-38, 0.705882, 0.0156863, 0.14902]
shellIdLUT.ScalarRangeInitialized = 1.0

# trace defaults for the display properties.
checkDisplay.Representation = 'Surface'
checkDisplay.ColorArrayName = ['CELLS', 'ShellId']
checkDisplay.LookupTable = shellIdLUT
checkDisplay.LineWidth = 2.0
checkDisplay.SelectTCoordArray = 'None'
checkDisplay.SelectNormalArray = 'None'
checkDisplay.SelectTangentArray = 'None'
checkDisplay.Position = [0.0, -1.3, 0.0]
checkDisplay.OSPRayScaleArray = 'DuplicatePoint'
checkDisplay.OSPRayScaleFunction = 'PiecewiseFunction'
checkDisplay.SelectOrientationVectors = 'None'
checkDisplay.ScaleFactor = 0.14576468401387074
checkDisplay.SelectScaleArray = 'Defect'
checkDisplay.GlyphType = 'Arrow'
checkDisplay.GlyphTableIndexArray = 'Defect'
checkDisplay.GaussianRadius = 0.007288234200693537
checkDisplay.SetScaleArray = ['POINTS', 'DuplicatePoint']
checkDisplay.ScaleTransferFunction = 'PiecewiseFunction'
checkDisplay.OpacityArray = ['POINTS', 'DuplicatePoint']
checkDisplay.OpacityTransferFunction = 'PiecewiseFunction'
checkDisplay.DataAxesGrid = 'GridAxesRepresentation'
checkDisplay.PolarAxes = 'PolarAxesRepresentation'
checkDisplay.SelectInputVectors = [None, '']
checkDisplay.WriteLog = ''

# init the 'PiecewiseFunction' selected for 'ScaleTransferFunction'
checkDisplay.ScaleTransferFunction.Points = [0.0, 0.0, 0.5, 0.0, 1.1757813367477812e-38, 1.0, 0.5, 0.0]

# init the 'PiecewiseFunction' selected for 'OpacityTransferFunction'
checkDisplay.OpacityTransferFunction.Points = [0.0, 0.0, 0.5, 0.0, 1.1757813367477812e-38, 1.0, 0.5, 0.0]

# init the 'PolarAxesRepresentation' selected for 'PolarAxes'
checkDisplay.PolarAxes.Translation = [0.0, -1.3, 0.0]

# show data from clipped
clippedDisplay = Show(clipped, renderView1, 'GeometryRepresentation')

# trace defaults for the display properties.
clippedDisplay.Representation = 'Surface'
clippedDisplay.ColorArrayName = ['CELLS', 'SourceId']
clippedDisplay.LookupTable = sourceIdLUT
clippedDisplay.LineWidth = 2.0
clippedDisplay.SelectTCoordArray = 'None'
clippedDisplay.SelectNormalArray = 'None'
clippedDisplay.SelectTangentArray = 'None'
clippedDisplay.Position = [1.3, -1.3, 0.0]
clippedDisplay.OSPRayScaleFunction = 'PiecewiseFunction'
clippedDisplay.SelectOrientationVectors = 'None'
clippedDisplay.ScaleFactor = 0.11402101227323301
clippedDisplay.SelectScaleArray = 'SourceId'
clippedDisplay.GlyphType = 'Arrow'
clippedDisplay.GlyphTableIndexArray = 'SourceId'
clippedDisplay.GaussianRadius = 0.00570105061366165
clippedDisplay.SetScaleArray = [None, '']
clippedDisplay.ScaleTransferFunction = 'PiecewiseFunction'
clippedDisplay.OpacityArray = [None, '']
clippedDisplay.OpacityTransferFunction = 'PiecewiseFunction'
clippedDisplay.DataAxesGrid = 'GridAxesRepresentation'
clippedDisplay.PolarAxes = 'PolarAxesRepresentation'
clippedDisplay.SelectInputVectors = [None, '']
clippedDisplay.WriteLog = ''

# init the 'PolarAxesRepresentation' selected for 'PolarAxes'
clippedDisplay.PolarAxes.Translation = [1.3, -1.3, 0.0]

# show data from slices
slicesDisplay = Show(slices, renderView1, 'GeometryRepresentation')

# get 2D transfer function for 'Area'
areaTF2D = GetTransferFunction2D('Area')

# get color transfer function/color map for 'Area'
areaLUT = GetColorTransferFunction('Area')
areaLUT.AutomaticRescaleRangeMode = 'Never'
areaLUT.TransferFunction2D = areaTF2D
areaLUT.RGBPoints = [0.0036059240712031934, 0.231373, 0.298039, 0.752941, 0.06504185885537248, 0.865003, 0.865003, 0.865003, 0.12647779363954176, 0.705882, 0.0156863, 0.14902]
areaLUT.ScalarRangeInitialized = 1.0

# trace defaults for the display properties.
slicesDisplay.Representation = 'Surface'
slicesDisplay.ColorArrayName = ['CELLS', 'Area']
slicesDisplay.LookupTable = areaLUT
slicesDisplay.LineWidth = 2.0
slicesDisplay.SelectTCoordArray = 'None'
slicesDisplay.SelectNormalArray = 'None'
slicesDisplay.SelectTangentArray = 'None'
slicesDisplay.Position = [2.6, -1.3, 0.0]
slicesDisplay.OSPRayScaleFunction = 'PiecewiseFunction'
slicesDisplay.SelectOrientationVectors = 'None'
slicesDisplay.ScaleFactor = 0.12823249815376267
slicesDisplay.SelectScaleArray = 'None'
slicesDisplay.GlyphType = 'Arrow'
slicesDisplay.GlyphTableIndexArray = 'None'
slicesDisplay.GaussianRadius = 0.006411624907688134
slicesDisplay.SetScaleArray = [None, '']
slicesDisplay.ScaleTransferFunction = 'PiecewiseFunction'
slicesDisplay.OpacityArray = [None, '']
slicesDisplay.OpacityTransferFunction = 'PiecewiseFunction'
slicesDisplay.DataAxesGrid = 'GridAxesRepresentation'
slicesDisplay.PolarAxes = 'PolarAxesRepresentation'
slicesDisplay.SelectInputVectors = [None, '']
slicesDisplay.WriteLog = ''

# init the 'PolarAxesRepresentation' selected for 'PolarAxes'
slicesDisplay.PolarAxes.Translation = [2.6, -1.3, 0.0]

# show data from filled
filledDisplay = Show(filled, renderView1, 'GeometryRepresentation')

# get 2D transfer function for 'PolygonId'
polygonIdTF2D = GetTransferFunction2D('PolygonId')

# get color transfer function/color map for 'PolygonId'
polygonIdLUT = GetColorTransferFunction('PolygonId')
polygonIdLUT.AutomaticRescaleRangeMode = 'Never'
polygonIdLUT.TransferFunction2D = polygonIdTF2D
polygonIdLUT.RGBPoints = [0.0, 0.231373, 0.298039, 0.752941, 1.0, 0.865003, 0.865003, 0.865003, 2.0, 0.705882, 0.0156863, 0.14902]
polygonIdLUT.ScalarRangeInitialized = 1.0

# trace defaults for the display properties.
filledDisplay.Representation = 'Surface'
filledDisplay.ColorArrayName = ['CELLS', 'PolygonId']
filledDisplay.LookupTable = polygonIdLUT
filledDisplay.LineWidth = 2.0
filledDisplay.SelectTCoordArray = 'None'
filledDisplay.SelectNormalArray = 'None'
filledDisplay.SelectTangentArray = 'None'
filledDisplay.Position = [3.9000000000000004, -1.3, 0.0]
filledDisplay.OSPRayScaleFunction = 'PiecewiseFunction'
filledDisplay.SelectOrientationVectors = 'None'
filledDisplay.ScaleFactor = 0.09990055909667028
filledDisplay.SelectScaleArray = 'None'
filledDisplay.GlyphType = 'Arrow'
filledDisplay.GlyphTableIndexArray = 'None'
filledDisplay.GaussianRadius = 0.004995027954833514
filledDisplay.SetScaleArray = [None, '']
filledDisplay.ScaleTransferFunction = 'PiecewiseFunction'
filledDisplay.OpacityArray = [None, '']
filledDisplay.OpacityTransferFunction = 'PiecewiseFunction'
filledDisplay.DataAxesGrid = 'GridAxesRepresentation'
filledDisplay.PolarAxes = 'PolarAxesRepresentation'
filledDisplay.SelectInputVectors = [None, '']
filledDisplay.WriteLog = ''

# init the 'PolarAxesRepresentation' selected for 'PolarAxes'
filledDisplay.PolarAxes.Translation = [3.9000000000000004, -1.3, 0.0]

# find source
skin_1 = FindSource('Skin')

# show data from skin_1
skin_1Display = Show(OutputPort(skin_1, 1), renderView1, 'GeometryRepresentation')

# get 2D transfer function for 'MeanCurvature'
meanCurvatureTF2D = GetTransferFunction2D('MeanCurvature')

# get color transfer function/color map for 'MeanCurvature'
meanCurvatureLUT = GetColorTransferFunction('MeanCurvature')
meanCurvatureLUT.AutomaticRescaleRangeMode = 'Never'
meanCurvatureLUT.TransferFunction2D = meanCurvatureTF2D
meanCurvatureLUT.RGBPoints = [-11.054431936590571, 0.231373, 0.298039, 0.752941, 6.9614629279342815, 0.865003, 0.865003, 0.865003, 24.977357792459134, 0.705882, 0.0156863, 0.14902]
meanCurvatureLUT.ScalarRangeInitialized = 1.0

# trace defaults for the display properties.
skin_1Display.Representation = 'Surface'
skin_1Display.ColorArrayName = ['POINTS', 'MeanCurvature']
skin_1Display.LookupTable = meanCurvatureLUT
skin_1Display.LineWidth = 2.0
skin_1Display.SelectTCoordArray = 'None'
skin_1Display.SelectNormalArray = 'Normals'
skin_1Display.SelectTangentArray = 'None'
skin_1Display.Position = [0.0, -2.6, 0.0]
skin_1Display.OSPRayScaleArray = 'GaussCurvature'
skin_1Display.OSPRayScaleFunction = 'PiecewiseFunction'
skin_1Display.SelectOrientationVectors = 'None'
skin_1Display.ScaleFactor = 0.09855957225418283
skin_1Display.SelectScaleArray = 'GaussCurvature'
skin_1Display.GlyphType = 'Arrow'
skin_1Display.GlyphTableIndexArray = 'GaussCurvature'
skin_1Display.GaussianRadius = 0.004927978612709141
skin_1Display.SetScaleArray = ['POINTS', 'GaussCurvature']
skin_1Display.ScaleTransferFunction = 'PiecewiseFunction'
skin_1Display.OpacityArray = ['POINTS', 'GaussCurvature']
skin_1Display.OpacityTransferFunction = 'PiecewiseFunction'
skin_1Display.DataAxesGrid = 'GridAxesRepresentation'
skin_1Display.PolarAxes = 'PolarAxesRepresentation'
skin_1Display.SelectInputVectors = ['POINTS', 'Normals']
skin_1Display.WriteLog = ''

# init the 'PiecewiseFunction' selected for 'ScaleTransferFunction'
skin_1Display.ScaleTransferFunction.Points = [-664.1981173779839, 0.0, 0.5, 0.0, 540.3644544826818, 1.0, 0.5, 0.0]

# init the 'PiecewiseFunction' selected for 'OpacityTransferFunction'
skin_1Display.OpacityTransferFunction.Points = [-664.1981173779839, 0.0, 0.5, 0.0, 540.3644544826818, 1.0, 0.5, 0.0]

# init the 'PolarAxesRepresentation' selected for 'PolarAxes'
skin_1Display.PolarAxes.Translation = [0.0, -2.6, 0.0]

# show data from ring
ringDisplay = Show(ring, renderView1, 'GeometryRepresentation')

# get 2D transfer function for 'Curvature'
curvatureTF2D = GetTransferFunction2D('Curvature')

# get color transfer function/color map for 'Curvature'
curvatureLUT = GetColorTransferFunction('Curvature')
curvatureLUT.AutomaticRescaleRangeMode = 'Never'
curvatureLUT.TransferFunction2D = curvatureTF2D
curvatureLUT.RGBPoints = [-22.180411127024357, 0.231373, 0.298039, 0.752941, -7.652423456875274, 0.865003, 0.865003, 0.865003, 6.875564213273808, 0.705882, 0.0156863, 0.14902]
curvatureLUT.ScalarRangeInitialized = 1.0

# trace defaults for the display properties.
ringDisplay.Representation = 'Surface'
ringDisplay.ColorArrayName = ['POINTS', 'Curvature']
ringDisplay.LookupTable = curvatureLUT
ringDisplay.LineWidth = 2.0
ringDisplay.SelectTCoordArray = 'None'
ringDisplay.SelectNormalArray = 'Normals'
ringDisplay.SelectTangentArray = 'None'
ringDisplay.Position = [1.3, -2.6, 0.0]
ringDisplay.OSPRayScaleArray = 'Curvature'
ringDisplay.OSPRayScaleFunction = 'PiecewiseFunction'
ringDisplay.SelectOrientationVectors = 'None'
ringDisplay.ScaleFactor = 0.03961919890488067
ringDisplay.SelectScaleArray = 'Curvature'
ringDisplay.GlyphType = 'Arrow'
ringDisplay.GlyphTableIndexArray = 'Curvature'
ringDisplay.GaussianRadius = 0.0019809599452440337
ringDisplay.SetScaleArray = ['POINTS', 'Curvature']
ringDisplay.ScaleTransferFunction = 'PiecewiseFunction'
ringDisplay.OpacityArray = ['POINTS', 'Curvature']
ringDisplay.OpacityTransferFunction = 'PiecewiseFunction'
ringDisplay.DataAxesGrid = 'GridAxesRepresentation'
ringDisplay.PolarAxes = 'PolarAxesRepresentation'
ringDisplay.SelectInputVectors = ['POINTS', 'Normals']
ringDisplay.WriteLog = ''

# init the 'PiecewiseFunction' selected for 'ScaleTransferFunction'
ringDisplay.ScaleTransferFunction.Points = [-22.180411127024357, 0.0, 0.5, 0.0, 6.875564213273808, 1.0, 0.5, 0.0]

# init the 'PiecewiseFunction' selected for 'OpacityTransferFunction'
ringDisplay.OpacityTransferFunction.Points = [-22.180411127024357, 0.0, 0.5, 0.0, 6.875564213273808, 1.0, 0.5, 0.0]

# init the 'PolarAxesRepresentation' selected for 'PolarAxes'
ringDisplay.PolarAxes.Translation = [1.3, -2.6, 0.0]

# show data from knob
knobDisplay = Show(knob, renderView1, 'GeometryRepresentation')

# trace defaults for the display properties.
knobDisplay.Representation = 'Surface'
knobDisplay.ColorArrayName = ['CELLS', 'SourceId']
knobDisplay.LookupTable = sourceIdLUT
knobDisplay.LineWidth = 2.0
knobDisplay.SelectTCoordArray = 'None'
knobDisplay.SelectNormalArray = 'None'
knobDisplay.SelectTangentArray = 'None'
knobDisplay.Position = [2.6, -2.6, 0.0]
knobDisplay.OSPRayScaleArray = 'Normals'
knobDisplay.OSPRayScaleFunction = 'PiecewiseFunction'
knobDisplay.SelectOrientationVectors = 'None'
knobDisplay.ScaleFactor = 0.2678228054964595
knobDisplay.SelectScaleArray = 'SourceId'
knobDisplay.GlyphType = 'Arrow'
knobDisplay.GlyphTableIndexArray = 'SourceId'
knobDisplay.GaussianRadius = 0.013391140274822973
knobDisplay.SetScaleArray = ['POINTS', 'Normals']
knobDisplay.ScaleTransferFunction = 'PiecewiseFunction'
knobDisplay.OpacityArray = ['POINTS', 'Normals']
knobDisplay.OpacityTransferFunction = 'PiecewiseFunction'
knobDisplay.DataAxesGrid = 'GridAxesRepresentation'
knobDisplay.PolarAxes = 'PolarAxesRepresentation'
knobDisplay.SelectInputVectors = ['POINTS', 'Normals']
knobDisplay.WriteLog = ''

# init the 'PiecewiseFunction' selected for 'ScaleTransferFunction'
knobDisplay.ScaleTransferFunction.Points = [-1.0, 0.0, 0.5, 0.0, 1.0, 1.0, 0.5, 0.0]

# init the 'PiecewiseFunction' selected for 'OpacityTransferFunction'
knobDisplay.OpacityTransferFunction.Points = [-1.0, 0.0, 0.5, 0.0, 1.0, 1.0, 0.5, 0.0]

# init the 'PolarAxesRepresentation' selected for 'PolarAxes'
knobDisplay.PolarAxes.Translation = [2.6, -2.6, 0.0]

# show data from screw
screwDisplay = Show(screw, renderView1, 'GeometryRepresentation')

# get 2D transfer function for 'FaceId'
faceIdTF2D = GetTransferFunction2D('FaceId')

# get color transfer function/color map for 'FaceId'
faceIdLUT = GetColorTransferFunction('FaceId')
faceIdLUT.AutomaticRescaleRangeMode = 'Never'
faceIdLUT.TransferFunction2D = faceIdTF2D
faceIdLUT.RGBPoints = [0.0, 0.231373, 0.298039, 0.752941, 4.5, 0.865003, 0.865003, 0.865003, 9.0, 0.705882, 0.0156863, 0.14902]
faceIdLUT.ScalarRangeInitialized = 1.0

# trace defaults for the display properties.
screwDisplay.Representation = 'Surface'
screwDisplay.ColorArrayName = ['CELLS', 'FaceId']
screwDisplay.LookupTable = faceIdLUT
screwDisplay.LineWidth = 2.0
screwDisplay.SelectTCoordArray = 'None'
screwDisplay.SelectNormalArray = 'Normals'
screwDisplay.SelectTangentArray = 'None'
screwDisplay.Position = [3.9000000000000004, -2.6, 0.0]
screwDisplay.OSPRayScaleArray = 'Normals'
screwDisplay.OSPRayScaleFunction = 'PiecewiseFunction'
screwDisplay.SelectOrientationVectors = 'None'
screwDisplay.ScaleFactor = 0.17975426016457277
screwDisplay.SelectScaleArray = 'None'
screwDisplay.GlyphType = 'Arrow'
screwDisplay.GlyphTableIndexArray = 'None'
screwDisplay.GaussianRadius = 0.008987713008228638
screwDisplay.SetScaleArray = ['POINTS', 'Normals']
screwDisplay.ScaleTransferFunction = 'PiecewiseFunction'
screwDisplay.OpacityArray = ['POINTS', 'Normals']
screwDisplay.OpacityTransferFunction = 'PiecewiseFunction'
screwDisplay.DataAxesGrid = 'GridAxesRepresentation'
screwDisplay.PolarAxes = 'PolarAxesRepresentation'
screwDisplay.SelectInputVectors = ['POINTS', 'Normals']
screwDisplay.WriteLog = ''

# init the 'PiecewiseFunction' selected for 'ScaleTransferFunction'
screwDisplay.ScaleTransferFunction.Points = [-1.0, 0.0, 0.5, 0.0, 1.0, 1.0, 0.5, 0.0]

# init the 'PiecewiseFunction' selected for 'OpacityTransferFunction'
screwDisplay.OpacityTransferFunction.Points = [-1.0, 0.0, 0.5, 0.0, 1.0, 1.0, 0.5, 0.0]

# init the 'PolarAxesRepresentation' selected for 'PolarAxes'
screwDisplay.PolarAxes.Translation = [3.9000000000000004, -2.6, 0.0]

# ----------------------------------------------------------------
# setup color maps and opacity mapes used in the visualization
# note: the Get..() functions create a new object, if needed
# ----------------------------------------------------------------

# get opacity transfer function/opacity map for 'PatchId'
patchIdPWF = GetOpacityTransferFunction('PatchId')
patchIdPWF.Points = [0.0, 0.0, 0.5, 0.0, 9.0, 1.0, 0.5, 0.0]
patchIdPWF.ScalarRangeInitialized = 1

# get opacity transfer function/opacity map for 'FaceId'
faceIdPWF = GetOpacityTransferFunction('FaceId')
faceIdPWF.Points = [0.0, 0.0, 0.5, 0.0, 9.0, 1.0, 0.5, 0.0]
faceIdPWF.ScalarRangeInitialized = 1

# get opacity transfer function/opacity map for 'Area'
areaPWF = GetOpacityTransferFunction('Area')
areaPWF.Points = [0.0036059240712031934, 0.0, 0.5, 0.0, 0.12647779363954176, 1.0, 0.5, 0.0]
areaPWF.ScalarRangeInitialized = 1

# get opacity transfer function/opacity map for 'PolygonId'
polygonIdPWF = GetOpacityTransferFunction('PolygonId')
polygonIdPWF.Points = [0.0, 0.0, 0.5, 0.0, 2.0, 1.0, 0.5, 0.0]
polygonIdPWF.ScalarRangeInitialized = 1

# get opacity transfer function/opacity map for 'MeanCurvature'
meanCurvaturePWF = GetOpacityTransferFunction('MeanCurvature')
meanCurvaturePWF.Points = [-11.054431936590571, 0.0, 0.5, 0.0, 24.977357792459134, 1.0, 0.5, 0.0]
meanCurvaturePWF.ScalarRangeInitialized = 1

# get opacity transfer function/opacity map for 'ShellId'
shellIdPWF = GetOpacityTransferFunction('ShellId')
shellIdPWF.Points = [0.0, 0.0, 0.5, 0.0, 1.1757813367477812e-38, 1.0, 0.5, 0.0]
shellIdPWF.ScalarRangeInitialized = 1

# get opacity transfer function/opacity map for 'Curvature'
curvaturePWF = GetOpacityTransferFunction('Curvature')
curvaturePWF.Points = [-22.180411127024357, 0.0, 0.5, 0.0, 6.875564213273808, 1.0, 0.5, 0.0]
curvaturePWF.ScalarRangeInitialized = 1

# get opacity transfer function/opacity map for 'SourceId'
sourceIdPWF = GetOpacityTransferFunction('SourceId')
sourceIdPWF.Points = [0.0, 0.0, 0.5, 0.0, 2.0, 1.0, 0.5, 0.0]
sourceIdPWF.ScalarRangeInitialized = 1

# ----------------------------------------------------------------
# restore active source
SetActiveSource(knob)
# ----------------------------------------------------------------