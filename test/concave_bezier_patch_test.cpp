// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"

#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

using namespace fixtures;
using Patch = MP::Concave_bezier_patch_3<Kernel>;
using Model = Patch::Model;
using Location = Domain::Location;

namespace {

double bowl(double x, double y) {
  return 0.3 * x * x - 0.2 * y * y + 0.1 * x * y;
}

template <typename FT>
std::vector<FT> bernstein(std::size_t degree, const FT& t) {
  std::vector<FT> b(degree + 1);
  MP::internal::bernstein_polynomials(degree, t, b.data());
  return b;
}

// Σ B_a(u) B_b(v) net[a][b]
template <typename Point, typename FT>
Point tensor_product_point(const std::vector<std::vector<Point>>& net, const FT& u, const FT& v) {
  const auto bu = bernstein(net.size() - 1, u), bv = bernstein(net.size() - 1, v);
  FT x(0), y(0), z(0);
  for (std::size_t a = 0; a < net.size(); ++a)
    for (std::size_t b = 0; b < net.size(); ++b) {
      x += bu[a] * bv[b] * net[a][b].x();
      y += bu[a] * bv[b] * net[a][b].y();
      z += bu[a] * bv[b] * net[a][b].z();
    }
  return Point(x, y, z);
}

template <typename Traits>
std::vector<std::vector<typename Traits::Point_3>> random_net(Random& random, std::size_t degree) {
  using FT = typename Traits::FT;
  std::vector<std::vector<typename Traits::Point_3>> net(degree + 1);
  for (std::size_t a = 0; a <= degree; ++a)
    for (std::size_t b = 0; b <= degree; ++b)
      net[a].emplace_back(FT(static_cast<double>(a) + random.in(-0.2, 0.2)),
                          FT(static_cast<double>(b) + random.in(-0.2, 0.2)), FT(random.in(-1, 1)));
  return net;
}

double distance(const Point_3& a, const Point_3& b) {
  return std::sqrt(CGAL::squared_distance(a, b));
}

Point_3 point(const Patch::Surface_jet<2>& surface) {
  return {surface[0].value(), surface[1].value(), surface[2].value()};
}

double angle(const Vector_3& a, const Vector_3& b) {
  return MP::internal::angle_between(MP::internal::to_vec3(a), MP::internal::to_vec3(b));
}

// A model of BarycentricCoordinates_2 that has nothing to do with the package's own: the bilinear
// coordinates of the unit square.
class Bilinear {
public:
  using Geom_traits = Kernel;
  using FT = double;
  using Point_2 = Kernel::Point_2;

  explicit Bilinear(const Domain& domain) : domain_(domain) {}
  const Domain& domain() const { return domain_; }
  template <int Order>
  void evaluate(const Point_2& p, const Location&, MP::Jet_2<FT, Order>* lambda) const {
    using Jet = MP::Jet_2<FT, Order>;
    const Jet u = Jet::u_variable(p.x()), v = Jet::v_variable(p.y());
    lambda[0] = (1.0 - u) * (1.0 - v);
    lambda[1] = u * (1.0 - v);
    lambda[2] = u * v;
    lambda[3] = (1.0 - u) * v;
  }

private:
  Domain domain_;
};

// The affine map of the plane that takes triangle a to triangle b.
Point_2 mapped(const Point_2& p, const std::array<Point_2, 3>& a, const std::array<Point_2, 3>& b) {
  const double whole = CGAL::area(a[0], a[1], a[2]);
  const double x = CGAL::area(p, a[1], a[2]) / whole, y = CGAL::area(a[0], p, a[2]) / whole;
  return CGAL::ORIGIN + x * (b[0] - CGAL::ORIGIN) + y * (b[1] - CGAL::ORIGIN) +
         (1 - x - y) * (b[2] - CGAL::ORIGIN);
}

} // namespace

