// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_CONTROL_NET_FIXTURES_H
#define MULTISIDED_PATCHES_TEST_CONTROL_NET_FIXTURES_H

#include "fixtures.h"

#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>
#include <CGAL/Multisided_patches/patches/Generalized_bezier_patch_3.h>
#include <CGAL/Multisided_patches/patches/S_patch_3.h>

#include <cmath>
#include <cstddef>
#include <vector>

// Random patches of all kinds that have a control net, and samples of their domains.
namespace fixtures {

using Mean_value = MP::Mean_value_coordinates_2<Kernel>;
using Concave_patch = MP::Concave_bezier_patch_3<Kernel, Mean_value>;
using Generalized_patch = MP::Generalized_bezier_patch_3<Kernel>;
using S_patch = MP::S_patch_3<Kernel>;

// Points of a domain, and where they lie.
template <typename Traits>
struct Samples {
  using Point = typename Traits::Point_2;
  using Location = typename MP::Polygonal_domain_2<Traits>::Location;

  std::vector<Point> points;
  std::vector<Location> locations;

  void add(const MP::Polygonal_domain_2<Traits>& domain, const Point& p) {
    points.push_back(p);
    locations.push_back(domain.locate(p));
  }
};

// Points inside a domain, close to corners, on the sides and at vertices, in no order.
template <typename Traits>
Samples<Traits> random_samples(const MP::Polygonal_domain_2<Traits>& domain, Random& random,
                               std::size_t count) {
  using Location = typename MP::Polygonal_domain_2<Traits>::Location;
  const CGAL::Bbox_2 box = domain.bbox();
  Samples<Traits> samples;
  while (samples.points.size() < count) {
    const std::size_t i = random.integer(0, domain.size() - 1), kind = random.integer(0, 7);
    if (kind == 0) {
      samples.points.push_back(domain.vertex(i));
      samples.locations.push_back(Location::on_vertex(i));
    } else if (kind <= 2) {
      const typename Traits::FT s(random.in(0.01, 0.99));
      samples.points.push_back(domain.point_on_side(i, s));
      samples.locations.push_back(Location::on_side(i, s));
    } else {
      const double scale = kind == 3 ? std::pow(10, -random.in(1, 9)) : 1;
      const auto& corner = domain.vertex(i);
      const typename Traits::Point_2 anywhere(random.in(box.xmin(), box.xmax()),
                                              random.in(box.ymin(), box.ymax()));
      const typename Traits::Point_2 p = corner + typename Traits::FT(scale) * (anywhere - corner);
      if (domain.locate(p).kind == Location::Kind::interior)
        samples.add(domain, p);
    }
  }
  return samples;
}

// A concave patch of ribbons of different degrees and layers.
inline Concave_patch concave_patch(Random& random, std::size_t n, MP::Central_weight central) {
  Concave_patch::Model model(random_loop(random, n, 0.1));
  model.central_weight = central;
  model.central_point = Point_3(0, 0, random.in(0.2, 0.6));
  return Concave_patch(model, Mean_value(Domain(star_shaped_polygon(random, n, 0.4))));
}

// Rings of control points around the origin, moved at random.
template <typename Traits>
MP::Generalized_bezier_net_3<Traits> generalized_net(Random& random, std::size_t n,
                                                     std::size_t degree) {
  using Net = MP::Generalized_bezier_net_3<Traits>;
  using Point = typename Traits::Point_3;
  std::vector<Point> points;
  for (std::size_t c = Net::number_of_control_points(n, degree); c > 0; --c)
    points.emplace_back(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1));
  return Net(n, degree, points);
}

inline MP::S_patch_net_3<Kernel> s_net(Random& random, std::size_t n, std::size_t depth) {
  using Net = MP::S_patch_net_3<Kernel>;
  std::vector<Point_3> points;
  for (std::size_t c = Net::number_of_control_points(n, depth); c > 0; --c)
    points.emplace_back(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1));
  return Net(n, depth, points);
}

} // namespace fixtures

#endif // MULTISIDED_PATCHES_TEST_CONTROL_NET_FIXTURES_H
