// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_MESHING_FIXTURES_H
#define MULTISIDED_PATCHES_TEST_MESHING_FIXTURES_H

#include "fixtures.h"

#include <CGAL/Multisided_patches/IO/CGB.h>
#include <CGAL/Multisided_patches/Jet_2.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>

#include <array>
#include <filesystem>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

// What tests of meshes of patches have in common.
namespace fixtures {

using Patch = MP::Concave_bezier_patch_3<Kernel>;
using Model = Patch::Model;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Location = Domain::Location;
using Triangles = std::vector<std::array<Point_3, 3>>;

inline double bowl(double x, double y) {
  return 0.3 * x * x - 0.2 * y * y + 0.1 * x * y;
}

/*
 * A model of MultisidedPatch_3 that has nothing to do with the package's own: any formula, a
 * function of u and v, generic in their type, which returns x, y and z.
 */
template <typename Formula>
class Formula_patch {
public:
  using Geom_traits = Kernel;
  using Point_2 = Kernel::Point_2;
  using Point_3 = Kernel::Point_3;
  using Vector_3 = Kernel::Vector_3;
  using Location = Domain::Location;

  Formula_patch(Domain domain, Formula formula)
      : domain_(std::move(domain)), formula_(std::move(formula)) {}

  const Domain& domain() const { return domain_; }

  template <int Order>
  std::array<MP::Jet_2<double, Order>, 3> evaluate(const Point_2& uv,
                                                   const Location& location) const {
    using Jet = MP::Jet_2<double, Order>;
    const Point_2 p = location.kind == Location::Kind::side
                          ? domain_.point_on_side(location.index, location.s)
                          : uv;
    return formula_(Jet::u_variable(p.x()), Jet::v_variable(p.y()));
  }
  Point_3 point(const Point_2& uv, const Location& location) const {
    const auto p = evaluate<0>(uv, location);
    return Point_3(p[0].value(), p[1].value(), p[2].value());
  }
  Vector_3 normal(const Point_2& uv, const Location& location) const {
    const auto p = evaluate<1>(uv, location);
    const Vector_3 n = CGAL::cross_product(Vector_3(p[0][1], p[1][1], p[2][1]),
                                           Vector_3(p[0][2], p[1][2], p[2][2]));
    return n == CGAL::NULL_VECTOR ? n : n / std::sqrt(n.squared_length());
  }
  std::pair<Point_3, Vector_3> point_and_normal(const Point_2& uv, const Location& location) const {
    return {point(uv, location), normal(uv, location)};
  }

private:
  Domain domain_;
  Formula formula_;
};

inline Model read_model(const std::string& name) {
  return MP::IO::read_CGB<Kernel>(std::string(MODELS_DIR "/") + name + ".cgb");
}

// The names of all models in a folder of the examples, in alphabetical order.
inline std::vector<std::string> model_names(const std::string& folder = "") {
  std::vector<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(MODELS_DIR "/" + folder))
    if (file.path().extension() == ".cgb")
      names.push_back((folder.empty() ? "" : folder + '/') + file.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

// The 12 models of the closed example.
inline std::vector<Model> computer_mouse() {
  std::vector<Model> models;
  for (const std::string& name : model_names("computer_mouse"))
    models.push_back(read_model(name));
  return models;
}

inline std::vector<Patch> make_patches(const std::vector<Model>& models) {
  return {models.begin(), models.end()};
}

// The triangles of a mesh, in its order, each with its smallest point first.
template <typename FaceGraph>
Triangles triangles(const FaceGraph& mesh) {
  Triangles result;
  for (const auto f : faces(mesh)) {
    std::array<Point_3, 3> t;
    std::size_t k = 0;
    for (const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      t[k++] = get(CGAL::vertex_point, mesh, v);
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    result.push_back(t);
  }
  return result;
}

template <typename FaceGraph>
Triangles sorted_triangles(const FaceGraph& mesh) {
  Triangles result = triangles(mesh);
  std::sort(result.begin(), result.end());
  return result;
}

inline double mean_edge_length(const Mesh& mesh) {
  double sum = 0;
  for (const auto e : mesh.edges())
    sum += std::sqrt(
        CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return sum / static_cast<double>(mesh.number_of_edges());
}

// The smallest angle of each triangle (degrees).
inline std::vector<double> smallest_angles(const Mesh& mesh) {
  std::vector<double> result;
  for (const auto& t : triangles(mesh)) {
    double smallest = 180;
    for (std::size_t k = 0; k < 3; ++k)
      smallest =
          (std::min)(smallest, CGAL::approximate_angle(t[(k + 1) % 3], t[k], t[(k + 2) % 3]));
    result.push_back(smallest);
  }
  return result;
}

// Their mean (degrees).
inline double mean_smallest_angle(const Mesh& mesh) {
  const std::vector<double> angles = smallest_angles(mesh);
  return std::accumulate(angles.begin(), angles.end(), 0.0) / static_cast<double>(angles.size());
}

} // namespace fixtures

#endif // MULTISIDED_PATCHES_TEST_MESHING_FIXTURES_H