TEST_CASE("On a square the patch is the tensor product Bezier patch") {
  const unsigned seed = 20260107;
  CAPTURE(seed);
  Random random(seed);
  using Square_patch = MP::Concave_bezier_patch_3<Kernel, MP::Wachspress_coordinates_2<Kernel>>;
  const MP::Wachspress_coordinates_2<Kernel> coordinates{Domain({{0, 0}, {1, 0}, {1, 1}, {0, 1}})};
  for (const std::size_t degree : {1, 3, 5, 7, 9})
    for (const auto weight : {MP::Central_weight::weight_deficiency, MP::Central_weight::none}) {
      const auto net = random_net<Kernel>(random, degree);
      Model model(tensor_product_loop<Kernel>(net));
      model.central_weight = weight;
      model.central_point = Point_3(100, 100, 100); // the deficiency is 0, so it has no effect
      const Square_patch patch(model, coordinates);
      for (int k = 0; k < 50; ++k) {
        const double u = random.in(0, 1), v = random.in(0, 1);
        CHECK(distance(patch({u, v}), tensor_product_point(net, u, v)) < 1e-13 * 100);
      }
    }
}

TEST_CASE("On a square the patch in exact arithmetic equals the tensor product Bezier patch") {
  using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  using FT = Exact::FT;
  Random random(12);
  const MP::Wachspress_coordinates_2<Exact> coordinates{
      MP::Polygonal_domain_2<Exact>(std::vector<Exact::Point_2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}})};
  for (const std::size_t degree : {1, 3, 5}) {
    const auto net = random_net<Exact>(random, degree);
    const MP::Concave_bezier_patch_3<Exact, MP::Wachspress_coordinates_2<Exact>> patch(
        MP::Concave_bezier_model_3<Exact>(tensor_product_loop<Exact>(net)), coordinates);
    const FT u = FT(3) / FT(7), v = FT(5) / FT(11);
    CHECK(patch(Exact::Point_2(u, v)) == tensor_product_point(net, u, v));
  }
}

TEST_CASE("The patch runs into its boundary curves, and has its ribbons' tangent planes there") {
  Random random(13);
  for (const auto& polygon : {l_shape(), u_shape(), star_shaped_polygon(random, 7, 0.4)}) {
    const Loop loop = lifted_loop(polygon, bowl);
    const Patch patch(loop);
    const Domain& domain = patch.domain();
    for (std::size_t i = 0; i < domain.size(); ++i) {
      CHECK(patch(domain.vertex(i)) == loop.corner_point(i));
      CHECK(patch.point_on_side(i, 0) == loop.corner_point(i));
      CHECK(patch.point_on_side(i, 1) == loop.corner_point(domain.next(i)));
      CHECK(patch.normal_on_side(i, 1) == loop.corner_normal(domain.next(i)));
      for (const double s : {0.1, 0.3, 0.5, 0.9}) {
        const Point_2 uv = domain.point_on_side(i, s);
        const auto location = Location::on_side(i, s);
        CHECK(patch.point(uv, location) == loop[i].boundary_point(s));
        // The formula itself, not the shortcut for points on the boundary.
        const auto surface = patch.evaluate<2>(uv, location);
        CHECK(distance(point(surface), loop[i].boundary_point(s)) < 1e-13);
        const Vector_3 su(surface[0][1], surface[1][1], surface[2][1]);
        const Vector_3 sv(surface[0][2], surface[1][2], surface[2][2]);
        const Vector_3 ribbon =
            CGAL::cross_product(loop[i].boundary_derivative(s), loop[i].cross_derivative(s));
        CHECK(angle(CGAL::cross_product(su, sv), ribbon) < 1e-6);
        CHECK(angle(patch.normal(uv, location), ribbon) < 1e-12);
        CHECK(patch.normal_on_side(i, s) == patch.normal(uv, location));
      }
    }
  }
}

TEST_CASE("Close to a side the patch is close to the tangent plane of the ribbon") {
  const Loop loop = lifted_loop(u_shape(), bowl);
  const Patch patch(loop);
  const Domain& domain = patch.domain();
  for (std::size_t i = 0; i < domain.size(); ++i) {
    const Point_2 on_side = domain.point_on_side(i, 0.4);
    const Point_3 origin = patch.point(on_side, Location::on_side(i, 0.4));
    const Vector_3 normal = patch.normal(on_side, Location::on_side(i, 0.4));
    const Kernel::Vector_2 along = domain.vertex(domain.next(i)) - domain.vertex(i);
    const Kernel::Vector_2 inwards =
        along.perpendicular(CGAL::COUNTERCLOCKWISE) / domain.side_length(i);
    // First order contact: a tenth of the distance leaves a hundredth of the deviation.
    double deviation[2];
    for (int k = 0; k < 2; ++k) {
      const double step = k == 0 ? 1e-3 : 1e-4;
      deviation[k] = std::abs((patch(on_side + step * inwards) - origin) * normal);
    }
    CHECK(deviation[1] < 0.02 * deviation[0] + 1e-13);
  }
}

