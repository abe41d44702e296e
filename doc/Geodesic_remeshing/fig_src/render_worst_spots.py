"""Renders the worst spot of the meshes of several remeshers side by side: the triangle with the smallest angle of each, seen from above.

  render_worst_spots.py FOLDER_OF_MESHES FIGURE.png MODEL...

The folder holds what `remeshing_benchmark --meshes` wrote, MODEL.METHOD.off. A row for each model, a column for each method. Faces are colored by
their smallest angle, the one in the middle is outlined. All panels show as many edge lengths; what is more than one and a half of them
in front of the triangle (another sheet, a limb) is cut away.
"""

import math
import os
import subprocess
import sys
import tempfile

import render_figures as figures

METHODS = [("geodesic_remeshing", "geodesic_remeshing"), ("isotropic_remeshing__3_iterations", "isotropic_remeshing, 3 it."),
           ("isotropic_remeshing__10_iterations", "isotropic_remeshing, 10 it."), ("ACVD", "ACVD")]
SIZE = (300, 300)
EDGES_ACROSS = 9


def read_off(name):
    """Points and triangles of an OFF file"""
    with open(name) as file:
        words = (word for line in file for word in line.split("#")[0].split())
        assert next(words) == "OFF"
        vertices, faces, _ = (int(next(words)) for _ in range(3))
        points = [tuple(float(next(words)) for _ in range(3)) for _ in range(vertices)]
        triangles = [tuple(int(next(words)) for _ in range(4))[1:] for _ in range(faces)]
    return points, triangles


def minus(p, q):
    return tuple(a - b for a, b in zip(p, q))


def smallest_angle(points, triangle):
    """In degrees"""
    corners = [points[i] for i in triangle]
    angles = []
    for i in range(3):
        v, w = minus(corners[i - 2], corners[i]), minus(corners[i - 1], corners[i])
        angles.append(math.degrees(math.atan2(math.hypot(*figures.cross(v, w)), figures.dot(v, w))))
    return min(angles)


def mean_edge_length(points, triangles):
    return sum(math.dist(points[t[i]], points[t[i - 1]]) for t in triangles for i in range(3)) / (3 * len(triangles))


def outline(points, triangle):
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

    vtk_points = vtkPoints()
    for i in triangle:
        vtk_points.InsertNextPoint(points[i])
    lines = vtkCellArray()
    lines.InsertNextCell(4, (0, 1, 2, 0))
    data = vtkPolyData()
    data.SetPoints(vtk_points)
    data.SetLines(lines)
    return data


def poly_data(points, triangles, values):
    from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

    vtk_points = vtkPoints()
    for point in points:
        vtk_points.InsertNextPoint(point)
    cells = vtkCellArray()
    for triangle in triangles:
        cells.InsertNextCell(3, triangle)
    scalars = vtkDoubleArray()
    for value in values:
        scalars.InsertNextValue(value)
    data = vtkPolyData()
    data.SetPoints(vtk_points)
    data.SetPolys(cells)
    data.GetCellData().SetScalars(scalars)
    return data


def colors_of_angles():
    """From red at 0 degrees by yellow at 38 to the color of a surface at 50 and above"""
    from vtkmodules.vtkCommonCore import vtkLookupTable

    stops = [(0, (.80, .05, .10)), (25, (.93, .40, .18)), (38, (1., .80, .35)), (50, figures.SURFACE), (60, figures.SURFACE)]
    table = vtkLookupTable()
    table.SetNumberOfTableValues(121)
    for i in range(121):
        angle = i / 2
        k = next(k for k in range(1, len(stops)) if angle <= stops[k][0])
        (low, a), (high, b) = stops[k - 1], stops[k]
        t = (angle - low) / (high - low)
        table.SetTableValue(i, *(p + t * (q - p) for p, q in zip(a, b)))
    return table


def render(data, worst, center, normal, edge, file_name):
    def aim(renderer):
        height = EDGES_ACROSS * edge
        camera = renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(center)
        camera.SetPosition(*(c + 2 * height * n for c, n in zip(center, normal)))
        camera.SetViewUp((0, 0, 1) if abs(normal[2]) < .8 else (0, 1, 0))
        camera.SetParallelScale(height / 2)
        camera.SetClippingRange(2 * height - 1.5 * edge, 3 * height)

    actor = figures.color_by(figures.mesh(data), colors_of_angles(), 0, 60)
    actor.GetMapper().SetScalarModeToUseCellData()
    figures.write_picture([actor, figures.tubes(worst, .05 * edge, figures.ACCENT)], SIZE, aim, file_name)


def panel(mesh_file, label, file_name):
    points, triangles = read_off(mesh_file)
    angles = [smallest_angle(points, t) for t in triangles]
    worst = min(range(len(angles)), key=angles.__getitem__)
    center = tuple(sum(points[i][k] for i in triangles[worst]) / 3 for k in range(3))
    edge = mean_edge_length(points, triangles)
    p, q, r = (points[i] for i in triangles[worst])
    render(poly_data(points, triangles, angles), outline(points, triangles[worst]), center,
           figures.normalized(figures.cross(minus(q, p), minus(r, p))), edge, file_name)
    subprocess.run(["convert", file_name, "-filter", "Box", "-resize", f"{100 / figures.PIXELS}%", "-background", "white", "-gravity", "center",
                    "-font", "DejaVu-Sans", "-pointsize", "14", f"label:{label}: {angles[worst]:.0f}°", "-append", "-bordercolor", "white", "-border", "4",
                    file_name], check=True)


def main(folder, figure, *models):
    with tempfile.TemporaryDirectory() as work:
        rows = []
        for model in models:
            panels = []
            for method, label in METHODS:
                panels.append(os.path.join(work, f"{model}.{method}.png"))
                panel(os.path.join(folder, f"{model}.{method}.off"), f"{model}, {label}", panels[-1])
            rows.append(os.path.join(work, model + ".png"))
            subprocess.run(["convert", *panels, "+append", rows[-1]], check=True)
        subprocess.run(["convert", *rows, "-append", "+dither", "-colors", "128", "-strip", "-define", "png:exclude-chunks=date,time",
                        "-define", "png:compression-level=9", "PNG8:" + figure], check=True)


main(*sys.argv[1:])
