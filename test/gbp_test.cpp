// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "io_fixtures.h"

#include <CGAL/Multisided_patches/IO/GBP.h>

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <ios>
#include <iterator>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace fixtures;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

namespace MP = CGAL::Multisided_patches;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Net = MP::Generalized_bezier_net_3<Kernel>;

// A net of degree 3 on 3 sides: 3 * 3 points on the boundary, 3 inside, and the central one. The
// first two coordinates of a point tell side and number in its row, the third the row.
const std::string valid_text = R"(3 3
-1 -2 -3.5
0 0 0
0 1 0
0 2 0
1 0 0
1 1 0
1 2 0
2 0 0
2 1 0
2 2 0
0 0 1
1 0 1
2 0 1
)";

Net read(const std::string& text) {
  std::istringstream in(text);
  return MP::IO::read_GBP<Kernel>(in, "x.gbp");
}

std::string written(const Net& net) {
  std::ostringstream out;
  MP::IO::write_GBP(out, net);
  return out.str();
}

std::string error_of(const std::string& text) {
  return input_error_of([&] { read(text); });
}

// All that a net says, so that two nets are the same if and only if these are.
std::vector<std::uint64_t> bits(const Net& net) {
  std::vector<std::uint64_t> result{net.size(), net.degree()};
  for (const Point_3& p : net.control_points())
    for (int c = 0; c < 3; ++c)
      std::memcpy(&result.emplace_back(), &p[c], sizeof p[c]);
  return result;
}

std::vector<std::string> tokens(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
  std::string text;
  for (const std::string& word : words)
    text += word + separator;
  return text;
}

// Finite doubles of all sizes, negative zero among them.
double any_double(std::mt19937_64& engine) {
  for (;;) {
    const std::uint64_t pattern = engine();
    double x;
    std::memcpy(&x, &pattern, sizeof x);
    if (pattern % 16 == 0)
      return -0.0;
    if (std::isfinite(x))
      return x;
  }
}

Net random_net(std::size_t sides, std::size_t degree, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::vector<Point_3> points;
  while (points.size() < Net::number_of_control_points(sides, degree)) {
    const double x = any_double(engine), y = any_double(engine), z = any_double(engine);
    points.emplace_back(x, y, z);
  }
  return Net(sides, degree, std::move(points));
}

} // namespace

TEST_CASE("The points of a .gbp file arrive where they belong") {
  const Net net = read(valid_text);
  REQUIRE(net.size() == 3);
  REQUIRE(net.degree() == 3);
  CHECK(net.central_point() == Point_3(-1, -2, -3.5));
  for (std::size_t i = 0; i < 3; ++i) {
    const int side = static_cast<int>(i);
    for (int j = 0; j < 3; ++j)
      CHECK(net.control_point(i, j, 0) == Point_3(side, j, 0));
    CHECK(net.control_point(i, 3, 0) == Point_3((side + 1) % 3, 0, 0));
    CHECK(net.control_point(i, 1, 1) == Point_3(side, 0, 1));
  }
}

TEST_CASE("White space of any kind separates the numbers of a .gbp file") {
  const auto expected = bits(read(valid_text));
  for (const std::string separator : {"\r\n", " ", "\t\t", "\n\n  \n", "\v\f", "\r"})
    CHECK(bits(read(joined(tokens(valid_text), separator))) == expected);
  CHECK(bits(read("\n +" + valid_text)) == expected);
}

TEST_CASE("A net that is written in .gbp format is read back bit for bit, of any size") {
  const unsigned seed = GENERATE(range(1u, 11u));
  CAPTURE(seed);
  for (std::size_t sides = 3; sides < 8; ++sides)
    for (std::size_t degree = 1; degree < 9; ++degree) {
      const Net net = random_net(sides, degree, seed);
      const std::string text = written(net);
      CHECK(bits(read(text)) == bits(net));
      CHECK(written(read(text)) == text);
    }
}

