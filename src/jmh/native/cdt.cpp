// The constrained Delaunay triangulation of CGAL, timed on request: the peer of dct.bench.RegionTable.
//
// Argument: a file of little-endian 64-bit numbers: how many vertices, edges of rings and fixed edges
// there are, the coordinates as doubles, the ends of the edges. For every line of standard input it
// triangulates once and answers with the milliseconds that this took and the number of triangles:
// of those inside the rings, or of all where there are fixed edges, which parity cannot tell apart.

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertices = CGAL::Triangulation_vertex_base_2<Kernel>;
using Marked = CGAL::Triangulation_face_base_with_info_2<int, Kernel>;
using Faces = CGAL::Constrained_triangulation_face_base_2<Kernel, Marked>;
using Data = CGAL::Triangulation_data_structure_2<Vertices, Faces>;
using Mesh =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Data, CGAL::No_constraint_intersection_tag>;

static std::vector<Kernel::Point_2> points;
static std::vector<std::pair<std::size_t, std::size_t>> edges;
static std::size_t fixedEdges;  // the last of the edges

static void mark(Mesh& mesh, Mesh::Face_handle start, int inside, std::vector<Mesh::Edge>& border) {
  std::vector<Mesh::Face_handle> stack{start};
  while (!stack.empty()) {
    Mesh::Face_handle face = stack.back();
    stack.pop_back();
    if (face->info() >= 0) {
      continue;
    }
    face->info() = inside;
    for (int i = 0; i < 3; i++) {
      Mesh::Face_handle next = face->neighbor(i);
      if (next->info() < 0) {
        if (mesh.is_constrained(Mesh::Edge(face, i))) {
          border.emplace_back(face, i);
        } else {
          stack.push_back(next);
        }
      }
    }
  }
}

// Counts the triangles that an odd number of rings parts from the outside.
static std::size_t inside(Mesh& mesh) {
  for (Mesh::Face_handle face : mesh.all_face_handles()) {
    face->info() = -1;
  }
  std::vector<Mesh::Edge> border;
  mark(mesh, mesh.infinite_face(), 0, border);
  std::size_t count = 0;
  while (!border.empty()) {
    Mesh::Edge edge = border.back();
    border.pop_back();
    Mesh::Face_handle next = edge.first->neighbor(edge.second);
    if (next->info() < 0) {
      mark(mesh, next, edge.first->info() + 1, border);
    }
  }
  for (Mesh::Face_handle face : mesh.finite_face_handles()) {
    count += face->info() % 2;
  }
  return count;
}

static bool read(const char* name) {
  std::FILE* file = std::fopen(name, "rb");
  std::int64_t sizes[3];
  if (file == nullptr || std::fread(sizes, 8, 3, file) != 3) {
    return false;
  }
  for (std::int64_t i = 0; i < sizes[0]; i++) {
    double xy[2];
    if (std::fread(xy, 8, 2, file) != 2) {
      return false;
    }
    points.emplace_back(xy[0], xy[1]);
  }
  for (std::int64_t i = 0; i < sizes[1] + sizes[2]; i++) {
    std::int64_t ends[2];
    if (std::fread(ends, 8, 2, file) != 2) {
      return false;
    }
    edges.emplace_back(ends[0], ends[1]);
  }
  fixedEdges = sizes[2];
  return std::fclose(file) == 0;
}

int main(int count, char** arguments) {
  if (count < 2 || !read(arguments[1])) {
    return 1;
  }
  std::string line;
  while (std::getline(std::cin, line)) {
    auto start = std::chrono::steady_clock::now();
    Mesh mesh;
    mesh.insert_constraints(points.begin(), points.end(), edges.begin(), edges.end());
    std::size_t triangles = fixedEdges == 0 ? inside(mesh) : mesh.number_of_faces();
    std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    std::printf("%.3f %zu\n", time.count(), triangles);
    std::fflush(stdout);
  }
  return 0;
}
