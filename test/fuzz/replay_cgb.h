// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_FUZZ_REPLAY_CGB_H
#define MULTISIDED_PATCHES_TEST_FUZZ_REPLAY_CGB_H

#include "replay.h"

#include <CGAL/Multisided_patches/IO/CGB.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>

namespace fuzz {

using Model = MP::Concave_bezier_model_3<Kernel>;
using Ribbon = MP::Bezier_ribbon_3<Kernel>;

inline Model read_cgb(const std::string& bytes) {
  std::istringstream in(bytes);
  return MP::IO::read_CGB<Kernel>(in, "input");
}

inline std::string written(const Model& model) {
  std::ostringstream out;
  MP::IO::write_CGB(out, model);
  return out.str();
}

inline bool is_same_ribbon(const Ribbon& a, const Ribbon& b) {
  const auto &p = a.control_points(), &q = b.control_points();
  return a.degree() == b.degree() && a.layers() == b.layers() &&
         std::equal(p.begin(), p.end(), q.begin(), q.end(),
                    is_same_point<typename Kernel::Point_3>);
}

inline void require_same_model(const Model& a, const Model& b) {
  require(a.central_weight == b.central_weight && a.domain.generator == b.domain.generator &&
              is_same(a.domain.clearance, b.domain.clearance) &&
              is_same(a.parameter_dilation, b.parameter_dilation),
          "the options survive");
  require(is_same_point(a.central_point.value(), b.central_point.value()),
          "the central control point survives");
  const auto &r = a.loop.ribbons(), &s = b.loop.ribbons();
  require(std::equal(r.begin(), r.end(), s.begin(), s.end(), is_same_ribbon),
          "the ribbons survive");
  require(a.loop.bbox() == b.loop.bbox(), "the bounding box survives");
  const auto &c = a.corner_control_points, &d = b.corner_control_points;
  require(std::equal(c.begin(), c.end(), d.begin(), d.end(),
                     [](const auto& x, const auto& y) {
                       return x.index == y.index && is_same_point(x.point, y.point);
                     }),
          "the extra corner control points survive");
}

// The corners of a loop that was accepted are closed, and it knows the geometry of all of them.
inline void require_valid_loop(const Model::Loop& loop) {
  require(loop.size() >= 3, "a loop has at least 3 sides");
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Ribbon& ribbon = loop[i];
    require(ribbon.control_point(ribbon.degree(), 0) == loop.corner_point(loop.next(i)),
            "the loop closes");
    require(loop.corner_angle(i) >= 0 && loop.corner_angle(i) <= 2 * MP::internal::pi,
            "corner angles are in [0,2 pi]");
    require(loop.corner_normal_mismatch(i) >= 0 &&
                loop.corner_normal_mismatch(i) <= MP::internal::pi,
            "angles between normals are in [0,pi]");
  }
}

// A .cgb file is refused, or gives a model that is written and read back bit for bit.
inline void replay_cgb(const std::string& bytes) {
  const auto model = read_or_refuse([&] { return read_cgb(bytes); });
  if (!model)
    return;
  require_valid_loop(model->loop);
  const std::string text = written(*model);
  const Model again = read_cgb(text);
  require_same_model(*model, again);
  require(written(again) == text, "the same model is the same text");
}

} // namespace fuzz

#endif // MULTISIDED_PATCHES_TEST_FUZZ_REPLAY_CGB_H
