# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""Edges, components and area of meshes, by VTK 9.1 (Debian's python3-vtk9).

    python3 judge_with_vtk.py CORPUS OBJ_FOLDER < paths > facts.tsv

Each path is that of a mesh in CORPUS; OBJ_FOLDER holds it as `path with / as __`.obj, in decimals that
are exact (`rigor mesh-check MESH -o OUT.obj`), except that an STL is read from CORPUS by VTK itself.

Points of the same coordinates are merged, and triangles that lose a corner by that are left out
(vtkCleanPolyData, tolerance 0). Boundary and non-manifold edges are those of vtkFeatureEdges, the area
that of vtkMassProperties. VTK's own components hang together by points, rigor's by edges: they are
counted by edges here, from VTK's points and cells.
"""

import sys

import numpy
import vtk
from vtk.util import numpy_support


def read_obj(path):
    points, faces = [], []
    for line in open(path, encoding="utf-8", errors="replace"):
        words = line.split()
        if words and words[0] == "v":
            points.append([float(x) for x in words[1:4]])
        elif words and words[0] == "f":
            faces.append([3] + [int(w.split("/")[0]) - 1 for w in words[1:4]])
    return numpy.array(points), numpy.array(faces, dtype=numpy.int64)


def poly_data(points, faces):
    data = vtk.vtkPolyData()
    vtk_points = vtk.vtkPoints()
    vtk_points.SetData(numpy_support.numpy_to_vtk(points, deep=True))
    cells = vtk.vtkCellArray()
    cells.SetCells(len(faces), numpy_support.numpy_to_vtkIdTypeArray(faces.ravel(), deep=True))
    data.SetPoints(vtk_points)
    data.SetPolys(cells)
    return data


def read_stl(path):
    reader = vtk.vtkSTLReader()
    reader.MergingOff()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def merged(data):
    clean = vtk.vtkCleanPolyData()
    clean.SetInputData(data)
    clean.ToleranceIsAbsoluteOn()
    clean.SetAbsoluteTolerance(0)
    clean.ConvertPolysToLinesOn()
    clean.ConvertLinesToPointsOn()
    clean.Update()
    only = vtk.vtkPolyData()
    only.SetPoints(clean.GetOutput().GetPoints())
    only.SetPolys(clean.GetOutput().GetPolys())
    return only


def edges(data, boundary):
    feature = vtk.vtkFeatureEdges()
    feature.SetInputData(data)
    feature.SetBoundaryEdges(boundary)
    feature.SetNonManifoldEdges(not boundary)
    feature.SetFeatureEdges(False)
    feature.SetManifoldEdges(False)
    feature.ColoringOff()
    feature.Update()
    return feature.GetOutput().GetNumberOfLines()


def components(data):
    cells = numpy_support.vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    group = list(range(len(cells)))

    def find(i):
        while group[i] != i:
            group[i] = group[group[i]]
            i = group[i]
        return i

    at_edge = {}
    for face, corners in enumerate(cells):
        for k in range(3):
            edge = tuple(sorted((corners[k], corners[(k + 1) % 3])))
            group[find(face)] = find(at_edge.setdefault(edge, face))
    return sum(find(i) == i for i in range(len(cells)))


def main():
    corpus, objs = sys.argv[1:3]
    print("# path\ttriangles\tboundary edges\tnon-manifold edges\tcomponents\tarea")
    for path in sys.stdin.read().split("\n"):
        if not path:
            continue
        if path.lower().endswith(".stl"):
            data = read_stl(corpus + "/" + path)
        else:
            data = poly_data(*read_obj(objs + "/" + path.replace("/", "__") + ".obj"))
        data = merged(data)
        mass = vtk.vtkMassProperties()
        mass.SetInputData(data)
        mass.Update()
        print(path, data.GetNumberOfPolys(), edges(data, True), edges(data, False), components(data),
              "%.12g" % mass.GetSurfaceArea(), sep="\t")


main()
