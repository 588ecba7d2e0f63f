// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_MAKE_DOMAIN_H
#define CGAL_MULTISIDED_PATCHES_MAKE_DOMAIN_H

#include <CGAL/Multisided_patches/domains/Domain_options.h>
#include <CGAL/Multisided_patches/domains/Polygonal_domain_2.h>
#include <CGAL/Multisided_patches/domains/make_circular_domain.h>
#include <CGAL/Multisided_patches/domains/make_projected_domain.h>
#include <CGAL/Multisided_patches/domains/make_regular_domain.h>
#include <CGAL/Multisided_patches/domains/make_similarity_domain.h>
#include <CGAL/Multisided_patches/internal/to_text.h>
#include <CGAL/Multisided_patches/ribbons/Ribbon_loop_3.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {

//! How a domain came about.
struct Domain_report {
  //! A generator that was passed over, or taken with reservations, and why.
  struct Remark {
    Domain_generator generator;
    std::string reason;
  };

  Domain_generator requested = Domain_generator::automatic;
  Domain_generator used = Domain_generator::automatic;
  //! how far a similarity domain had to be taken towards the regular one, in [0,1]
  double repair = 0;
  //! the smallest distance between sides that share no vertex, as a fraction of the larger side of
  //! the bounding box; infinity for a triangle
  double clearance = 0;
  double wanted_clearance = 0;
  std::vector<Remark> remarks;
};

//! A domain and how it came about.
template <typename Traits>
struct Generated_domain {
  Polygonal_domain_2<Traits> domain;
  Domain_report report;
};

namespace internal {

// Tries generators on one loop and keeps account of what happened.
template <typename Traits>
class Domain_maker {
public:
  using Domain = Polygonal_domain_2<Traits>;
  using Loop = Ribbon_loop_3<Traits>;

  Domain_maker(const Loop& loop, const Domain_options& options) : loop_(loop) {
    report_.requested = options.generator;
    report_.wanted_clearance = options.clearance;
    if (!(options.clearance >= 0))
      throw Input_error("the wanted clearance must be a number that is not negative, not " +
                        to_short_text(options.clearance));
  }

  Generated_domain<Traits> make() {
    for (Domain_generator generator : candidates())
      if (std::optional<Domain> domain = attempt(generator))
        return finished(generator, std::move(*domain));
    // No polygon has these corner types, so one without reflex corners has to do.
    remark(
        Domain_generator::regular,
        "taken without the loop's reflex corners; do the inner rows of the ribbons lead inwards?");
    Domain domain(to_unit_box<Traits>(regular_polygon(loop_.size())));
    report_.clearance = domain.clearance();
    return finished(Domain_generator::regular, std::move(domain));
  }

private:
  // Half-way to the regular domain little is left of the similarity; then others are better.
  static constexpr int repair_steps = 16, max_repair_steps = 8;

  Generated_domain<Traits> finished(Domain_generator generator, Domain domain) {
    if (report_.clearance < report_.wanted_clearance)
      remark(generator, "the clearance of " + to_short_text(report_.clearance) +
                            " is less than the wanted " + to_short_text(report_.wanted_clearance));
    report_.used = generator;
    return {std::move(domain), std::move(report_)};
  }

  std::vector<Domain_generator> candidates() {
    using G = Domain_generator;
    std::vector<G> order{G::similarity, G::similarity_outer, G::projected, G::circular, G::regular};
    G first = report_.requested;
    if (first == G::curved) {
      remark(G::curved, "curved domains do not exist yet; similarity is taken instead");
      first = G::similarity;
    }
    if (first != G::automatic) {
      order.erase(std::find(order.begin(), order.end(), first));
      order.insert(order.begin(), first);
    }
    return order;
  }

  std::optional<Domain> attempt(Domain_generator generator) {
    report_.repair = 0;
    try {
      switch (generator) {
      case Domain_generator::similarity:
        return similarity(generator, Angle_scaling::inner_angles);
      case Domain_generator::similarity_outer:
        return similarity(generator, Angle_scaling::smaller_angles);
      case Domain_generator::projected:
        return checked(make_projected_domain(loop_));
      case Domain_generator::circular:
        return checked(make_circular_domain(loop_));
      default:
        return checked(make_regular_domain(loop_));
      }
    } catch (const Input_error& error) {
      remark(generator, error.what());
      return std::nullopt;
    }
  }

  // The first domain on the way to the regular one that is valid and has the wanted clearance, or
  // else the valid one with the largest clearance.
  std::optional<Domain> similarity(Domain_generator generator, Angle_scaling scaling) {
    const Polygon_shape shape = similar_shape(loop_, scaling);
    std::optional<Domain> best;
    double best_clearance = -1, best_repair = 0;
    std::string trouble = "too narrow";
    for (int step = 0; step <= max_repair_steps && best_clearance < report_.wanted_clearance;
         ++step) {
      const double repair = static_cast<double>(step) / repair_steps;
      try {
        Domain domain = checked(repaired_domain(loop_, shape, repair));
        if (report_.clearance > best_clearance) {
          best_clearance = report_.clearance;
          best_repair = repair;
          best.emplace(std::move(domain));
        }
      } catch (const Input_error& error) {
        if (step == 0)
          trouble = error.what();
      }
    }
    if (!best)
      throw Input_error(trouble + "; no repair made it valid");
    report_.clearance = best_clearance;
    report_.repair = best_repair;
    if (best_repair > 0)
      remark(generator, trouble + "; repaired by taking it " + to_short_text(100 * best_repair) +
                            " percent of the way to the regular domain");
    return best;
  }

  // Passes a domain on if it is reflex exactly where the loop is, and measures its clearance.
  Domain checked(Domain domain) {
    for (std::size_t i = 0; i < loop_.size(); ++i) {
      const Corner_type wanted = loop_.corner_type(i), is = domain.corner_type(i);
      if (wanted != Corner_type::straight && wanted != is)
        throw Input_error("corner " + std::to_string(i) + " is " + to_string(is) + ", not " +
                          to_string(wanted) + " as in the loop");
    }
    report_.clearance = domain.clearance();
    return domain;
  }

  void remark(Domain_generator generator, const std::string& reason) {
    report_.remarks.push_back({generator, reason});
  }

  const Loop& loop_;
  Domain_report report_;
};

} // namespace internal

/*!
 * makes a valid domain for a loop: convex and reflex exactly where the loop is, straight corners
 * going either way.
 *
 * The requested generator comes first, then similarity, similarity with outer angles, projected,
 * circular and regular; the first that gives a valid domain is taken. A similarity domain that
 * crosses itself or is narrower than wanted is repaired before it is given up, by taking it up to
 * half of the way to the regular domain. Since the regular generator cannot fail on a loop with 3
 * or more corners that are not reflex, there always is a domain; on other loops, which no planar
 * polygon can resemble, it is a regular polygon, and the report says so.
 *
 * \throws Input_error if the wanted clearance is negative or not a number
 *
 * Complexity: O(n²) for n sides, because of the clearance.
 */
template <typename Traits>
Generated_domain<Traits> make_domain(const Ribbon_loop_3<Traits>& loop,
                                     const Domain_options& options = {}) {
  return internal::Domain_maker<Traits>(loop, options).make();
}

} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_MAKE_DOMAIN_H
