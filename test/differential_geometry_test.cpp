// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"

#include <CGAL/Multisided_patches/coordinates/Mean_value_coordinates_2.h>
#include <CGAL/Multisided_patches/coordinates/Wachspress_coordinates_2.h>
#include <CGAL/Multisided_patches/patches/Concave_bezier_patch_3.h>
#include <CGAL/Multisided_patches/patches/Surface_geometry_3.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

using namespace fixtures;
using Jet = MP::Jet_2<double, 2>;
using Surface_jet = std::array<Jet, 3>;
using Geometry = MP::Surface_geometry_3<Kernel>;
using Curvature = MP::Surface_curvature_3<Kernel>;
using Vector_2 = Kernel::Vector_2;
using Location = Domain::Location;
using Net = std::vector<std::vector<Point_3>>;
using Square_patch = MP::Concave_bezier_patch_3<Kernel, MP::Wachspress_coordinates_2<Kernel>>;

namespace {

constexpr double pi = MP::internal::pi;

Domain unit_square() {
  return Domain({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
}

// On a square with Wachspress coordinates the patch is the tensor product surface.
Square_patch square_patch(const Net& net) {
  return Square_patch(Square_patch::Model(tensor_product_loop<Kernel>(net)),
                      MP::Wachspress_coordinates_2<Kernel>(unit_square()));
}

// The bicubic net of (x, y, a x² + b x y + c y²), where x = u + x0 and y = v + y0.
Net quadric(double a, double b, double c, double x0 = 0, double y0 = 0) {
  Net net(4);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const double u = i / 3., v = j / 3., uu = i * (i - 1) / 6., vv = j * (j - 1) / 6.;
      const double z = a * (uu + 2 * x0 * u + x0 * x0) + b * (u + x0) * (v + y0) +
                       c * (vv + 2 * y0 * v + y0 * y0);
      net[static_cast<std::size_t>(i)].emplace_back(u + x0, v + y0, z);
    }
  return net;
}

Net random_net(Random& random, std::size_t degree) {
  Net net(degree + 1);
  for (std::size_t a = 0; a <= degree; ++a)
    for (std::size_t b = 0; b <= degree; ++b) {
      const double x = static_cast<double>(a) + random.in(-0.2, 0.2);
      const double y = static_cast<double>(b) + random.in(-0.2, 0.2);
      net[a].emplace_back(x, y, random.in(-1, 1));
    }
  return net;
}

// The derivatives of the tensor product surface, by Bernstein polynomials of jets.
std::array<Vector_3, 6> tensor_product_derivatives(const Net& net, double u, double v) {
  const std::size_t d = net.size() - 1;
  std::vector<Jet> bu(d + 1), bv(d + 1);
  for (std::size_t a = 0; a <= d; ++a) {
    const auto polynomial = [&](const Jet& t) {
      Jet b(1);
      for (std::size_t k = 0; k < d; ++k)
        b *= k < a ? t * (static_cast<double>(d - k) / static_cast<double>(k + 1)) : 1.0 - t;
      return b;
    };
    bu[a] = polynomial(Jet::u_variable(u));
    bv[a] = polynomial(Jet::v_variable(v));
  }
  std::array<Vector_3, 6> sums;
  sums.fill(Vector_3(0, 0, 0));
  for (std::size_t a = 0; a <= d; ++a)
    for (std::size_t b = 0; b <= d; ++b) {
      const Jet w = bu[a] * bv[b];
      for (std::size_t k = 0; k < 6; ++k)
        sums[k] = sums[k] + w[k] * (net[a][b] - CGAL::ORIGIN);
    }
  return sums;
}

double length(const Vector_3& v) {
  return std::sqrt(v.squared_length());
}

double angle(const Vector_3& a, const Vector_3& b) {
  return MP::internal::angle_between(MP::internal::to_vec3(a), MP::internal::to_vec3(b));
}

// The angle between two directions that are determined up to their sign.
double angle_of_lines(const Vector_3& a, const Vector_3& b) {
  return (std::min)(angle(a, b), angle(a, -b));
}

// A surface by a formula: the least that a class needs for `surface_geometry()`.
template <typename Function>
class Formula_patch {
public:
  using Geom_traits = Kernel;
  using Point_2 = Kernel::Point_2;
  using Location = Domain::Location;

  Formula_patch(const Domain& domain, const Function& f) : domain_(domain), f_(f) {}
  const Domain& domain() const { return domain_; }
  template <int Order>
  Surface_jet evaluate(const Point_2& uv, const Location&) const {
    return f_(Jet::u_variable(uv.x()), Jet::v_variable(uv.y()));
  }
  Vector_3 normal(const Point_2&, const Location&) const { return Vector_3(0, 0, 0); }

private:
  Domain domain_;
  Function f_;
};

Jet sine(const Jet& a) {
  return a.composed(std::sin(a.value()), std::cos(a.value()), -std::sin(a.value()));
}
Jet cosine(const Jet& a) {
  return a.composed(std::cos(a.value()), -std::sin(a.value()), -std::cos(a.value()));
}

// What holds for every surface, to some rounding errors of the larger curvature.
void check_identities(const Geometry& g, Random& random) {
  REQUIRE(g.curvature);
  const Curvature& c = *g.curvature;
  const double k1 = c.max_curvature(), k2 = c.min_curvature();
  const double size = (std::max)(std::abs(k1), std::abs(k2)), error = 1e-12 * size;
  CHECK(k1 >= k2);
  CHECK(std::abs(c.gaussian() - k1 * k2) <= error * size);
  CHECK(std::abs(c.mean() - (k1 + k2) / 2) <= error);
  const Vector_3 e1 = c.max_direction(), e2 = c.min_direction();
  CHECK(length(e1) == Approx(1).epsilon(1e-14));
  CHECK(length(CGAL::cross_product(g.normal, e1) - e2) < 1e-14);
  CHECK(std::abs(e1 * g.normal) < 1e-14);
  const Vector_2 p1 = c.max_parameter_direction(), p2 = c.min_parameter_direction();
  for (const auto& [plane, space] : {std::pair(p1, e1), std::pair(p2, e2)}) {
    CHECK(plane.squared_length() == Approx(1).epsilon(1e-14));
    CHECK(angle(plane.x() * g.derivative_u + plane.y() * g.derivative_v, space) < 1e-12);
  }
  // Euler's formula
  for (int k = 0; k < 5; ++k) {
    const double t = random.in(0, 2 * pi), scale = random.in(0.1, 10);
    const Vector_3 direction = scale * (std::cos(t) * e1 + std::sin(t) * e2);
    const double expected = k1 * std::cos(t) * std::cos(t) + k2 * std::sin(t) * std::sin(t);
    CHECK(std::abs(c.normal_curvature(direction) - expected) <= error);
    CHECK(c.normal_curvature(direction + g.normal) == Approx(expected).margin(error));
    const Vector_2 d(random.in(-1, 1), random.in(-1, 1));
    CHECK(std::abs(c.normal_curvature(d) -
                   c.normal_curvature(d.x() * g.derivative_u + d.y() * g.derivative_v)) <= error);
  }
}

} // namespace

TEST_CASE("On a square the differential geometry is that of the tensor product surface") {
  const unsigned seed = 20260301;
  CAPTURE(seed);
  Random random(seed);
  for (const std::size_t degree : {3, 5}) {
    const Net net = random_net(random, degree);
    const Square_patch patch = square_patch(net);
    for (int k = 0; k < 50; ++k) {
      const Point_2 uv(random.in(0.01, 0.99), random.in(0.01, 0.99));
      const Geometry g = MP::surface_geometry(patch, uv);
      const auto s = tensor_product_derivatives(net, uv.x(), uv.y());
      CHECK(length(g.point - CGAL::ORIGIN - s[0]) < 1e-13 * 10);
      CHECK(length(g.derivative_u - s[1]) < 1e-11);
      CHECK(length(g.derivative_v - s[2]) < 1e-11);
      CHECK(length(g.derivative_uu - s[3]) < 1e-9);
      CHECK(length(g.derivative_uv - s[4]) < 1e-9);
      CHECK(length(g.derivative_vv - s[5]) < 1e-9);
      CHECK(length(g.normal - patch.normal(uv)) < 1e-14);

      const auto& [E, F, G] = g.first_form;
      const auto& [L, M, N] = g.second_form;
      const Vector_3 normal = CGAL::cross_product(s[1], s[2]) / std::sqrt(E * G - F * F);
      CHECK(E == Approx(s[1] * s[1]));
      CHECK(F == Approx(s[1] * s[2]).margin(1e-9));
      CHECK(G == Approx(s[2] * s[2]));
      CHECK(L == Approx(s[3] * normal).margin(1e-8));
      CHECK(M == Approx(s[4] * normal).margin(1e-8));
      CHECK(N == Approx(s[5] * normal).margin(1e-8));
      // The textbook's formulas, which cancel
      const double area = E * G - F * F;
      check_identities(g, random);
      CHECK(g.curvature->gaussian() == Approx((L * N - M * M) / area).margin(1e-9));
      CHECK(g.curvature->mean() == Approx((E * N - 2 * F * M + G * L) / 2 / area).margin(1e-9));
    }
  }
}

TEST_CASE("A saddle, a bowl and a trough have the curvatures that their formulas say") {
  Random random(2);
  const Square_patch saddle = square_patch(quadric(0, 1, 0, -0.5, -0.5));
  const Square_patch bowl = square_patch(quadric(0.7, 0, 0.7, -0.5, -0.5));
  const Square_patch trough = square_patch(quadric(0.7, 0, 0));
  for (int k = 0; k < 20; ++k) {
    const Point_2 uv(random.in(0.01, 0.99), random.in(0.01, 0.99));
    const double x = uv.x() - 0.5, y = uv.y() - 0.5, w = 1 + x * x + y * y;
    const Geometry on_saddle = MP::surface_geometry(saddle, uv);
    check_identities(on_saddle, random);
    CHECK(on_saddle.curvature->gaussian() == Approx(-1 / (w * w)).epsilon(1e-11));
    CHECK(on_saddle.curvature->mean() == Approx(-x * y / std::pow(w, 1.5)).margin(1e-12));

    const double slope = 1 + 1.4 * 1.4 * (x * x + y * y);
    const Geometry on_bowl = MP::surface_geometry(bowl, uv);
    check_identities(on_bowl, random);
    // A surface of revolution: parallels bend more than meridians.
    CHECK(on_bowl.curvature->max_curvature() == Approx(1.4 / std::sqrt(slope)).epsilon(1e-11));
    CHECK(on_bowl.curvature->min_curvature() == Approx(1.4 / std::pow(slope, 1.5)).epsilon(1e-11));
    CHECK(angle_of_lines(on_bowl.curvature->max_direction(), Vector_3(-y, x, 0)) < 1e-9);

    const double steep = 1 + std::pow(1.4 * uv.x(), 2);
    const Geometry on_trough = MP::surface_geometry(trough, uv);
    check_identities(on_trough, random);
    CHECK(on_trough.curvature->max_curvature() ==
          Approx(1.4 / std::pow(steep, 1.5)).epsilon(1e-11));
    CHECK(std::abs(on_trough.curvature->min_curvature()) < 1e-13);
    CHECK(angle_of_lines(on_trough.curvature->min_direction(), Vector_3(0, 1, 0)) < 1e-12);
  }
  const Geometry umbilic = MP::surface_geometry(bowl, Point_2(0.5, 0.5));
  check_identities(umbilic, random);
  CHECK(umbilic.curvature->max_curvature() == Approx(1.4).epsilon(1e-12));
  CHECK(umbilic.curvature->min_curvature() == Approx(1.4).epsilon(1e-12));
}

TEST_CASE("A sphere and a torus have the curvatures of their circles") {
  Random random(3);
  const double r = 0.25, R = 2;
  const Formula_patch sphere(unit_square(), [&](const Jet& u, const Jet& v) {
    return Surface_jet{r * cosine(u) * cosine(v), r * sine(u) * cosine(v), r * sine(v)};
  });
  const Formula_patch torus(unit_square(), [&](const Jet& u, const Jet& v) {
    const Jet radius = R + r * cosine(v);
    return Surface_jet{radius * cosine(u), radius * sine(u), r * sine(v)};
  });
  for (int k = 0; k < 20; ++k) {
    const Point_2 uv(random.in(0.01, 0.99), random.in(0.01, 0.99));
    const Geometry on_sphere = MP::surface_geometry(sphere, uv);
    check_identities(on_sphere, random);
    CHECK(length(on_sphere.normal - (on_sphere.point - CGAL::ORIGIN) / r) < 1e-14);
    CHECK(on_sphere.curvature->max_curvature() == Approx(-1 / r).epsilon(1e-13));
    CHECK(on_sphere.curvature->min_curvature() == Approx(-1 / r).epsilon(1e-13));
    CHECK(on_sphere.curvature->gaussian() == Approx(1 / (r * r)).epsilon(1e-13));

    const double cos_v = std::cos(uv.y());
    const Geometry on_torus = MP::surface_geometry(torus, uv);
    check_identities(on_torus, random);
    CHECK(on_torus.curvature->max_curvature() == Approx(-cos_v / (R + r * cos_v)).epsilon(1e-12));
    CHECK(on_torus.curvature->min_curvature() == Approx(-1 / r).epsilon(1e-13));
    CHECK(angle_of_lines(on_torus.curvature->max_direction(), on_torus.derivative_u) < 1e-13);
    CHECK(std::abs(on_torus.curvature->min_parameter_direction().x()) < 1e-14);
  }
}

TEST_CASE("A small curvature keeps its digits next to a large one") {
  const Formula_patch surface(unit_square(), [](const Jet& u, const Jet& v) {
    const Jet x = u - 0.5, y = v - 0.5;
    return Surface_jet{x, y, 5e7 * x * x + 5e-9 * y * y};
  });
  const Geometry g = MP::surface_geometry(surface, Point_2(0.5, 0.5));
  REQUIRE(g.curvature);
  CHECK(g.curvature->max_curvature() == Approx(1e8).epsilon(1e-15));
  CHECK(g.curvature->min_curvature() == Approx(1e-8).epsilon(1e-15));

  // (1 q; q r) with 1 r - q² = -2^-54, which is lost where q² is rounded
  const double tiny = std::pow(2, -27), q = 1 + tiny, r = 1 + 2 * tiny;
  const Formula_patch oblique(unit_square(), [&](const Jet& u, const Jet& v) {
    const Jet x = u - 0.5, y = v - 0.5;
    return Surface_jet{x, y, 0.5 * x * x + q * x * y + (r / 2) * y * y};
  });
  const Geometry h = MP::surface_geometry(oblique, Point_2(0.5, 0.5));
  REQUIRE(h.curvature);
  CHECK(h.curvature->gaussian() == -tiny * tiny);
  CHECK(h.curvature->min_curvature() == Approx(-tiny * tiny / (1 + r)).epsilon(1e-14));
}

TEST_CASE("Curvatures do not depend on where a surface is, and shrink as it grows") {
  Random random(4);
  const Net net = random_net(random, 3);
  const Square_patch patch = square_patch(net);
  const Vector_3 a(0.6, 0.8, 0), b(-0.48, 0.36, 0.8), c = CGAL::cross_product(a, b);
  for (const double scale : {1e-100, 1e-6, 1.0, 1e6, 1e100}) {
    const Vector_3 shift = scale * Vector_3(3, -2, 1);
    const CGAL::Aff_transformation_3<Kernel> map(a.x(), b.x(), c.x(), shift.x() / scale, a.y(),
                                                 b.y(), c.y(), shift.y() / scale, a.z(), b.z(),
                                                 c.z(), shift.z() / scale, 1 / scale);
    Net moved_net = net;
    for (auto& row : moved_net)
      for (Point_3& p : row)
        p = map(p);
    const Square_patch moved = square_patch(moved_net);
    for (int k = 0; k < 10; ++k) {
      const Point_2 uv(random.in(0.01, 0.99), random.in(0.01, 0.99));
      const Geometry g = MP::surface_geometry(patch, uv), h = MP::surface_geometry(moved, uv);
      check_identities(h, random);
      const double error = 1e-9;
      CHECK(h.curvature->max_curvature() * scale ==
            Approx(g.curvature->max_curvature()).margin(error));
      CHECK(h.curvature->min_curvature() * scale ==
            Approx(g.curvature->min_curvature()).margin(error));
      const Vector_3 normal = g.normal.x() * a + g.normal.y() * b + g.normal.z() * c;
      CHECK(length(h.normal - normal) < 1e-12);
    }
  }
}

TEST_CASE("Turned over, a surface has the opposite curvatures") {
  Random random(5);
  const Loop loop = tensor_product_loop<Kernel>(random_net(random, 3));
  std::vector<Ribbon> ribbons;
  for (const Ribbon& r : loop.ribbons())
    ribbons.insert(ribbons.begin(), r.reversed());
  const MP::Wachspress_coordinates_2<Kernel> coordinates(unit_square());
  const Square_patch front(loop, coordinates), back(Loop(ribbons), coordinates);
  for (int k = 0; k < 10; ++k) {
    const double u = random.in(0.01, 0.99), v = random.in(0.01, 0.99);
    // Side 0 of the back is side 3 of the front, run the other way.
    const Geometry g = MP::surface_geometry(front, Point_2(u, v));
    const Geometry h = MP::surface_geometry(back, Point_2(v, u));
    CHECK(length(g.point - h.point) < 1e-13);
    CHECK(length(g.normal + h.normal) < 1e-12);
    CHECK(h.curvature->max_curvature() == Approx(-g.curvature->min_curvature()).margin(1e-10));
    CHECK(h.curvature->gaussian() == Approx(g.curvature->gaussian()).margin(1e-10));
  }
}

TEST_CASE("Where a surface has no tangent plane it has no curvatures") {
  // The pole of a sphere in geographic coordinates
  const Formula_patch pole(unit_square(), [](const Jet& u, const Jet& v) {
    const Jet latitude = v + (pi / 2 - 0.5);
    return Surface_jet{cosine(u) * cosine(latitude), sine(u) * cosine(latitude), sine(latitude)};
  });
  CHECK(MP::surface_geometry(pole, Point_2(0.5, 0.25)).curvature);
  const Geometry at_pole = MP::surface_geometry(pole, Point_2(0.5, 0.5));
  CHECK_FALSE(at_pole.curvature);
  CHECK(at_pole.normal == Vector_3(0, 0, 0));
  CHECK(at_pole.first_form.E < 1e-30);
  CHECK(at_pole.first_form.G == Approx(1));
  // Derivatives along one line
  const Formula_patch line(unit_square(), [](const Jet& u, const Jet& v) {
    return Surface_jet{u + v, 2.0 * u + 2.0 * v, u * v};
  });
  CHECK_FALSE(MP::surface_geometry(line, Point_2(0.5, 0.5)).curvature);
  const Formula_patch point(unit_square(), [](const Jet&, const Jet&) { return Surface_jet{}; });
  CHECK_FALSE(MP::surface_geometry(point, Point_2(0.5, 0.5)).curvature);
}

TEST_CASE("On the boundary the geometry is that of the ribbons and the limit from inside") {
  const Loop loop =
      lifted_loop(l_shape(), [](double x, double y) { return x * x / 4 - x * y / 5; });
  const MP::Concave_bezier_patch_3<Kernel, MP::Mean_value_coordinates_2<Kernel>> patch(loop);
  const Domain& domain = patch.domain();
  for (std::size_t i = 0; i < domain.size(); ++i) {
    const Geometry at_corner = MP::surface_geometry(patch, domain.vertex(i));
    CHECK(at_corner.normal == loop.corner_normal(i));
    // These coordinates have no derivatives at vertices.
    CHECK_FALSE(at_corner.curvature);
    for (const double s : {0.2, 0.5, 0.7}) {
      const Point_2 uv = domain.point_on_side(i, s);
      const Geometry on_side = MP::surface_geometry(patch, uv, Location::on_side(i, s));
      REQUIRE(on_side.curvature);
      CHECK(length(on_side.normal - patch.normal_on_side(i, s)) < 1e-13);
      const Vector_2 inwards = domain.side(i).to_vector().perpendicular(CGAL::COUNTERCLOCKWISE);
      const Geometry inside = MP::surface_geometry(patch, uv + 1e-6 * inwards);
      REQUIRE(inside.curvature);
      CHECK(length(inside.normal - on_side.normal) < 1e-4);
      CHECK(inside.curvature->max_curvature() ==
            Approx(on_side.curvature->max_curvature()).margin(1e-3));
      CHECK(inside.curvature->min_curvature() ==
            Approx(on_side.curvature->min_curvature()).margin(1e-3));
    }
  }
  CHECK_THROWS_AS(MP::surface_geometry(patch, Point_2(50, 50)), MP::Outside_domain_error);
}

TEST_CASE("Where the coordinates are smooth at corners, so is the geometry") {
  Random random(6);
  const Net net = random_net(random, 3);
  const Square_patch patch = square_patch(net);
  for (std::size_t i = 0; i < 4; ++i) {
    const Point_2 corner = patch.domain().vertex(i);
    const Geometry at = MP::surface_geometry(patch, corner);
    const auto s = tensor_product_derivatives(net, corner.x(), corner.y());
    CHECK(angle(at.normal, CGAL::cross_product(s[1], s[2])) < 1e-12);
    CHECK(length(at.derivative_u - s[1]) < 1e-11);
    CHECK(length(at.derivative_v - s[2]) < 1e-11);
    CHECK(length(at.derivative_uu - s[3]) < 1e-9);
    CHECK(length(at.derivative_uv - s[4]) < 1e-9);
    CHECK(length(at.derivative_vv - s[5]) < 1e-9);
  }
}

TEST_CASE("Exact patches have differential geometry in double") {
  using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  const MP::Wachspress_coordinates_2<Exact> coordinates{
      MP::Polygonal_domain_2<Exact>(std::vector<Exact::Point_2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}})};
  const Net quadric_net = quadric(0.5, 0.25, -1);
  std::vector<std::vector<Exact::Point_3>> net(4);
  for (std::size_t a = 0; a < 4; ++a)
    for (const Point_3& p : quadric_net[a])
      net[a].emplace_back(p.x(), p.y(), p.z());
  const MP::Concave_bezier_patch_3<Exact, MP::Wachspress_coordinates_2<Exact>> exact(
      MP::Concave_bezier_model_3<Exact>(tensor_product_loop<Exact>(net)), coordinates);
  const auto g = MP::surface_geometry(exact, Exact::Point_2(0.25, 0.75));
  const auto h = MP::surface_geometry(square_patch(quadric_net), Point_2(0.25, 0.75));
  REQUIRE(g.curvature);
  CHECK(g.curvature->max_curvature() == Approx(h.curvature->max_curvature()).epsilon(1e-12));
  CHECK(g.curvature->min_curvature() == Approx(h.curvature->min_curvature()).epsilon(1e-12));
}
