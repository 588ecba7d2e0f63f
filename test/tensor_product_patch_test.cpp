// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "parametric_fixtures.h"

#include <CGAL/Multisided_patches/internal/integer_power.h>
#include <CGAL/Multisided_patches/patches/Tensor_product_patch_3.h>
#include <CGAL/Multisided_patches/ribbons/Generalized_bezier_net_3.h>

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

using namespace parametric_fixtures;

namespace {

using Tensor_product = MP::Tensor_product_patch_3<Kernel>;
using Double_tensor_product = MP::Tensor_product_patch_3<Double_kernel>;

constexpr unsigned seed = 20261127;

Tensor_product random_tensor_product(Random& random, std::size_t d, std::size_t e) {
  return Tensor_product(d, e, random.points((d + 1) * (e + 1)));
}

Surface polynomial(const Tensor_product& patch, const Point_2& uv) {
  const std::size_t d = patch.degree_u(), e = patch.degree_v();
  const auto bernstein = [](std::size_t n, std::size_t i, const Jet& t) {
    return MP::internal::integer_power(t, i) * MP::internal::integer_power(Jet(Jet(1) - t), n - i) *
           Rational(factorial(n) / (factorial(i) * factorial(n - i)));
  };
  Surface sum;
  for (std::size_t i = 0; i <= d; ++i)
    for (std::size_t j = 0; j <= e; ++j)
      add(sum, bernstein(d, i, Jet::u_variable(uv.x())) * bernstein(e, j, Jet::v_variable(uv.y())),
          patch.control_point(i, j));
  return sum;
}

Vector_2 into_square(std::size_t side, const Point_2&) {
  const std::array<Vector_2, 4> inwards{Vector_2(0, 1), Vector_2(-1, 0), Vector_2(0, -1),
                                        Vector_2(1, 0)};
  return inwards[side];
}

} // namespace

TEST_CASE("A tensor product patch is the product of its Bernstein sums, with derivatives") {
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t d = 1; d <= 4; ++d)
    for (std::size_t e = 1; e <= 4; ++e)
      check_polynomial(random_tensor_product(random, d, e), polynomial);
}

TEST_CASE("A tensor product patch of higher degrees is the same surface") {
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t d = 1; d <= 3; ++d)
    for (std::size_t e = 1; e <= 3; ++e) {
      const Tensor_product patch = random_tensor_product(random, d, e);
      for (const auto& [du, dv] : {std::pair<std::size_t, std::size_t>(0, 2), {1, 0}, {2, 1}}) {
        const Tensor_product higher = patch.elevated_to(d + du, e + dv);
        CHECK(higher.degree_u() == d + du);
        CHECK(higher.degree_v() == e + dv);
        check_same_surface(higher, patch);
      }
    }
}

TEST_CASE("The ribbons of a tensor product patch have the derivatives of the surface, exactly") {
  CAPTURE(seed);
  Random random(seed);
  for (std::size_t d = 1; d <= 6; ++d)
    for (std::size_t e = 1; e <= 6; ++e) {
      const Tensor_product patch = random_tensor_product(random, d, e);
      CHECK(patch.loop()[0].layers() == (e + 1) / 2);
      CHECK(patch.loop()[1].layers() == (d + 1) / 2);
      check_ribbons(patch, into_square);
    }
}

TEST_CASE("A continuity report finds a tensor product patch to meet its ribbons") {
  CAPTURE(seed);
  Random random(seed);
  for (const std::size_t degree : {1, 3, 5})
    check_continuity(random_tensor_product(random, degree, degree + 1));
}

TEST_CASE("The ribbons of a square patch are those of its net as a generalized Bezier patch") {
  CAPTURE(seed);
  Random random(seed);
  for (const std::size_t d : {3, 4, 5, 6}) {
    const Tensor_product patch = random_tensor_product(random, d, d);
    using Net = MP::Generalized_bezier_net_3<Kernel>;
    const Net layout(4, d,
                     std::vector<Point_3>(Net::number_of_control_points(4, d), Point_3(0, 0, 0)));
    std::vector<Point_3> points = layout.control_points();
    for (std::size_t j = 0; j <= d; ++j)
      for (std::size_t k = 0; k < layout.layers(); ++k) {
        points[layout.index(0, j, k)] = patch.control_point(j, k);
        points[layout.index(1, j, k)] = patch.control_point(d - k, j);
        points[layout.index(2, j, k)] = patch.control_point(d - j, d - k);
        points[layout.index(3, j, k)] = patch.control_point(k, d - j);
      }
    const auto loop = layout.with_control_points(points).loop();
    for (std::size_t i = 0; i < 4; ++i)
      CHECK(patch.loop()[i].control_points() == loop[i].control_points());
  }
}

TEST_CASE("A bilinear patch has its corners in counterclockwise order") {
  const Point_3 corners[4] = {{0, 0, 0}, {2, 0, 1}, {2, 3, 0}, {0, 3, 1}};
  const Tensor_product patch =
      Tensor_product::bilinear(corners[0], corners[1], corners[2], corners[3]);
  CHECK(patch.degree_u() == 1);
  CHECK(patch.degree_v() == 1);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(patch(patch.domain().vertex(i)) == corners[i]);
    CHECK(patch.loop().corner_point(i) == corners[i]);
  }
  const Rational u = ratio(1, 3), v = ratio(3, 4);
  CHECK(patch({u, v}) == Point_3(2 * u, 3 * v, u + v - 2 * u * v));
}

TEST_CASE("Normals of a tensor product patch point to where its boundary runs counterclockwise") {
  check_normals_of_saddle(Tensor_product::bilinear({0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}));
}

TEST_CASE("A tensor product patch over doubles is evaluated in rationals at once") {
  CAPTURE(seed);
  const std::vector<Double_point> points = doubles(seed, 20);
  check_evaluation_in_rationals(Double_tensor_product(3, 4, points),
                                Tensor_product(3, 4, converted(points)));
}

TEST_CASE("A tensor product patch refuses sizes that do not fit") {
  using Catch::Matchers::Contains;
  const auto tensor_product = [](std::size_t d, std::size_t e, std::size_t n) {
    return Tensor_product(d, e, std::vector<Point_3>(n, Point_3(0, 0, 0)));
  };
  CHECK_THROWS_WITH(tensor_product(0, 2, 3), Contains("from 1 to 1000, not 0 by 2"));
  CHECK_THROWS_WITH(tensor_product(2, 1001, 3), Contains("not 2 by 1001"));
  CHECK_THROWS_WITH(tensor_product(2, 3, 11),
                    Contains("degree 2 by 3 has 12 control points, not 11"));
  CHECK_THROWS_WITH(Tensor_product::bilinear({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}),
                    Contains("side 2 is a single point"));

  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(Double_tensor_product::bilinear({0, 0, 0}, {1, 0, 0}, {1, 1, nan}, {0, 1, 0}),
                    Contains("control point 3 of a tensor product patch is not finite"));
}
