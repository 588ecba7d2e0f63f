// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_INTERNAL_CGAL_COMPAT_H
#define CGAL_MULTISIDED_PATCHES_INTERNAL_CGAL_COMPAT_H

#include <CGAL/version.h>

#include <optional>
#include <string>

// All that differs between the versions of CGAL that the package supports; nothing else tests
// CGAL_VERSION_NR.

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// The property map of a Surface_mesh with a name and type, if there is one.
template <typename Index, typename T, typename Mesh>
auto find_property_map(const Mesh& mesh, const std::string& name) {
#if CGAL_VERSION_NR >= 1060000000
  return mesh.template property_map<Index, T>(name);
#else
  const auto found = mesh.template property_map<Index, T>(name);
  return found.second ? std::make_optional(found.first) : std::nullopt;
#endif
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_INTERNAL_CGAL_COMPAT_H
