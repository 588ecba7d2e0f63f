// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_file.h"

#include <CGAL/Multisided_patches/IO/internal/file_access.h>
#include <CGAL/Multisided_patches/IO/surface_mesh.h>

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <istream>
#include <map>
#include <sstream>
#include <utility>

namespace multipatch {

namespace MP = CGAL::Multisided_patches;

namespace {

using MP::IO::Mesh_format;

struct Soup {
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
};

bool read(std::istream& in, Mesh_format format, Soup& soup) {
  switch (format) {
  case Mesh_format::PLY:
    return CGAL::IO::read_PLY(in, soup.points, soup.faces);
  case Mesh_format::OBJ:
    return CGAL::IO::read_OBJ(in, soup.points, soup.faces);
  case Mesh_format::OFF:
    return CGAL::IO::read_OFF(in, soup.points, soup.faces);
  case Mesh_format::STL: {
    std::vector<std::array<std::size_t, 3>> triangles;
    const bool is_read = CGAL::IO::read_STL(in, soup.points, triangles);
    for (const auto& [i, j, k] : triangles)
      soup.faces.push_back({i, j, k});
    return is_read;
  }
  }
  return false;
}

// CGAL believes any number of elements that the header of a .ply file tells. Each takes a byte at
// least.
void check_ply_header(const std::string& file_name) {
  std::ifstream in = MP::internal::open_for_reading(file_name);
  in.seekg(0, std::ios::end);
  const double size = static_cast<double>(in.tellg());
  in.seekg(0);
  for (std::string line; std::getline(in, line) && line.rfind("end_header", 0) != 0;) {
    std::istringstream words(line);
    std::string keyword, name;
    double count = 0;
    if (words >> keyword >> name >> count && keyword == "element" && !(count <= size))
      throw MP::Input_error(file_name + ": the header tells of more elements '" + name +
                            "' than the file has bytes");
  }
}

Soup read_soup(const std::string& file_name) {
  Soup soup;
  const Mesh_format format = MP::IO::mesh_format(file_name);
  if (format == Mesh_format::PLY)
    check_ply_header(file_name);
  std::ifstream in = MP::internal::open_for_reading(file_name);
  bool is_read = false;
  try {
    is_read = read(in, format, soup);
  } catch (const std::exception&) { // sizes beyond all bounds, numbers out of range
  }
  if (!is_read)
    throw MP::Input_error(file_name + ": cannot be read: is it a mesh of this format, and whole?");
  return soup;
}

void check_faces(const Soup& soup, const std::string& file_name) {
  if (soup.faces.empty())
    throw MP::Input_error(file_name + ": expected triangles, found none");
  for (std::size_t k = 0; k < soup.faces.size(); ++k) {
    const auto& face = soup.faces[k];
    const std::string name = file_name + ": face " + std::to_string(k);
    if (face.size() != 3)
      throw MP::Input_error(name + " has " + std::to_string(face.size()) +
                            " corners; triangles were expected");
    for (const std::size_t v : face)
      if (v >= soup.points.size())
        throw MP::Input_error(name + ": there is no vertex " + std::to_string(v));
  }
}

// Why the triangles are no mesh, of which CGAL says only that they are none.
std::string defect(const Soup& soup) {
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> uses;
  for (const auto& face : soup.faces)
    for (std::size_t j = 0; j < 3; ++j) {
      if (face[j] == face[(j + 1) % 3])
        return "a triangle has vertex " + std::to_string(face[j]) + " twice";
      ++uses[{face[j], face[(j + 1) % 3]}];
    }
  std::size_t crowded = 0, twisted = 0;
  for (const auto& [edge, count] : uses) {
    const auto opposite = uses.find({edge.second, edge.first});
    const bool is_first = opposite == uses.end() || edge.first < edge.second;
    const std::size_t all = count + (opposite == uses.end() ? 0 : opposite->second);
    crowded += is_first && all > 2;
    twisted += all == 2 && count == 2;
  }
  const auto edges = [](std::size_t n) {
    return std::to_string(n) + (n == 1 ? " edge" : " edges");
  };
  if (crowded > 0)
    return "more than two triangles meet at " + edges(crowded);
  if (twisted > 0)
    return "the triangles on the two sides of " + edges(twisted) + " turn opposite ways";
  return "parts touch in a vertex only";
}

// The readers of whole meshes keep normals and patches; they rely on data that make a mesh.
bool read_with_properties(std::istream& in, Mesh_format format, Mesh& mesh) {
  std::string comments;
  return format == Mesh_format::PLY   ? CGAL::IO::read_PLY(in, mesh, comments)
         : format == Mesh_format::OFF ? CGAL::IO::read_OFF(in, mesh)
                                      : false;
}

} // namespace

bool is_mesh_file(const std::string& file_name) {
  try {
    MP::IO::mesh_format(file_name);
    return true;
  } catch (const MP::Input_error&) {
    return false;
  }
}

bool are_mesh_files(const std::vector<std::string>& file_names) {
  const auto meshes = std::count_if(file_names.begin(), file_names.end(), is_mesh_file);
  if (meshes > 0 && static_cast<std::size_t>(meshes) < file_names.size())
    throw Usage_error("expected files of patches or files of meshes, not both at a time");
  return meshes > 0;
}

Mesh_file read_mesh_file(const std::string& file_name) {
  namespace PMP = CGAL::Polygon_mesh_processing;
  const Soup soup = read_soup(file_name);
  check_faces(soup, file_name);
  Mesh_file result;
  if (!PMP::is_polygon_soup_a_polygon_mesh(soup.faces)) {
    result.defect = defect(soup);
    return result;
  }
  std::ifstream in = MP::internal::open_for_reading(file_name);
  if (!read_with_properties(in, MP::IO::mesh_format(file_name), result.mesh)) {
    result.mesh.clear();
    PMP::polygon_soup_to_polygon_mesh(soup.points, soup.faces, result.mesh);
  }
  return result;
}

} // namespace multipatch
