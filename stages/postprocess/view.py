"""The standard view of a tidewater run in ParaView, from the collections beside this file.

    paraview --script=view.py             to look at it (or Tools > Python Shell > Run Script)
    pvbatch view.py --png view.png        a picture of the last frame; --time 2.5: of the frame nearest to 2.5 s
    pvbatch view.py --movie frames.png    pictures of all frames: frames.0000.png, ... (with .avi or .ogv: a film)

Without a display: xvfb-run pvbatch view.py --png view.png. In 2D particles are shown, water by speed and ice by
damage; in 3D the surfaces of water and icebergs, and ice that has broken to pieces as particles.
"""
import argparse
import os
import sys

import paraview.simple
from paraview.simple import *

ICE_COLORS = ["damage", "iceberg", "principal_stress"]
PALE_BLUE, GREY, ROCK = [0.80, 0.91, 1.0], [0.33, 0.34, 0.38], [0.60, 0.52, 0.42]
WATER, ICE, RIGID = 0, 1, 2  # numbers of the array material


def read_options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--png", help="write a picture")
    parser.add_argument("--movie", help="write all frames")
    parser.add_argument("--time", type=float, help="s; the last frame without it")
    parser.add_argument("--ice", choices=ICE_COLORS, default=ICE_COLORS[0], help="what colours the ice")
    parser.add_argument("--water", choices=["speed", "elevation"], default="speed", help="what colours the water")
    parser.add_argument("--size", type=int, nargs=2, default=[1600, 900], help="pixels")
    return parser.parse_args(sys.argv[1:])


def own_folder():
    try:
        return os.path.dirname(os.path.abspath(__file__))
    except NameError:  # ParaView's shell runs scripts without a name
        return os.getcwd()


def open_collection(name):
    """The collection's reader; None where the run has none."""
    path = os.path.join(own_folder(), name + ".pvd")
    if not os.path.exists(path):
        return None
    reader = PVDReader(registrationName=name, FileName=path)
    reader.UpdatePipeline()
    return reader


def point_range(source, name):
    array = source.GetPointDataInformation().GetArray(name) if source else None
    return array.GetRange(-1 if array.GetNumberOfComponents() > 1 else 0) if array else None


