# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The functions and classes of the package potpourri3d.

All solvers run on intrinsic Delaunay triangulations that exact predicates have made, so that
options such as `use_robust` change nothing. Tangent frames are those of this package.
"""

from .core import validate_mesh, validate_points
from .io import (read_mesh, read_point_cloud, read_polygon_mesh, write_mesh, write_point_cloud)
from .mesh import (EdgeFlipGeodesicSolver, GeodesicTracer, MarchingTrianglesSolver,
                   MeshFastMarchingDistanceSolver, MeshHeatMethodDistanceSolver,
                   MeshMarchingTrianglesSolver, MeshSignedHeatSolver, MeshVectorHeatSolver,
                   PolygonMeshHeatSolver, compute_distance, compute_distance_multisource,
                   cotan_laplacian, edges, face_areas, marching_triangles, vertex_areas)
from .point_cloud import PointCloudHeatSolver, PointCloudLocalTriangulation
