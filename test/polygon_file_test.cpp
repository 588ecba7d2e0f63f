// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"
#include "io_fixtures.h"

#include <CGAL/Multisided_patches/IO/polygon_file.h>

#include <sstream>
#include <string>
#include <vector>

using namespace fixtures;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using Polygon_file = MP::IO::Polygon_file<Kernel>;

namespace {

const std::string l_text = "0 0\n2 0\n2 1\n1 1\n1 2\n0 2\n";
const std::string square_text = "0 0\n3 0\n3 3\n0 3\n";
const std::string hole_text = "1 1\n1 2\n2 1\n"; // clockwise

Polygon_file read(const std::string& text) {
  std::istringstream in(text);
  return MP::IO::read_polygon_file<Kernel>(in, "x.txt");
}

std::string error_of(const std::string& text) {
  return input_error_of([&] { read(text); });
}

// the vertices in the order of the file
std::vector<Point_2> points(const Polygon_file& file) {
  std::vector<Point_2> result;
  for (const std::size_t i : file.vertices)
    result.push_back(file.domain.vertex(i));
  return result;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

} // namespace

TEST_CASE("The vertices of a polygon file arrive in their order") {
  const Polygon_file file = read(l_text);
  CHECK(file.domain.vertices() == l_shape());
  CHECK(file.vertices == std::vector<std::size_t>{0, 1, 2, 3, 4, 5});
  CHECK(file.domain.number_of_loops() == 1);
}

TEST_CASE("The first loop of a polygon file is the outer one, the others are holes") {
  const Polygon_file file = read(square_text + "\n" + hole_text + "\n\n2 2\n2 2.5\n2.5 2\n");
  REQUIRE(file.domain.number_of_loops() == 3);
  CHECK(file.domain.loop_begin(1) == 4);
  CHECK(file.domain.loop_begin(2) == 7);
  CHECK(file.domain.vertex(5) == Point_2(1, 2));
  CHECK(file.domain.vertex(9) == Point_2(2.5, 2));
}

TEST_CASE("Loops of a polygon file may run either way, and keep their numbers") {
  const Polygon_file file = read("0 3\n3 3\n3 0\n0 0\n\n2 1\n1 2\n1 1\n");
  CHECK(points(file) ==
        std::vector<Point_2>{{0, 3}, {3, 3}, {3, 0}, {0, 0}, {2, 1}, {1, 2}, {1, 1}});
  CHECK(file.vertices == std::vector<std::size_t>{0, 3, 2, 1, 4, 6, 5});
  CHECK(file.domain.area() == 8.5);
}

TEST_CASE("Comments, white space, line ends and closing points make no difference") {
  const std::vector<Point_2> expected = points(read(square_text + "\n" + hole_text));
  const std::string texts[] = {
      "# a square\n" + square_text + "# with\n\n# a hole\n" + hole_text,
      "0 0#origin\n3 0 # right\n#\n3 3\n0 3\n\n" + hole_text + "#",
      "\n \n\t\n" + square_text + " \t \n\n\n" + hole_text + "\n\n",
      replaced(square_text + "\n" + hole_text, "\n", "\r\n"),
      replaced(square_text + "\n" + hole_text, "\n", "\r"),
      replaced(square_text + "\n" + hole_text, " ", "\t \v\f"),
      square_text + "0 0\n\n" + hole_text + "1 1\n",
      square_text + "-0 0e5\n\n" + hole_text + "1.0 +1",
      "+0 0\n3.0 0\n.3e1 30e-1\n0 3\n\n" + hole_text.substr(0, hole_text.size() - 1),
  };
  for (const std::string& text : texts) {
    INFO(text);
    CHECK(points(read(text)) == expected);
  }
  const Global_locale foreign(decimal_comma);
  CHECK(points(read(texts[8])) == expected);
}

TEST_CASE("A bad line of a polygon file is an error that says where it is and what was expected") {
  struct Row {
    std::string text, message;
  };
  const std::string numbers = "expected two finite numbers, separated by white space, found ";
  const Row rows[] = {
      {"", "1: expected the vertices of a polygon, two numbers a line, found the end of the file"},
      {"\n\n# nothing\n", "3: expected the vertices of a polygon"},
      {"0 0\n1\n", "2: expected two numbers, found only one"},
      {"0 0\n1 # 2\n", "2: expected two numbers, found only one"},
      {"0 0\n1 2 3\n", "2: expected the end of the line after two numbers, found '3'"},
      {"0 0\r\n\r\n", "2: expected at least 3 different vertices in the loop that ends here"},
      {"0 0\n1 0\n",
       "2: expected at least 3 different vertices in the loop that ends here, found 2"},
      {"0 0\n1 0\n0 0\n", "3: expected at least 3 different vertices"},
      {square_text + "\n1 1\n1 2\n\n1 3", "8: expected at least 3 different vertices"},
      {"0 0\nx 0\n", "2: " + numbers + "'x'"},
      {"# a\n\n0 0\n1 nan\n", "4: " + numbers + "'nan'"},
      {"0 -inf\n", "1: " + numbers + "'-inf'"},
      {"0 1e999\n", "1: " + numbers + "'1e999'"},
      {"0, 0\n", "1: " + numbers + "'0,'"},
      {"0x1 0\n", "1: " + numbers + "'0x1'"},
      {"1e 0\n", "1: " + numbers + "'1e'"},
      {"+-1 0\n", "1: " + numbers + "'+-1'"},
      {std::string("0 0\n1\0 0\n", 8), "2: " + numbers + "'1?'"},
      {"\x7f\x45LF\x02 1\n", "1: " + numbers + "'?ELF?'"},
      {std::string(1 << 20, '1'), "1: " + numbers + "'11111111111111111111...'"},
      {std::string(1 << 20, '\0'), "1: " + numbers + "'????????????????????...'"},
  };
  for (const Row& row : rows) {
    INFO(row.text.substr(0, 50));
    CHECK_THAT(error_of(row.text), StartsWith("x.txt:" + row.message));
  }
  CHECK_THAT(error_of(std::string(1 << 20, '\n')), Contains("found the end of the file"));
}

TEST_CASE("Loops of a polygon file that bound no domain are named in the numbers of the file") {
  struct Row {
    std::string text, message;
  };
  const Row rows[] = {
      {"0 0\n1 1\n1 0\n0 1\n", "sides 0 and 2 of the domain cross or touch"},
      // clockwise, so that the domain would have other numbers
      {"0 0\n0 4\n4 4\n4 2\n-1 2\n4 0\n", "sides 0 and 3 of the domain cross or touch"},
      {"0 0\n1 0\n1 0\n0 1\n", "side 1 of the domain has length zero"},
      {"0 0\n1 0\n2 0\n", "sides 0 and 2 of the domain cross or touch"},
      {"0 3\n3 3\n3 0\n0 0\n\n2 1\n1 1\n1 4\n", "sides 0 and 5 of two loops of the domain cross"},
      {square_text + "\n4 4\n5 4\n5 5\n", "hole 0 lies outside the domain"},
      {hole_text + "\n" + square_text, "hole 0 lies outside the domain"},
      {square_text + "\n" + hole_text + "\n1.1 1.1\n1.1 1.2\n1.2 1.1\n", "holes 0 and 1"},
  };
  for (const Row& row : rows) {
    INFO(row.text);
    CHECK_THAT(error_of(row.text), StartsWith("x.txt: " + row.message));
  }
}

TEST_CASE("A polygon file has at most so many vertices") {
  const std::size_t most = MP::IO::Polygon_file_limits::max_vertices;
  const auto polygon = [](std::size_t n) { // a convex arc
    std::string text;
    for (std::size_t i = 0; i < n; ++i)
      text += std::to_string(i) + " " + std::to_string(i * i) + "\n";
    return text;
  };
  CHECK(read(polygon(most)).domain.size() == most);
  CHECK_THAT(error_of(polygon(most + 1)),
             StartsWith("x.txt:10001: expected no more than 10000 vertices"));
}

TEST_CASE("Errors name the polygon file that cannot be read") {
  const Scratch_directory directory;
  const auto message = [](const std::string& name) {
    return input_error_of([&] { MP::IO::read_polygon_file<Kernel>(name); });
  };
  CHECK_THAT(message(directory / "missing"), Contains("missing: cannot be opened for reading"));
  CHECK_THAT(message(directory / "."), Contains(": expected a file, found a directory"));
  std::ofstream(directory / "l.txt") << l_text;
  CHECK(message(directory / "l.txt") == "no error");
}