TEST_CASE("Derivatives of the patch are the limits of differences") {
  const unsigned seed = 20260108;
  CAPTURE(seed);
  Random random(seed);
  const Patch patch(lifted_loop(l_shape(), bowl));
  for (int k = 0; k < 20; ++k) {
    const Point_2 p = interior_point(random, patch.domain());
    const double step = 1e-5;
    const auto at = patch.evaluate<2>(p);
    const auto right = patch.evaluate<1>({p.x() + step, p.y()});
    const auto left = patch.evaluate<1>({p.x() - step, p.y()});
    const auto up = patch.evaluate<1>({p.x(), p.y() + step});
    const auto down = patch.evaluate<1>({p.x(), p.y() - step});
    for (int c = 0; c < 3; ++c) {
      CHECK(at[c][1] == Approx((right[c][0] - left[c][0]) / (2 * step)).margin(1e-4));
      CHECK(at[c][2] == Approx((up[c][0] - down[c][0]) / (2 * step)).margin(1e-4));
      const double margin = 1e-2 * (1 + std::abs(at[c][3]) + std::abs(at[c][5]));
      CHECK(at[c][3] == Approx((right[c][1] - left[c][1]) / (2 * step)).margin(margin));
      CHECK(at[c][4] == Approx((up[c][1] - down[c][1]) / (2 * step)).margin(margin));
      CHECK(at[c][5] == Approx((up[c][2] - down[c][2]) / (2 * step)).margin(margin));
    }
  }
}

TEST_CASE("A planar loop is filled by a planar patch") {
  const Loop loop = lifted_loop(l_shape(), [](double x, double y) { return 2 * x - y + 1; });
  const Patch patch(loop);
  Random random(14);
  for (int k = 0; k < 50; ++k) {
    const Point_3 p = patch(interior_point(random, patch.domain()));
    CHECK(p.z() == Approx(2 * p.x() - p.y() + 1).margin(1e-13));
  }
}

TEST_CASE("A mirror symmetric loop is filled by a mirror symmetric patch") {
  // Vertex i of the U is the mirror image of vertex 7 - i.
  const Loop loop =
      lifted_loop(u_shape(), [](double x, double y) { return 0.3 * x * x - y * y / 5; });
  for (const auto weight : {MP::Central_weight::none, MP::Central_weight::full_product}) {
    Model model(loop);
    model.central_weight = weight;
    const Patch patch(model);
    const auto& v = patch.domain().vertices();
    Random random(15);
    for (int k = 0; k < 50; ++k) {
      const Point_2 p = interior_point(random, patch.domain());
      const Point_2 mirrored = mapped(p, {v[0], v[2], v[4]}, {v[7], v[5], v[3]});
      const Point_3 a = patch(p), b = patch(mirrored);
      CHECK(distance(a, Point_3(-b.x(), b.y(), b.z())) < 1e-6);
    }
  }
}

TEST_CASE("Where the loop starts does not change the patch") {
  const Loop loop = lifted_loop(l_shape(), bowl);
  const Patch patch(loop);
  auto ribbons = loop.ribbons();
  std::rotate(ribbons.begin(), ribbons.begin() + 2, ribbons.end());
  const Patch rotated{Loop(ribbons)};
  const auto &v = patch.domain().vertices(), &w = rotated.domain().vertices();
  Random random(16);
  for (int k = 0; k < 50; ++k) {
    const Point_2 p = interior_point(random, patch.domain());
    CHECK(distance(patch(p), rotated(mapped(p, {v[2], v[4], v[0]}, {w[0], w[2], w[4]}))) < 1e-6);
  }
}

