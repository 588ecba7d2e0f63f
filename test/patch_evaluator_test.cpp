// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "control_net_fixtures.h"

#include <CGAL/Multisided_patches/IO/CGB.h>
#include <CGAL/Multisided_patches/patches/Patch_evaluator.h>

#include <CGAL/Aff_transformation_3.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace fixtures;

namespace {

using Points = std::vector<Point_3>;

Vector_3 random_vector(Random& random, double size) {
  return Vector_3(random.in(-size, size), random.in(-size, size), random.in(-size, size));
}

template <typename Evaluator>
Points control_points(const Evaluator& evaluator) {
  Points points;
  for (std::size_t c = 0; c < evaluator.number_of_control_points(); ++c)
    points.push_back(evaluator.control_point(c));
  return points;
}

double distance(const Point_3& a, const Point_3& b) {
  return std::sqrt(CGAL::squared_distance(a, b));
}

// The largest distance of corresponding points.
double distance(const Points& a, const Points& b) {
  REQUIRE(a.size() == b.size());
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    largest = (std::max)(largest, distance(a[k], b[k]));
  return largest;
}

// Whether all elements are equal, to the last bit. A message would be very long.
template <typename T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  return a == b;
}

double length(const Vector_3& v) {
  return std::sqrt(v.squared_length());
}

// The distance of a sample from the nearest corner on which weights depend. (At a corner they have
// no large derivatives.)
double distance_to_corner(const Domain& domain, const Point_2& p,
                          const Domain::Location& location) {
  double nearest = 1;
  for (std::size_t i = 0; i < domain.size(); ++i)
    if (location.kind != Domain::Location::Kind::vertex)
      nearest = (std::min)(nearest, std::sqrt(CGAL::squared_distance(p, domain.vertex(i))));
  return nearest;
}

// At a corner derivatives along the sides are those of the boundary curves.
template <typename Evaluator, typename Patch>
void check_tangents(const Evaluator& evaluator, const Patch& patch, std::size_t k, std::size_t i,
                    double tolerance) {
  const auto& domain = patch.domain();
  const auto along = [&](const Kernel::Vector_2& d) {
    return d.x() * evaluator.derivative(k, 0) + d.y() * evaluator.derivative(k, 1);
  };
  const Vector_3 out = patch.loop()[i].boundary_derivative(0),
                 in = patch.loop()[domain.prev(i)].boundary_derivative(1);
  CHECK(length(along(domain.vertex(domain.next(i)) - domain.vertex(i)) - out) <
        100 * tolerance * (1 + length(out)));
  CHECK(length(along(domain.vertex(i) - domain.vertex(domain.prev(i))) - in) <
        100 * tolerance * (1 + length(in)));
}

// Compares all samples with a patch that has the same control points.
template <typename Evaluator, typename Patch>
void check_samples(const Evaluator& evaluator, const Patch& patch, const Samples<Kernel>& samples,
                   double tolerance) {
  const Points positions = evaluator.positions();
  const std::vector<Vector_3> normals = evaluator.normals();
  REQUIRE(positions.size() == samples.points.size());
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const Point_2& uv = samples.points[k];
    const Domain::Location& location = samples.locations[k];
    CHECK(positions[k] == evaluator.position(k));
    CHECK(normals[k] == evaluator.normal(k));
    CHECK(distance(positions[k], patch.point(uv, location)) < tolerance);
    if (location.kind == Domain::Location::Kind::vertex) {
      check_tangents(evaluator, patch, k, location.index, tolerance);
      continue;
    }
    const auto jets = patch.template evaluate<1>(uv, location);
    const double r = distance_to_corner(patch.domain(), uv, location);
    for (std::size_t variable = 0; variable < 2; ++variable) {
      const std::size_t e = 1 + variable;
      const Vector_3 expected(jets[0][e], jets[1][e], jets[2][e]);
      CHECK(length(evaluator.derivative(k, variable) - expected) <
            tolerance * (100 + 10 / r) * (1 + length(expected)));
    }
    const Vector_3 u = evaluator.derivative(k, 0), v = evaluator.derivative(k, 1),
                   cross = CGAL::cross_product(u, v);
    if (length(cross) > 1e-3 * length(u) * length(v))
      CHECK(length(normals[k] - cross / length(cross)) < 1e-12);
  }
}

