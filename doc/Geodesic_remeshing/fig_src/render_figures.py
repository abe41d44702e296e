"""Renders the figures of the manual from what geodesic_remeshing_stages wrote.

  render_figures.py FOLDER_OF_STAGES FOLDER_OF_FIGURES [FIGURE...]

The folder of stages holds a folder for each of the RUNS, the figures are those of FIGURES.
render_figures.py --runs prints the runs, one a line: model, number of vertices, whether to segment, contrast of the sizing, feature angle,
number of parts of the input, name of the folder.
"""

import collections
import math
import os
import subprocess
import sys
import tempfile

def run(model, vertices, folder=None, segmented="yes", contrast=0, feature_angle=180, parts=1):
    return (model, vertices, segmented, contrast, feature_angle, parts, folder or model)


RUNS = [
    run("cactus", 1200),
    run("cactus", 1200, "cactus_unsegmented", segmented="no"),
    run("dino", 3000),
    run("dino", 3000, "dino_unsegmented", segmented="no"),
    run("dino", 5000, "dino_5000"),
    run("eight", 1500),
    run("elephant", 3000),
    *(run("homer", 3000, f"homer_contrast_{contrast}", contrast=contrast) for contrast in (0, .3, .6)),
    run("fandisk", 3000, feature_angle=60),
    run("pinion", 4000, feature_angle=60),
    run("nefertiti", 3000),
    run("cow", 3000, "cow_parts", parts=7),
]

# up and direction of view of the camera, and what it looks at: a point of the picture of the whole model (from the left and from
# below, as fractions of its size) and the height around it (as a fraction of the height of the whole)
View = collections.namedtuple("View", "up direction focus height", defaults=((.5, .5), 1.))

CACTUS = View(up=(0, 1, 0), direction=(0, -.25, -1))
JUNCTION = View(up=(0, 1, 0), direction=(.2, -.5, -1), focus=(.6, .6), height=.26)
DINO = View(up=(0, 0, 1), direction=(-.74, .62, -.27))
SHOULDER = View(up=(0, 0, 1), direction=(-.74, .62, -.27), focus=(.5, .59), height=.3)
EIGHT = View(up=(0, 1, 0), direction=(-.3, -.5, -1))
HOMER = View(up=(0, 1, 0), direction=(-.35, -.1, -1))
HEAD = View(up=(0, 1, 0), direction=(-.35, -.1, -1), focus=(.56, .825), height=.37)
ELEPHANT = View(up=(0, 1, 0), direction=(-.6, -.25, -.8))

FANDISK = View(up=(0, 0, 1), direction=(.7, .6, -.5))
GEAR = View(up=(0, 0, 1), direction=(.5, .6, -.6))
NEFERTITI = View(up=(0, 1, 0), direction=(-.3, -.1, -1))
COW = View(up=(0, 1, 0), direction=(-.4, -.3, -1))

STAGES = ["isolines", "regions", "curves", "samples", "strips", "output"]

# A figure: the size of a panel, and the rows of panels (folder, view, what to show)
FIGURES = {
    "geodesic_remeshing": ((560, 740), [[("dino_5000", DINO, "input"), ("dino_5000", DINO, "output")]]),
    "stages_cactus": ((230, 380), [[("cactus", CACTUS, stage) for stage in STAGES]]),
    "stages_dino": ((430, 550), [[("dino", DINO, stage) for stage in STAGES[:3]], [("dino", DINO, stage) for stage in STAGES[3:]]]),
    "strips": ((330, 330), [[("cactus", JUNCTION, stage) for stage in ("curves", "samples", "strips", "output")]]),
    "segmentation": ((330, 330), [[("dino_unsegmented", SHOULDER, "curves"), ("dino_unsegmented", SHOULDER, "strips"),
                                   ("dino", SHOULDER, "curves"), ("dino", SHOULDER, "strips")]]),
    "handles": ((420, 400), [[("eight", EIGHT, "curves"), ("eight", EIGHT, "output"),
                              ("elephant", ELEPHANT, "curves"), ("elephant", ELEPHANT, "output")]]),
    "features": ((430, 430), [[("fandisk", FANDISK, "input"), ("fandisk", FANDISK, "lines")],
                              [("pinion", GEAR, "input"), ("pinion", GEAR, "lines")]]),
    "open": ((380, 520), [[("nefertiti", NEFERTITI, what) for what in ("input", "lines")]]),
    "attributes": ((560, 400), [[("cow_parts", COW, what) for what in ("input_parts", "output_parts")]]),
    "contrasts": ((430, 640), [[(f"homer_contrast_{contrast}", HOMER, "output") for contrast in (0, .3, .6)],
                               [(f"homer_contrast_{contrast}", HEAD, "output") for contrast in (0, .3, .6)]]),
}