TEST_CASE("Moving and scaling the loop moves and scales the patch") {
  const Loop loop = lifted_loop(u_shape(), bowl);
  const Patch patch(loop);
  for (const double scale : {1e-6, 1e6}) {
    std::vector<Ribbon> ribbons;
    const auto moved = [&](const Point_3& p) {
      return Point_3(scale * p.y(), scale * p.z(), scale * p.x());
    };
    for (const Ribbon& r : loop.ribbons()) {
      std::vector<Point_3> points;
      for (const Point_3& p : r.control_points())
        points.push_back(moved(p));
      ribbons.emplace_back(r.degree(), r.layers(), points);
    }
    const Patch other{Loop(ribbons)};
    Random random(17);
    for (int k = 0; k < 20; ++k) {
      const Point_2 p = interior_point(random, patch.domain());
      CHECK(distance(other(p), moved(patch(p))) < 1e-6 * scale);
    }
  }
}

TEST_CASE("Many points at once are the same as one by one") {
  const Patch patch(lifted_loop(l_shape(), bowl));
  Random random(18);
  std::vector<Point_2> points;
  for (int k = 0; k < 2000; ++k)
    points.push_back(interior_point(random, patch.domain()));
  std::vector<Point_3> parallel, sequential;
  patch.evaluate_points(points, std::back_inserter(parallel));
  patch.evaluate_points<CGAL::Sequential_tag>(points, std::back_inserter(sequential));
  CHECK(parallel == sequential);
  for (std::size_t k = 0; k < points.size(); ++k)
    CHECK(parallel[k] == patch(points[k]));
  points.emplace_back(50, 50);
  CHECK_THROWS_AS(patch.evaluate_points(points, std::back_inserter(parallel)),
                  MP::Outside_domain_error);
}

TEST_CASE("The central control point pulls the patch as far as its weight says") {
  Model model(lifted_loop(l_shape(), bowl));
  const Patch without(model);
  for (const auto weight :
       {MP::Central_weight::weight_deficiency, MP::Central_weight::adjacent_products,
        MP::Central_weight::full_product}) {
    model.central_weight = weight;
    model.central_point = Point_3(0, 0, 0);
    const Patch low(model);
    model.central_point = Point_3(0, 0, 10);
    const Patch high(model);
    const Point_2 p =
        CGAL::centroid(low.domain().vertex(0), low.domain().vertex(1), low.domain().vertex(5));
    std::vector<MP::Jet_2<double, 0>> lambda(6), weights(low.basis().size());
    low.coordinates().evaluate<0>(p, Location::interior(), lambda.data());
    low.basis().evaluate(low.domain(), lambda.data(), weights.data());
    const double w = weights[low.basis().central_index()].value();
    CHECK(std::abs(w) > 1e-4);
    CHECK(distance(high(p), low(p) + Vector_3(0, 0, 10 * w)) < 1e-12);
  }
}

TEST_CASE("Coordinates on a domain that does not fit the loop are refused") {
  const Loop loop = lifted_loop(l_shape(), bowl);
  const MP::Mean_value_coordinates_2<Kernel> square{Domain({{0, 0}, {1, 0}, {1, 1}, {0, 1}})};
  using Mean_value_patch = MP::Concave_bezier_patch_3<Kernel, MP::Mean_value_coordinates_2<Kernel>>;
  CHECK_THROWS_WITH(Mean_value_patch(loop, square), Catch::Matchers::Contains("6 sides"));
  CHECK_THROWS_AS(Patch(loop)(Point_2(-1, -1)), MP::Outside_domain_error);
}

TEST_CASE("Any class with the members of coordinates can carry a patch") {
  Random random(19);
  const auto net = random_net<Kernel>(random, 3);
  const MP::Concave_bezier_patch_3<Kernel, Bilinear> patch(
      tensor_product_loop<Kernel>(net), Bilinear(Domain({{0, 0}, {1, 0}, {1, 1}, {0, 1}})));
  for (int k = 0; k < 20; ++k) {
    const double u = random.in(0, 1), v = random.in(0, 1);
    CHECK(distance(patch({u, v}), tensor_product_point(net, u, v)) < 1e-13);
  }
}