// A concave patch whose ribbons are given as the basis counts their points.
Concave_patch with_control_points(const Concave_patch& patch, const Points& points) {
  std::vector<Ribbon> ribbons;
  auto p = points.begin();
  for (const Ribbon& ribbon : patch.loop().ribbons()) {
    const auto count = static_cast<std::ptrdiff_t>(ribbon.control_points().size());
    ribbons.emplace_back(ribbon.degree(), ribbon.layers(), Points(p, p + count));
    p += count;
  }
  Concave_patch::Model model{Loop(std::move(ribbons))};
  model.central_weight = patch.basis().central_weight();
  model.central_point = points.back();
  return Concave_patch(model, patch.coordinates());
}

// Moves the whole net at random, such that ribbons still meet.
Points moved(const Concave_patch& patch, Points points, Random& random) {
  const std::size_t n = patch.loop().size();
  for (Point_3& p : points)
    p = p + random_vector(random, 0.2);
  for (std::size_t i = 0; i < n; ++i)
    points[patch.basis().index(i, patch.loop()[i].degree(), 0)] =
        points[patch.basis().index((i + 1) % n, 0, 0)];
  return points;
}

} // namespace

TEST_CASE("Samples are the points of a patch that is made from the changed control points") {
  const unsigned seed = 31;
  CAPTURE(seed);
  Random random(seed);
  for (const auto central : {MP::Central_weight::none, MP::Central_weight::weight_deficiency,
                             MP::Central_weight::full_product}) {
    CAPTURE(to_string(central));
    const Concave_patch patch = concave_patch(random, 6, central);
    const auto samples = random_samples(patch.domain(), random, 150);
    MP::Patch_evaluator<Concave_patch> evaluator(patch, samples.points, samples.locations);
    CHECK(evaluator.size() == 150);
    CHECK(evaluator.number_of_control_points() == patch.basis().size());
    check_samples(evaluator, patch, samples, 1e-14);
    const Points points = moved(patch, control_points(evaluator), random);
    evaluator.set_control_points(points);
    CHECK(control_points(evaluator) == points);
    check_samples(evaluator, with_control_points(patch, points), samples, 1e-14);
  }
}

TEST_CASE("Generalized Bezier patches and S-patches have samples, too") {
  const unsigned seed = 32;
  CAPTURE(seed);
  Random random(seed);
  const Generalized_patch generalized(generalized_net<Kernel>(random, 5, 5));
  const auto samples = random_samples(generalized.domain(), random, 100);
  MP::Patch_evaluator<Generalized_patch> evaluator(generalized, samples.points, samples.locations);
  const auto net = generalized_net<Kernel>(random, 5, 5);
  evaluator.set_control_points(net.control_points());
  check_samples(evaluator, Generalized_patch(net), samples, 1e-14);

  const S_patch s_patch(s_net(random, 5, 4));
  MP::Patch_evaluator<S_patch> s_evaluator(s_patch, samples.points, samples.locations);
  const auto other = s_net(random, 5, 4);
  s_evaluator.set_control_points(other.control_points());
  check_samples(s_evaluator, S_patch(other), samples, 1e-14);
}

TEST_CASE("Single moves add up to what all control points give at once") {
  const unsigned seed = 33;
  CAPTURE(seed);
  Random random(seed);
  const Concave_patch patch = concave_patch(random, 7, MP::Central_weight::weight_deficiency);
  const auto samples = random_samples(patch.domain(), random, 64 * 20);
  using Evaluator = MP::Patch_evaluator<Concave_patch>;
  Evaluator evaluator(patch, samples.points, samples.locations), full(evaluator);
  const Points start = control_points(evaluator);
  for (const std::size_t moves : {15, 150}) {
    for (std::size_t m = 0; m < moves; ++m) {
      const std::size_t c = random.integer(0, start.size() - 1);
      const Point_3 target = start[c] + random_vector(random, 0.3);
      evaluator.set_control_point(c, target);
      CHECK(evaluator.control_point(c) == target);
    }
    full.set_control_points(control_points(evaluator));
    CHECK(distance(evaluator.positions(), full.positions()) < 1e-13);
    CHECK(distance(evaluator.positions(), full.positions()) > 0); // not all are computed anew
  }
  // A detour far away leaves no trace.
  evaluator.set_control_point(3, Point_3(1e12, 1e12, -1e12));
  evaluator.set_control_point(3, full.control_point(3));
  CHECK(same(evaluator.positions(), full.positions()));
}