PIXELS = 3  # each pixel of a figure is the mean of so many squared
SURFACE = (.93, .93, .91)
INK = (.10, .12, .16)
ACCENT = (.85, .11, .13)
REGION_COLORS = [(.55, .75, .89), (.99, .75, .44), (.70, .87, .54), (.98, .60, .60), (.79, .70, .84), (1., .93, .56), (.60, .83, .78),
                 (.85, .72, .60)]


def read(folder, name):
    from vtkmodules.vtkIOLegacy import vtkPolyDataReader

    reader = vtkPolyDataReader()
    reader.SetFileName(os.path.join(folder, name + ".vtk"))
    reader.Update()
    return reader.GetOutput()


def diagonal_of(data):
    b = data.GetBounds()
    return math.dist(b[0::2], b[1::2])


def actor_of(data, color):
    from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper
    import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (what is made before this is registered draws nothing)

    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetAmbient(.25)
    actor.GetProperty().SetDiffuse(.75)
    return actor


def color_by(actor, table, low, high):
    actor.GetMapper().SetLookupTable(table)
    actor.GetMapper().SetScalarRange(low, high)
    actor.GetMapper().ScalarVisibilityOn()
    return actor


def surface(data, color=SURFACE):
    """Shaded as the smooth surface that the mesh stands for"""
    from vtkmodules.vtkFiltersCore import vtkPolyDataNormals

    normals = vtkPolyDataNormals()
    normals.SetInputData(data)
    normals.SplittingOff()
    normals.Update()
    return actor_of(normals.GetOutput(), color)


def mesh(data):
    """Flat triangles with their edges"""
    actor = actor_of(data, SURFACE)
    actor.GetProperty().SetInterpolationToFlat()
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(INK)
    actor.GetProperty().SetLineWidth(.7 * PIXELS)
    return actor


def tubes(data, size, color=INK):
    """The lines as thin tubes, half of which stand out of the surface they lie on"""
    from vtkmodules.vtkFiltersCore import vtkTubeFilter

    tube = vtkTubeFilter()
    tube.SetInputData(data)
    tube.SetNumberOfSides(8)
    tube.SetRadius(size)
    tube.Update()
    return actor_of(tube.GetOutput(), color)


def balls(data, size, color):
    from vtkmodules.vtkFiltersCore import vtkGlyph3D
    from vtkmodules.vtkFiltersSources import vtkSphereSource

    ball = vtkSphereSource()
    ball.SetRadius(size)
    ball.SetThetaResolution(16)
    ball.SetPhiResolution(12)
    glyphs = vtkGlyph3D()
    glyphs.SetInputData(data)
    glyphs.SetSourceConnection(ball.GetOutputPort())
    glyphs.ScalingOff()
    glyphs.Update()
    return actor_of(glyphs.GetOutput(), color)


def distances(data):
    from vtkmodules.vtkCommonCore import vtkLookupTable

    stops = [(.99, .91, .65), (.93, .61, .40), (.72, .33, .43), (.38, .21, .47)]
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i in range(256):
        k, t = divmod(i / 255 * (len(stops) - 1), 1)
        a, b = stops[int(k)], stops[min(int(k) + 1, len(stops) - 1)]
        table.SetTableValue(i, *(p + t * (q - p) for p, q in zip(a, b)))
    return color_by(surface(data), table, *data.GetScalarRange())


def regions(data):
    from vtkmodules.vtkCommonCore import vtkLookupTable

    table = vtkLookupTable()
    table.SetNumberOfTableValues(len(REGION_COLORS))
    for i, color in enumerate(REGION_COLORS):
        table.SetTableValue(i, *color)
    return color_by(surface(data), table, -.5, len(REGION_COLORS) - .5)


def root_of(data):
    """The vertex at distance 0"""
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkPolyData

    values = data.GetPointData().GetScalars()
    points = vtkPoints()
    points.InsertNextPoint(data.GetPoint(min(range(values.GetNumberOfTuples()), key=values.GetValue)))
    root = vtkPolyData()
    root.SetPoints(points)
    return root