def greatest_over_time(reader, name, frames=8):
    """Of a few frames, so that a long run need not be read whole."""
    times = list(reader.TimestepValues)
    greatest = 0.0
    for time in times[:: max(1, len(times) // frames)] + times[-1:]:
        reader.UpdatePipeline(time)
        found = point_range(reader, name)
        if found and found[1] < 1e30:
            greatest = max(greatest, abs(found[0]), abs(found[1]))
    return greatest


def single_points(particles):
    """With a cell for each point, for a threshold takes whole cells, and the files have one over all points."""
    points = MaskPoints(registrationName="points", Input=particles)
    points.OnRatio = 1
    points.MaximumNumberofPoints = 2**31 - 1
    points.GenerateVertices = points.SingleVertexPerCell = 1
    return points


def material(particles, number, name):
    part = Threshold(registrationName=name, Input=particles)
    part.Scalars = ["POINTS", "material"]
    part.ThresholdMethod = "Between"
    part.LowerThreshold = part.UpperThreshold = number
    part.UpdatePipeline()
    return part if part.GetDataInformation().GetNumberOfPoints() > 0 else None


def color_plainly(display, color):
    display.ColorArrayName = [None, ""]
    display.AmbientColor = display.DiffuseColor = color


def color_by(display, where, name, view, low, high, title, points=None, preset="Viridis (matplotlib)", bar=0):
    ColorBy(display, (where, name))
    table = GetColorTransferFunction(name)
    if points:
        table.RGBPoints = points
    else:
        table.ApplyPreset(preset, True)
        table.RescaleTransferFunction(low, max(high, low + 1e-9))
    table.NanColor = PALE_BLUE
    scale = GetScalarBar(table, view)
    scale.Title, scale.ComponentTitle = title, ""
    scale.Orientation = "Horizontal"
    scale.WindowLocation = "Any Location"
    scale.Position = [0.56 if bar else 0.08, 0.06]
    scale.ScalarBarLength = 0.36
    scale.RangeLabelFormat = "%.3g"
    scale.TitleColor = scale.LabelColor = [0, 0, 0]
    display.SetScalarBarVisibility(view, True)


def color_water(display, where, options, view, fastest, highest):
    if options.water == "elevation" and highest > 0.0:
        color_by(display, where, "elevation", view, -highest, highest, "elevation (m)", preset="Cool to Warm")
    else:
        name = "speed" if where == "POINTS" and display.Input == FindSource("water_surface") else "velocity_magnitude"
        color_by(display, where, name, view, 0.0, fastest, "speed of water (m/s)")


def color_ice(display, where, source, name, view):
    found = point_range(source, name) if where == "POINTS" else None
    if name == "damage" and found:
        color_by(display, where, name, view, 0, 1, "damage of ice", points=[0.0] + PALE_BLUE + [1.0] + GREY, bar=1)
    elif name == "principal_stress" and found:
        most = max(abs(found[0]), abs(found[1]), 1.0)
        color_by(display, where, name, view, -most, most, "greatest stress (Pa)", preset="Cool to Warm", bar=1)
    else:
        color_plainly(display, PALE_BLUE)


def color_icebergs(display, source, view):
    array = source.GetCellDataInformation().GetArray("iceberg")
    last = int(array.GetRange(0)[1]) if array else 0
    ColorBy(display, ("CELLS", "iceberg"))
    table = GetColorTransferFunction("iceberg")
    hues = [[0.98, 0.75, 0.35], [0.55, 0.80, 0.55], [0.85, 0.60, 0.80], [0.95, 0.90, 0.45], [0.90, 0.50, 0.35]]
    table.InterpretValuesAsCategories = 1
    table.Annotations = [text for i in range(-1, last + 1) for text in (str(i), str(i))]
    table.IndexedColors = ROCK + PALE_BLUE + [c for i in range(last) for c in hues[i % len(hues)]]
    display.SetScalarBarVisibility(view, False)


def show_points(source, radius, view):
    display = Show(source, view)
    display.SetRepresentationType("Point Gaussian")
    display.GaussianRadius = radius
    display.ShaderPreset = "Plain circle"
    return display


def show_particles(particles, options, view, flat, surfaces, fastest, highest):
    """In 3D only ice that belongs to no iceberg, where surfaces show the rest."""
    volume = point_range(particles, "volume")
    radius = 0.6 * volume[1] ** (1.0 / (2 if flat else 3))
    points = single_points(particles)
    water, ice, rigid = (material(points, number, name)
                         for number, name in ((WATER, "water"), (ICE, "ice"), (RIGID, "block")))
    if water and (flat or not surfaces):
        color_water(show_points(water, radius, view), "POINTS", options, view, fastest, highest)
    if ice and not flat and surfaces and point_range(ice, "iceberg"):
        loose = Threshold(registrationName="loose ice", Input=ice)
        loose.Scalars = ["POINTS", "iceberg"]
        loose.ThresholdMethod = "Below Lower Threshold"
        loose.LowerThreshold = -0.5
        loose.UpdatePipeline()
        ice = loose
    if ice:
        name = options.ice if options.ice != "iceberg" else "none"
        color_ice(show_points(ice, radius, view), "POINTS", ice, name, view)
    if rigid and (flat or not surfaces):
        display = show_points(rigid, radius, view)
        color_plainly(display, ROCK)


def show_surfaces(water, bodies, options, view, flat, fastest, highest):
    if water:
        display = Show(water, view)
        display.LineWidth = 2.0
        if flat:  # a line above the water's particles
            color_plainly(display, [0.05, 0.15, 0.35])
        else:
            display.Opacity = 0.85
            color_water(display, "POINTS", options, view, fastest, highest)
    if bodies and (not flat or options.ice == "iceberg"):
        display = Show(bodies, view)
        if flat:
            display.Ambient, display.Diffuse = 1.0, 0.0  # colours as they are, without light
        color_icebergs(display, bodies, view)


def bounds_of(sources):
    low, high = [1e30] * 3, [-1e30] * 3
    for source in sources:
        b = source.GetDataInformation().GetBounds()
        for axis in range(3):
            if b[2 * axis] <= b[2 * axis + 1]:
                low[axis], high[axis] = min(low[axis], b[2 * axis]), max(high[axis], b[2 * axis + 1])
    return low, high


def place_camera(view, low, high, flat, size):
    center = [0.5 * (a + b) for a, b in zip(low, high)]
    extent = [b - a for a, b in zip(low, high)]
    if flat:
        center[2] -= 0.2 * extent[2]  # room for the scales
    reach = max(extent)
    view.CameraFocalPoint, view.CameraViewUp = center, [0, 0, 1]
    if flat:
        view.CameraParallelProjection = 1
        view.CameraPosition = [center[0], center[1] - 2.0 * reach, center[2]]
        view.CameraParallelScale = 0.54 * max(extent[2] * 1.5, extent[0] * size[1] / size[0])
    else:
        view.CameraPosition = [center[0] + 0.75 * reach, center[1] - 1.1 * reach, center[2] + 0.65 * reach]
        ResetCamera(view)
        view.CameraViewAngle = 0.75 * view.CameraViewAngle  # the room that it leaves around


def label_time(source, view):
    label = AnnotateTimeFilter(registrationName="time", Input=source)
    label.Format = "t = {time:.2f} s"
    display = Show(label, view)
    display.Color, display.FontSize = [0, 0, 0], 20
    display.WindowLocation = "Upper Left Corner"


def main():
    options = read_options()
    particles, water, bodies = (open_collection(name) for name in ("particles", "water_surface", "iceberg_surfaces"))
    sources = [source for source in (particles, water, bodies) if source]
    if not sources:
        sys.exit(own_folder() + ": there is no particles.pvd nor water_surface.pvd; run tidewater-postprocess here")
    paraview.simple._DisableFirstRenderCameraReset()  # the camera is placed below
    view = GetActiveViewOrCreate("RenderView")
    view.ViewSize = options.size
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    fastest = greatest_over_time(water, "speed") if water else greatest_over_time(particles, "velocity_magnitude")
    highest = greatest_over_time(water, "elevation") if water else 0.0
    times = sorted({time for source in sources for time in source.TimestepValues} or {0.0})
    wanted = times[-1] if options.time is None else min(times, key=lambda time: abs(time - options.time))
    scene = GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    for source in sources:
        source.UpdatePipeline(times[0])
    low, high = bounds_of(sources)
    flat = high[1] - low[1] < 1e-6
    scene.AnimationTime = view.ViewTime = wanted
    for source in sources:
        source.UpdatePipeline(wanted)
    if particles:
        show_particles(particles, options, view, flat, bool(water or bodies), fastest, highest)
    show_surfaces(water, bodies, options, view, flat, fastest, highest)
    label_time(sources[0], view)
    place_camera(view, low, high, flat, options.size)
    Render(view)
    if options.png:
        SaveScreenshot(options.png, view, ImageResolution=options.size)
    if options.movie:
        SaveAnimation(options.movie, view, ImageResolution=options.size)


main()