TEST_CASE("A ribbon moves like its control points one by one") {
  const unsigned seed = 34;
  CAPTURE(seed);
  Random random(seed);
  const Concave_patch patch = concave_patch(random, 7, MP::Central_weight::none);
  const auto samples = random_samples(patch.domain(), random, 64 * 12);
  using Evaluator = MP::Patch_evaluator<Concave_patch>;
  Evaluator at_once(patch, samples.points, samples.locations), one_by_one(at_once), full(at_once);
  std::vector<std::pair<std::size_t, Point_3>> moves;
  const Ribbon& ribbon = patch.loop()[2];
  for (std::size_t k = ribbon.layers(); k-- > 0;)
    for (std::size_t j = 0; j <= ribbon.degree(); ++j) {
      const std::size_t c = patch.basis().index(2, j, k);
      moves.emplace_back(c, at_once.control_point(c) + random_vector(random, 0.2));
    }
  at_once.move_control_points(moves);
  for (const auto& [c, point] : moves)
    one_by_one.set_control_point(c, point);
  full.set_control_points(control_points(at_once));
  CHECK(control_points(at_once) == control_points(one_by_one));
  CHECK(distance(at_once.positions(), full.positions()) < 1e-14);
  CHECK(distance(one_by_one.positions(), full.positions()) < 1e-14);
}

TEST_CASE("Samples are moved by an affine map as control points are") {
  const unsigned seed = 35;
  CAPTURE(seed);
  Random random(seed);
  const Concave_patch patch = concave_patch(random, 5, MP::Central_weight::adjacent_products);
  const auto samples = random_samples(patch.domain(), random, 100);
  const auto entry = [&] { return random.in(-1, 1); };
  const CGAL::Aff_transformation_3<Kernel> map(entry(), entry(), entry(), 100 * entry(), //
                                               entry(), entry(), entry(), 100 * entry(), //
                                               entry(), entry(), entry(), 100 * entry());
  MP::Patch_evaluator<Concave_patch, 0> evaluator(patch, samples.points, samples.locations);
  Points expected = evaluator.positions(), net = control_points(evaluator);
  for (Point_3& p : expected)
    p = map(p);
  for (Point_3& p : net)
    p = map(p);
  evaluator.set_control_points(net);
  CHECK(distance(evaluator.positions(), expected) < 1e-12);
}

TEST_CASE(
    "Single precision gives six digits of the size of the net, however large it is, and where") {
  const unsigned seed = 36;
  CAPTURE(seed);
  Random random(seed);
  const Concave_patch patch = concave_patch(random, 6, MP::Central_weight::none);
  const auto samples = random_samples(patch.domain(), random, 500);
  MP::Patch_evaluator<Concave_patch> exact(patch, samples.points, samples.locations);
  MP::Patch_evaluator<Concave_patch, 1, float> rough(patch, samples.points, samples.locations);
  CHECK(rough.number_of_stored_weights() <= exact.number_of_stored_weights());
  CHECK(rough.number_of_bytes() < exact.number_of_bytes());
  CHECK(distance(rough.positions(), exact.positions()) < 1e-6);
  CHECK(distance(rough.positions(), exact.positions()) > 1e-12);
  const Points net = control_points(exact);
  for (const double scale : {1.0, 1e-60, 1e60, 1e-100, 1e100})
    for (const double offset : {0.0, 1e5}) {
      CAPTURE(scale, offset);
      Points scaled;
      for (const Point_3& p : net)
        scaled.push_back(CGAL::ORIGIN + scale * ((p - CGAL::ORIGIN) + offset * Vector_3(1, -1, 1)));
      exact.set_control_points(scaled);
      rough.set_control_points(scaled);
      CHECK(distance(rough.positions(), exact.positions()) < 1e-6 * scale);
      for (std::size_t k = 0; k < rough.size(); ++k) {
        const double r =
            distance_to_corner(patch.domain(), samples.points[k], samples.locations[k]);
        CHECK(length(rough.derivative(k, 0) - exact.derivative(k, 0)) <
              1e-6 * scale * (100 + 10 / r));
      }
    }
}

TEST_CASE("Single precision does not lose digits while control points move") {
  const unsigned seed = 40;
  CAPTURE(seed);
  Random random(seed);
  const Concave_patch patch = concave_patch(random, 6, MP::Central_weight::none);
  const auto samples = random_samples(patch.domain(), random, 500);
  MP::Patch_evaluator<Concave_patch> exact(patch, samples.points, samples.locations);
  MP::Patch_evaluator<Concave_patch, 1, float> rough(patch, samples.points, samples.locations);
  for (int m = 0; m < 127; ++m) {
    const std::size_t c = random.integer(0, exact.number_of_control_points() - 1);
    const Point_3 target = exact.control_point(c) + random_vector(random, 0.1);
    exact.set_control_point(c, target);
    rough.set_control_point(c, target);
  }
  CHECK(distance(rough.positions(), exact.positions()) < 1e-6);
}

