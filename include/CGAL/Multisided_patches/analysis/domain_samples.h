// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_ANALYSIS_DOMAIN_SAMPLES_H
#define CGAL_MULTISIDED_PATCHES_ANALYSIS_DOMAIN_SAMPLES_H

#include <CGAL/Multisided_patches/domains/Polygonal_domain_2.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

//! A point (u,v) of a domain (domain units), and where it lies.
template <typename FT>
struct Domain_sample {
  FT u, v;
  Domain_location<FT> location;
};

namespace internal {

// Collects samples of a domain.
template <typename Traits>
class Domain_sampler {
public:
  using FT = typename Traits::FT;
  using Point_2 = typename Traits::Point_2;
  using Vector_2 = typename Traits::Vector_2;
  using Domain = Polygonal_domain_2<Traits>;

  Domain_sampler(const Domain& domain, unsigned seed) : domain_(domain), random_(seed) {}

  void add_random(std::size_t count) {
    const Bbox_2 box = domain_.bbox();
    std::uniform_real_distribution<double> x(box.xmin(), box.xmax()), y(box.ymin(), box.ymax());
    const std::size_t end = samples_.size() + count;
    // A sliver across its bounding box is hit rarely.
    for (std::size_t k = 0; k < 1000 * count && samples_.size() < end; ++k) {
      const double u = x(random_), v = y(random_);
      add_inside(Point_2(FT(u), FT(v)));
    }
  }

  void add_on_side(std::size_t i, double s) {
    const Point_2 p = domain_.point_on_side(i, FT(s));
    samples_.push_back({p.x(), p.y(), domain_.location_on_side(i, FT(s))});
  }

  // at these distances from a random point of the side, in units of its length
  void add_near_side(std::size_t i, std::initializer_list<double> distances) {
    const Vector_2 d = domain_.vertex(domain_.next(i)) - domain_.vertex(i);
    const Point_2 foot = domain_.point_on_side(i, FT(uniform(0.1, 0.9)));
    for (const double distance : distances)
      add_inside(foot + FT(distance) * Vector_2(-d.y(), d.x()));
  }

  // at these distances from the vertex, in units of the shorter side, in a random direction, and on
  // both sides
  void add_near_vertex(std::size_t i, std::initializer_list<double> distances) {
    const std::size_t prev = domain_.prev(i);
    const Vector_2 out = domain_.vertex(domain_.next(i)) - domain_.vertex(i),
                   back = domain_.vertex(prev) - domain_.vertex(i);
    const double out_length = domain_.side_length(i), back_length = domain_.side_length(prev);
    const double angle = angle_between(out, back), length = (std::min)(out_length, back_length);
    for (const double distance : distances) {
      const double turn = uniform(0.1, 0.9) * angle, scale = length / out_length * distance;
      const FT c(scale * std::cos(turn)), s(scale * std::sin(turn));
      add_inside(domain_.vertex(i) +
                 Vector_2(c * out.x() - s * out.y(), s * out.x() + c * out.y()));
      add_on_side(i, distance);
      if (FT(1) - FT(distance) < FT(1))
        add_on_side(prev, 1 - distance);
    }
  }

  std::vector<Domain_sample<FT>> take() { return std::move(samples_); }

private:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  // from `out` counterclockwise to `back` (radians, in (0,2π))
  static double angle_between(const Vector_2& out, const Vector_2& back) {
    const double cross = CGAL::to_double(out.x() * back.y() - out.y() * back.x()),
                 dot = CGAL::to_double(out.x() * back.x() + out.y() * back.y());
    const double angle = std::atan2(cross, dot);
    return angle > 0 ? angle : angle + 2 * CGAL_PI;
  }

  // Rounding, or a narrow domain, may put a point elsewhere.
  void add_inside(const Point_2& p) {
    const Domain_location<FT> location = domain_.locate(p);
    if (location.kind == Domain_location<FT>::Kind::interior)
      samples_.push_back({p.x(), p.y(), location});
  }

  const Domain& domain_;
  std::mt19937 random_;
  std::vector<Domain_sample<FT>> samples_;
};

} // namespace internal

/*!
 * chooses points of a domain where formulas are put to the test: random ones inside, on all sides,
 * at all vertices, and at 1e-3, 1e-6, 1e-9 and 1e-12 of the sides' lengths from both.
 *
 * \param domain the domain
 * \param number_inside the number of random points inside, or fewer if the domain is a small
 * part of its bounding box; 19 or fewer points come from each side
 * \param seed of the random numbers; the same seed gives the same samples
 *
 * Complexity: O(n) for each sample, and for each random point of the bounding box outside the
 * domain, n being the number of sides.
 */
template <typename Traits>
std::vector<Domain_sample<typename Traits::FT>>
domain_samples(const Polygonal_domain_2<Traits>& domain, std::size_t number_inside,
               unsigned seed = 1) {
  internal::Domain_sampler<Traits> sampler(domain, seed);
  sampler.add_random(number_inside);
  for (std::size_t i = 0; i < domain.size(); ++i) {
    for (const double s : {0., 0.25, 0.5})
      sampler.add_on_side(i, s);
    sampler.add_near_side(i, {1e-3, 1e-6, 1e-9, 1e-12});
    sampler.add_near_vertex(i, {1e-3, 1e-6, 1e-9, 1e-12});
  }
  return sampler.take();
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_ANALYSIS_DOMAIN_SAMPLES_H
