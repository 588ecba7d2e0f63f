// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_IO_SURFACE_MESH_H
#define CGAL_MULTISIDED_PATCHES_IO_SURFACE_MESH_H

#include <CGAL/Multisided_patches/IO/internal/file_access.h>
#include <CGAL/Multisided_patches/errors.h>
#include <CGAL/Multisided_patches/internal/cgal_compat.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/Surface_mesh/Surface_mesh.h>
#include <CGAL/boost/graph/IO/STL.h>

#include <ostream>
#include <string>

namespace CGAL {
namespace Multisided_patches {
namespace IO {

//! The file formats of meshes.
enum class Mesh_format {
  PLY, //!< binary; with normals, and all scalar vertex properties: u and v among them
  OBJ, //!< text; with normals
  OFF, //!< text; with normals
  STL  //!< binary; triangles only
};

//! the format that the extension of a file name stands for. \throws Input_error if it is none of
//! them
inline Mesh_format mesh_format(const std::string& file_name) {
  const std::string extension = Multisided_patches::internal::file_extension(file_name);
  if (extension == ".ply")
    return Mesh_format::PLY;
  if (extension == ".obj")
    return Mesh_format::OBJ;
  if (extension == ".off")
    return Mesh_format::OFF;
  if (extension == ".stl")
    return Mesh_format::STL;
  throw Input_error(file_name + ": expected a name that ends in .ply, .obj, .off or .stl");
}

namespace internal {

// CGAL's own writer gives the normals, but its faces do not refer to them.
template <typename Mesh, typename Normals>
void write_OBJ(std::ostream& out, const Mesh& mesh, const Normals& normals) {
  out.precision(17);
  for (const auto v : mesh.vertices())
    out << "v " << mesh.point(v) << '\n';
  if (normals)
    for (const auto v : mesh.vertices())
      out << "vn " << (*normals)[v] << '\n';
  for (const auto f : mesh.faces()) {
    out << 'f';
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) {
      out << ' ' << v.idx() + 1;
      if (normals)
        out << "//" << v.idx() + 1;
    }
    out << '\n';
  }
}

} // namespace internal

/*!
 * writes a mesh made by `tessellate()` in the format that the name asks for, whole or not at all.
 *
 * \throws Input_error if the extension is unknown, Error if the file cannot be written
 */
template <typename Point_3>
void write_mesh(const std::string& file_name, const Surface_mesh<Point_3>& mesh) {
  using Mesh = Surface_mesh<Point_3>;
  using Vector_3 = typename Kernel_traits<Point_3>::Kernel::Vector_3;
  const Mesh_format format = mesh_format(file_name);
  Multisided_patches::internal::Atomic_file file(file_name);
  auto& out = file.stream();
  const auto normal =
      Multisided_patches::internal::find_property_map<typename Mesh::Vertex_index, Vector_3>(
          mesh, "v:normal");
  // Doubles are read back as they were.
  const auto parameters = CGAL::parameters::stream_precision(17);

  if (format == Mesh_format::PLY || format == Mesh_format::STL)
    CGAL::IO::set_binary_mode(out);
  bool written = false;
  switch (format) {
  case Mesh_format::PLY:
    written = CGAL::IO::write_PLY(out, mesh);
    break;
  case Mesh_format::STL:
    written = CGAL::IO::write_STL(out, mesh);
    break;
  case Mesh_format::OFF:
    written = normal ? CGAL::IO::write_OFF(out, mesh, parameters.vertex_normal_map(*normal))
                     : CGAL::IO::write_OFF(out, mesh, parameters);
    break;
  case Mesh_format::OBJ:
    internal::write_OBJ(out, mesh, normal);
    written = out.good();
    break;
  }
  if (!written)
    throw Error(file_name + ": cannot be written: is the disk full?");
  file.commit();
}

} // namespace IO
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_IO_SURFACE_MESH_H