TEST_CASE("At corners, reflex ones too, normals are those of the patch") {
  for (const char* name : {"u_vent", "plus_hub", "star_knob", "l_bracket", "spiral_volute"}) {
    CAPTURE(name);
    const Concave_patch patch(
        MP::IO::read_CGB<Kernel>(std::string(MODELS_DIR "/") + name + ".cgb"));
    Samples<Kernel> corners;
    for (std::size_t i = 0; i < patch.domain().size(); ++i)
      corners.add(patch.domain(), patch.domain().vertex(i));
    MP::Patch_evaluator<Concave_patch> evaluator(patch, corners.points, corners.locations);
    for (std::size_t i = 0; i < evaluator.size(); ++i) {
      CAPTURE(i);
      const Vector_3 normal = patch.normal(corners.points[i], corners.locations[i]);
      CHECK(length(evaluator.normal(i) - normal) < 1e-9);
      CHECK(distance(evaluator.position(i), patch.point(corners.points[i], corners.locations[i])) <
            1e-12);
    }
  }
}

TEST_CASE("Samples do not depend on the number of threads") {
  const unsigned seed = 37;
  CAPTURE(seed);
  Random random(seed);
  const Concave_patch patch = concave_patch(random, 6, MP::Central_weight::none);
  const auto samples = random_samples(patch.domain(), random, 64 * 12);
  using Evaluator = MP::Patch_evaluator<Concave_patch>;
  Evaluator one(patch, samples.points, samples.locations, CGAL::Sequential_tag()),
      many(patch, samples.points, samples.locations, CGAL::Parallel_if_available_tag());
  CHECK(same(one.positions(), many.positions()));
  for (int m = 0; m < 20; ++m) {
    const std::size_t c = random.integer(0, one.number_of_control_points() - 1);
    const Point_3 target = one.control_point(c) + random_vector(random, 0.1);
    one.set_control_point<CGAL::Sequential_tag>(c, target);
    many.set_control_point(c, target);
  }
  CHECK(same(one.positions(), many.positions()));
  CHECK(same(one.normals(), many.normals()));
  one.set_control_points<CGAL::Sequential_tag>(control_points(one));
  many.set_control_points(control_points(many));
  CHECK(same(one.positions(), many.positions()));
  CHECK(same(one.normals(), many.normals()));
}

TEST_CASE("Where a control point has no influence its weights are not stored") {
  const unsigned seed = 38;
  CAPTURE(seed);
  Random random(seed);
  const Concave_patch patch = concave_patch(random, 6, MP::Central_weight::none);
  // Along one side, in two blocks: only its boundary curve counts for points.
  Samples<Kernel> samples;
  for (int k = 0; k < 100; ++k) {
    const double s = random.in(0.01, 0.99);
    samples.points.push_back(patch.domain().point_on_side(2, s));
    samples.locations.push_back(Domain::Location::on_side(2, s));
  }
  MP::Patch_evaluator<Concave_patch, 0> evaluator(patch, samples.points, samples.locations);
  CHECK(evaluator.number_of_stored_weights() == 2 * 64 * (patch.loop()[2].degree() + 1));
  // A control point of another side does not touch them.
  const Points before = evaluator.positions();
  evaluator.set_control_point(patch.basis().index(4, 0, 0), Point_3(0.1, 0.2, 0.3));
  CHECK(same(evaluator.positions(), before));
  for (std::size_t k = 0; k < before.size(); ++k)
    CHECK(distance(before[k], patch.point_on_side(2, samples.locations[k].s)) < 1e-14);

  // Inside they all count, but for the central one, which has no weight.
  const auto inside = Samples<Kernel>{{Point_2(0, 0)}, {Domain::Location::interior()}};
  MP::Patch_evaluator<Concave_patch, 0> centre(patch, inside.points, inside.locations);
  CHECK(centre.number_of_stored_weights() == 64 * (patch.basis().size() - 1));
}

TEST_CASE("There may be no samples at all") {
  const unsigned seed = 39;
  CAPTURE(seed);
  Random random(seed);
  const Concave_patch patch = concave_patch(random, 5, MP::Central_weight::none);
  const Samples<Kernel> none;
  MP::Patch_evaluator<Concave_patch> evaluator(patch, none.points, none.locations);
  evaluator.set_control_point(0, Point_3(1, 2, 3));
  evaluator.set_control_points(control_points(evaluator));
  CHECK(evaluator.positions().empty());
  CHECK(evaluator.number_of_stored_weights() == 0);
  CHECK(evaluator.control_point(0) == Point_3(1, 2, 3));
}