def layers(folder, what):
    """The actors that show a stage"""
    line = .0011 * diagonal_of(read(folder, "input"))
    if what in ("input", "strips", "output"):
        return [mesh(read(folder, what))]
    if what == "lines":
        return [mesh(read(folder, "output")), tubes(read(folder, "lines"), line, ACCENT)]
    if what in ("input_parts", "output_parts"):
        actor = regions(read(folder, what))
        actor.GetProperty().EdgeVisibilityOn()
        actor.GetProperty().SetEdgeColor(INK)
        actor.GetProperty().SetLineWidth(.7 * PIXELS)
        return [actor]
    if what == "isolines":
        data = read(folder, "distances")
        # the curves of a run without segmentation are those of the distance from the root
        return [distances(data), tubes(read(folder.removesuffix("_unsegmented") + "_unsegmented", "curves"), line),
                balls(root_of(data), 9 * line, ACCENT)]
    if what == "regions":
        return [regions(read(folder, "regions"))]
    if what == "curves":
        return [regions(read(folder, "regions")), tubes(read(folder, "curves"), line)]
    if what == "samples":
        return [surface(read(folder, "distances")), tubes(read(folder, "curves"), .7 * line), balls(read(folder, "samples"), 2.4 * line, ACCENT)]
    raise ValueError("nothing is known of " + what)


def normalized(v):
    length = math.hypot(*v)
    return tuple(x / length for x in v)


def cross(v, w):
    return (v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0])


def dot(v, w):
    return sum(x * y for x, y in zip(v, w))


def extent(points, axis):
    values = [dot(p, axis) for p in points]
    return min(values), max(values) - min(values)


def set_camera(renderer, view, data, aspect):
    """Parallel projection of the whole input, or of what the view looks at: the same for all stages of a model"""
    direction = normalized(view.direction)
    right = normalized(cross(direction, view.up))
    up = cross(right, direction)
    points = [data.GetPoint(i) for i in range(data.GetNumberOfPoints())]
    (left, width), (bottom, height) = (extent(points, axis) for axis in (right, up))
    whole = 1.03 * max(height, width / aspect)
    x = left + width / 2 + (view.focus[0] - .5) * whole * aspect
    y = bottom + height / 2 + (view.focus[1] - .5) * whole
    center = tuple(x * r + y * u + dot(points[0], direction) * d for r, u, d in zip(right, up, direction))
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(center)
    camera.SetPosition(*(c - 3 * diagonal_of(data) * d for c, d in zip(center, direction)))
    camera.SetViewUp(up)
    camera.SetParallelScale(view.height * whole / 2)
    renderer.ResetCameraClippingRange()


def write_picture(actors, size, aim, file_name):
    """The actors as a PNG file, some times larger than the size; aim(renderer) sets the camera"""
    from vtkmodules.vtkIOImage import vtkPNGWriter
    from vtkmodules.vtkRenderingCore import vtkLightKit, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in actors:
        renderer.AddActor(actor)
    lights = vtkLightKit()
    lights.SetKeyLightIntensity(.95)
    lights.AddLightsToRenderer(renderer)
    window = vtkRenderWindow()
    window.SetMultiSamples(0)  # the figure is made smaller instead, which looks the same with every driver
    window.SetOffScreenRendering(1)
    window.SetSize(*(PIXELS * n for n in size))
    window.AddRenderer(renderer)
    aim(renderer)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(file_name)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


def render(folder, view, what, size, file_name):
    write_picture(layers(folder, what), size,
                  lambda renderer: set_camera(renderer, view, read(folder, "input"), size[0] / size[1]), file_name)


def make_figure(name, stages, figures, work):
    size, rows = FIGURES[name]
    row_files = []
    for i, row in enumerate(rows):
        panels = []
        for j, (folder, view, what) in enumerate(row):
            panels.append(os.path.join(work, f"{name}_{i}_{j}.png"))
            render(os.path.join(stages, folder), view, what, size, panels[-1])
        row_files.append(os.path.join(work, f"{name}_{i}.png"))
        subprocess.run(["convert", *panels, "-filter", "Box", "-resize", f"{100 / PIXELS}%", "+append", row_files[-1]], check=True)
    # a palette makes a third of the bytes; without dithering it cannot be seen
    subprocess.run(["convert", *row_files, "-append", "+dither", "-colors", "128", "-strip", "-define", "png:exclude-chunks=date,time",
                    "-define", "png:compression-level=9", "PNG8:" + os.path.join(figures, name + ".png")], check=True)


def main(arguments):
    if arguments == ["--runs"]:
        for run in RUNS:
            print(*run)
        return
    stages, figures, *names = arguments
    unknown = [name for name in names if name not in FIGURES]
    if unknown:
        sys.exit(f"no figure is called {unknown[0]}; there are {', '.join(FIGURES)}")
    with tempfile.TemporaryDirectory() as work:
        for name in names or FIGURES:
            make_figure(name, stages, figures, work)


if __name__ == "__main__":
    main(sys.argv[1:])
