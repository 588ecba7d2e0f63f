// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_TESSELLATION_VISITOR_H
#define CGAL_MULTISIDED_PATCHES_TESSELLATION_VISITOR_H

#include <CGAL/Multisided_patches/errors.h>

#include <cstddef>

namespace CGAL {
namespace Multisided_patches {

//! What the making of a mesh goes through.
enum class Tessellation_stage {
  meshing,    //!< points and triangles in the domain
  evaluation, //!< points and normals of the surface, and what is next to what in the mesh
  assembly    //!< the caller's mesh: announced before it begins, and not interrupted
};

//! Thrown where a visitor does not want to go on. Nothing has been written by then.
class Cancelled : public Error {
public:
  Cancelled() : Error("cancelled") {}
};

/*!
 * What hears of the progress of a tessellation, and can end it: a class with this member. This one
 * lets everything run to its end.
 */
struct Tessellation_visitor {
  /*!
   * is called often, before every 16384 points at the latest, by the thread that called
   * `tessellate()` or by one at a time.
   *
   * \param stage what is being done
   * \param done,total how much of it is done, in points; the total may be an estimate, and grow.
   * Each patch of a complex tells about itself, and stages come again if a mesh is made several
   * times, or lengths on the surface are measured for it. So the ratio of the two is no share of
   * the whole: it goes back at times, and large meshes jump from a small ratio to 1
   *
   * \pre it does not look at the mesh of the caller: another thread may be making room in it
   *
   * \return whether to go on; if not, a `Cancelled` exception is thrown, and the mesh of the caller
   * stays as it was
   */
  bool go_further(Tessellation_stage stage, std::size_t done, std::size_t total) {
    static_cast<void>(stage);
    static_cast<void>(done);
    static_cast<void>(total);
    return true;
  }
};

namespace internal {

template <typename Visitor>
void report_progress(Visitor& visitor, Tessellation_stage stage, std::size_t done,
                     std::size_t total) {
  if (!visitor.go_further(stage, done, total))
    throw Cancelled();
}

} // namespace internal

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_TESSELLATION_VISITOR_H