TEST_CASE("A .gbp file does not depend on the format flags or the locale of its stream") {
  const Net net = random_net(5, 4, 7);
  const Global_locale locale(decimal_comma);
  std::ostringstream out;
  out << std::hex << std::showpos << std::fixed;
  out.precision(2);
  out.width(30);
  MP::IO::write_GBP(out, net);
  const std::string text = out.str();
  CHECK(tokens(text) == tokens(written(net)));
  CHECK(bits(read(text)) == bits(net));
}

TEST_CASE("A .gbp file that ends too early or goes on too long is refused with its line") {
  const std::vector<std::string> words = tokens(valid_text);
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::vector<std::string> some(words.begin(),
                                        words.begin() + static_cast<std::ptrdiff_t>(k));
    CHECK_THAT(error_of(joined(some, "\n")),
               StartsWith("x.gbp:" + std::to_string(k + 1) + ": expected ") &&
                   Contains("found the end of the file"));
  }
  CHECK(error_of(valid_text + "7") == "x.gbp:15: expected the end of the file, found '7'");
}

TEST_CASE("Every number of a .gbp file that is none is refused with its line and its meaning") {
  const std::vector<std::string> words = tokens(valid_text);
  for (std::size_t k = 0; k < words.size(); ++k)
    for (const std::string bad :
         {"nan", "inf", "-inf", "1e999", "x", "1,5", "0x10", "--1", "+-1"}) {
      std::vector<std::string> wrong = words;
      wrong[k] = bad;
      CHECK_THAT(error_of(joined(wrong, "\n")),
                 StartsWith("x.gbp:" + std::to_string(k + 1) + ": expected ") &&
                     Contains("found '" + bad + "'"));
    }
  CHECK_THAT(error_of("3 3\n0 0 0\n0 0 0\n0 1 0\n0 x 0"),
             StartsWith("x.gbp:5: expected y of point 2 in row 0 of side 0, a finite number"));
}

TEST_CASE("Hostile .gbp files are refused at once") {
  for (const std::string head : {"2 3", "0 3", "-1 3", "1001 3", "99999999999999999999 3", "3.5 3"})
    CHECK_THAT(error_of(head + "\n0 0 0\n"), StartsWith("x.gbp:1: expected the number of sides"));
  for (const std::string head : {"3 0", "3 101", "3 -1", "3 18446744073709551615", "3 1e1"})
    CHECK_THAT(error_of(head + "\n0 0 0\n"), StartsWith("x.gbp:1: expected the degree"));
  // Much is claimed and little is there.
  CHECK_THAT(error_of("1000 100\n0 0 0\n1 1 1\n"), Contains("found the end of the file"));
  CHECK_THAT(error_of(std::string(1000000, '7')), StartsWith("x.gbp:1: expected a number, found"));
  CHECK_THAT(error_of(std::string(1000, '\0')), StartsWith("x.gbp:1: expected a number, found"));
  CHECK_THAT(error_of("3 3\n\xff\xfe\x1b[31m"), StartsWith("x.gbp:2: expected x of the central"));
}

TEST_CASE("A .gbp file is written whole or not at all") {
  const Scratch_directory scratch;
  const Net net = read(valid_text);
  MP::IO::write_GBP(scratch / "a.gbp", net);
  CHECK(contents(scratch / "a.gbp") == valid_text);
  CHECK(bits(MP::IO::read_GBP<Kernel>(scratch / "a.gbp")) == bits(net));
  const Net too_high(3, 101,
                     std::vector<Point_3>(Net::number_of_control_points(3, 101), Point_3(1, 2, 3)));
  CHECK_THAT(input_error_of([&] { MP::IO::write_GBP(scratch / "a.gbp", too_high); }),
             Contains("degree 101"));
  CHECK(contents(scratch / "a.gbp") == valid_text);
  CHECK_THAT(input_error_of([&] { MP::IO::read_GBP<Kernel>(scratch / "b.gbp"); }),
             Contains("b.gbp: cannot be opened"));
  CHECK(scratch.files() == std::vector<std::string>{"a.gbp"});
}
