// Models that several figures share, all made by the program.
#pragma once
#include "core/mesh/mesh.h"

namespace mw::figures {

/// The book's cube: corner 4x + 2y + z of the unit cube, twelve triangles as the strip 0 1 2 3 7 1 5 4 7 6 2 4 0 1 has them.
Mesh stripCube();
/// A closed quadruped of genus 0, of quads; and the same as about 6000 triangles, or about `faces`.
Mesh cow4();
Mesh cow3(size_t faces = 6000);
/// `columns` x `rows` squares of side 1 in the plane z = 0, y up, each cut in two; vertex row * (columns + 1) + column. `bent` lifts the
/// middle by that much along z.
Mesh triangleGrid(int columns, int rows, double bent = 0);
Mesh quadGrid(int columns, int rows);
/// Equilateral triangles in the plane z = 0: every inner vertex has valence 6. `rings` of triangles round the origin, which is vertex 0.
Mesh hexagonGrid(int rings);
/// An open piece of the rock: one boundary, a disk, 500 to 2000 triangles, no defects.
Mesh rockpatch();
/// Two holes: genus 2, closed, triangles.
Mesh torus2();
Mesh torusMesh(double radius, double tube, int segments, int sides);  ///< of triangles
Mesh sphereMesh(int subdivisions);
/// k triangles round vertex 0 at the origin in the plane z = 0, the ring at radius 1 from vertex 1 on; `height` lifts the middle. Closed or
/// open by a gap of one triangle.
Mesh fan(int k, double height = 0, bool closed = true);
/// Each polygon cut into triangles.
Mesh triangulated(const Mesh& mesh);
/// The result of an operation of the catalog, parameters as on the command line: applied("subdivide-loop", "levels=2", mesh).
Mesh applied(const char* operation, const char* parameters, const Mesh& mesh);

}  // namespace mw::figures
