// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs `multipatch coordinates` as a user does. POSIX only.

#include "catch.h"
#include "program_fixtures.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using namespace program_fixtures;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

const std::string l_shape = "0 0\n2 0\n2 1\n1 1\n1 2\n0 2\n";
const std::string reversed_l_shape = "0 0\n0 2\n1 2\n1 1\n2 1\n2 0\n";
const std::string square_with_hole = "0 0\n3 0\n3 3\n0 3\n\n1 1\n2 1\n2 2\n1 2\n";
const std::string convex = "0 0\n2 0\n3 1\n1 2\n";

std::string polygon(std::size_t n) {
  std::ostringstream out;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(n);
    out << std::cos(t) << ' ' << std::sin(t) << '\n';
  }
  return out.str();
}

struct Table {
  std::string header;
  std::vector<std::vector<double>> rows;
};

Table table(const std::string& text) {
  std::istringstream in(text);
  Table result;
  std::getline(in, result.header);
  for (std::string line; std::getline(in, line);) {
    std::istringstream cells(line);
    auto& row = result.rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');)
      row.push_back(std::strtod(cell.c_str(), nullptr));
  }
  return result;
}

std::vector<std::vector<double>> vertices(const std::string& polygon_text) {
  std::istringstream in(polygon_text);
  std::vector<std::vector<double>> points;
  for (double x, y; in >> x >> y;)
    points.push_back({x, y});
  return points;
}

double sum(const std::vector<double>& row, std::size_t n) {
  return std::accumulate(row.begin() + 2, row.begin() + 2 + static_cast<long>(n), 0.0);
}

// The coordinates sum to one and give the point back; at a vertex they are exactly 1 and 0.
void check_coordinates(const Table& csv, const std::string& polygon_text) {
  const auto polygon = vertices(polygon_text);
  std::size_t at_vertices = 0;
  for (const std::vector<double>& row : csv.rows) {
    REQUIRE(row.size() >= 2 + polygon.size());
    double u = 0, v = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      u += row[2 + i] * polygon[i][0];
      v += row[2 + i] * polygon[i][1];
    }
    CHECK(std::abs(sum(row, polygon.size()) - 1) < 1e-13);
    CHECK(std::abs(u - row[0]) + std::abs(v - row[1]) < 1e-12);
    for (std::size_t i = 0; i < polygon.size(); ++i)
      if (row[0] == polygon[i][0] && row[1] == polygon[i][1]) {
        ++at_vertices;
        for (std::size_t j = 0; j < polygon.size(); ++j)
          CHECK(row[2 + j] == (i == j ? 1 : 0));
      }
  }
  CHECK(at_vertices == polygon.size());
}

} // namespace

TEST_CASE("A table of coordinates sums to one in every row, in the order of the file") {
  const Scratch work("coordinates_table");
  struct Row {
    std::string text, options, loops;
  };
  const Row rows[] = {
      {l_shape, "", "6 sides, 1 loop,"},
      {reversed_l_shape, "", "6 sides, 1 loop,"},
      {square_with_hole, "", "8 sides, 2 loops,"},
      {l_shape, " --coordinates mean-value", "6 sides, 1 loop,"},
      {square_with_hole, " --coordinates mean-value", "8 sides, 2 loops,"},
      {convex, " --coordinates wachspress", "4 sides, 1 loop,"},
      {l_shape, " --samples 5000 --target-error 1e-4", "6 sides, 1 loop,"},
      {l_shape, " --target-error 1e-30 --acceptable-error 1e-9", "6 sides, 1 loop,"},
  };
  for (const Row& row : rows) {
    INFO(row.text << row.options);
    work.write("p.txt", row.text);
    const std::string out = work.run_well("coordinates p.txt -o a.csv" + row.options);
    const Table csv = table(contents(work / "a.csv"));
    CHECK_THAT(out, StartsWith("a.csv: " + row.loops) &&
                        Contains(" " + std::to_string(csv.rows.size()) + " points") &&
                        Contains("setup ") && Contains("evaluation "));
    const double wanted = row.options.find("5000") != std::string::npos ? 5000 : 1000;
    CHECK(static_cast<double>(csv.rows.size()) == Approx(wanted).epsilon(0.05));
    CHECK_THAT(csv.header, StartsWith("u,v,lambda_0,lambda_1,"));
    check_coordinates(csv, row.text);
  }
  CHECK(work.files() == std::set<std::string>{"p.txt", "a.csv"});
}

TEST_CASE("A table of coordinates has exact linear functions on the sides") {
  const Scratch work("coordinates_boundary");
  work.write("l.txt", l_shape);
  work.run_well("coordinates l.txt -o a.csv");
  std::size_t on_bottom = 0;
  for (const auto& row : table(contents(work / "a.csv")).rows)
    if (row[1] == 0) {
      ++on_bottom;
      CHECK(row[2] + row[3] == 1);
      CHECK(std::abs(row[3] - row[0] / 2) < 1e-15);
      CHECK((row[4] == 0 && row[5] == 0 && row[6] == 0 && row[7] == 0));
    }
  CHECK(on_bottom > 20);
}

TEST_CASE("Either orientation of a loop gives the same coordinates") {
  const Scratch work("coordinates_orientation");
  work.write("l.txt", l_shape);
  work.write("r.txt", reversed_l_shape);
  work.write("at.txt", "0.5 0.5\n1.25 0.75\n0.1 1.9\n");
  work.run_well("coordinates l.txt -o l.csv --at at.txt");
  work.run_well("coordinates r.txt -o r.csv --at at.txt");
  const Table l = table(contents(work / "l.csv")), r = table(contents(work / "r.csv"));
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 6; ++i)
      CHECK(std::abs(l.rows.at(k).at(2 + i) - r.rows.at(k).at(2 + (6 - i) % 6)) < 1e-8);
}

TEST_CASE("Coordinates at given points come in their order, and say what lies outside") {
  const Scratch work("coordinates_at");
  work.write("l.txt", l_shape);
  work.write("at.txt", "# points\r\n0.5 0.5\r\n\r\n0.25 0 # on a side\r\n1.5 1.5\r\n2 1\r\n9 9");
  const Result result = work.run("coordinates l.txt -o a.csv --at at.txt");
  CHECK(result.status == 0);
  CHECK_THAT(result.out, Contains(", 5 points;") && Contains("error bound "));
  CHECK(result.err == "multipatch: warning: 2 of 5 points lie outside the domain and have nan for "
                      "coordinates; the first is at.txt:5: (1.5, 1.5)\n");
  const Table csv = table(contents(work / "a.csv"));
  REQUIRE(csv.rows.size() == 5);
  CHECK(std::abs(sum(csv.rows[0], 6) - 1) < 1e-13);
  CHECK(csv.rows[1] == std::vector<double>{0.25, 0, 0.875, 0.125, 0, 0, 0, 0});
  CHECK(csv.rows[3] == std::vector<double>{2, 1, 0, 0, 1, 0, 0, 0});
  for (const std::size_t k : {2, 4})
    for (std::size_t i = 2; i < 8; ++i)
      CHECK(std::isnan(csv.rows[k][i]));
  CHECK(work.run("coordinates l.txt -o a.csv -q --at at.txt").err.empty());
}

TEST_CASE("Derivatives of coordinates follow the values") {
  const Scratch work("coordinates_derivatives");
  work.write("p.txt", convex);
  work.write("at.txt", "1 0.5\n1.3 1.1\n0 0\n");
  for (const std::string name : {"harmonic", "mean-value", "wachspress"}) {
    INFO(name);
    const std::string command = "coordinates p.txt -q -o a.csv --at at.txt --coordinates " + name;
    work.run_well(command);
    const Table values = table(contents(work / "a.csv"));
    for (const int order : {1, 2}) {
      work.run_well(command + " --derivatives " + std::to_string(order));
      const Table csv = table(contents(work / "a.csv"));
      const std::size_t parts = order == 1 ? 2 : 5;
      CHECK_THAT(csv.header,
                 StartsWith("u,v,lambda_0,lambda_1,lambda_2,lambda_3,lambda_0_u,lambda_0_v,") &&
                     EndsWith(order == 1 ? "lambda_3_u,lambda_3_v" : "lambda_3_uv,lambda_3_vv"));
      for (std::size_t k = 0; k < 2; ++k) {
        const std::vector<double>& row = csv.rows.at(k);
        REQUIRE(row.size() == 6 + 4 * parts);
        CHECK(std::equal(values.rows[k].begin(), values.rows[k].end(), row.begin()));
        const double x[] = {0, 2, 3, 1}; // of the vertices
        std::vector<double> of_one(parts), of_u(parts);
        for (std::size_t i = 0; i < 4; ++i)
          for (std::size_t d = 0; d < parts; ++d) {
            of_one[d] += row[6 + i * parts + d];
            of_u[d] += x[i] * row[6 + i * parts + d];
          }
        for (std::size_t d = 0; d < parts; ++d) {
          CHECK(std::abs(of_one[d]) < 1e-10);
          CHECK(std::abs(of_u[d] - (d == 0 ? 1 : 0)) < 1e-10);
        }
      }
      // Mean value coordinates are not differentiable at vertices.
      CHECK(std::isnan(csv.rows.at(2).at(6)) == (name == "mean-value"));
    }
  }
}

TEST_CASE("Coordinates of a patch are those of its domain") {
  const Scratch work("coordinates_patch");
  const Example example = examples()[0];
  CHECK_THAT(work.run_well("coordinates " + example.argument + " -o a.csv --domain similarity"),
             Contains("; domain similarity, clearance "));
  for (const auto& row : table(contents(work / "a.csv")).rows)
    CHECK(std::abs(sum(row, row.size() - 2) - 1) < 1e-12);
}

TEST_CASE("Pictures of coordinates have a panel for each vertex, up to 12") {
  const Scratch work("coordinates_picture");
  struct Row {
    std::string text, options;
    std::size_t panels;
    std::string first, message;
  };
  const Row rows[] = {
      {l_shape, "", 6, "vertex 0", "a.svg: 6 sides, 1 loop, "},
      {square_with_hole, " --coordinates mean-value", 8, "vertex 0", "2 loops"},
      {polygon(20), "", 12, "vertex 0", "drawn: the vertices 0 to 11 of 20"},
      {polygon(20), " --vertex 19", 1, "vertex 19", "20 sides"},
      {polygon(100), " --coordinates mean-value --vertex 50", 1, "vertex 50", "100 sides"},
  };
  for (const Row& row : rows) {
    INFO(row.options);
    work.write("p.txt", row.text);
    CHECK_THAT(work.run_well("coordinates p.txt -o a.svg" + row.options), Contains(row.message));
    const std::string svg = contents(work / "a.svg");
    CHECK_THAT(svg, StartsWith("<svg ") && EndsWith("</svg>\n") && Contains(row.first + ";") &&
                        !Contains("nan") && !Contains("inf"));
    std::size_t panels = 0;
    for (std::size_t at = svg.find("evenodd"); at != std::string::npos;
         at = svg.find("evenodd", at + 1))
      ++panels;
    CHECK(panels == row.panels);
    CHECK(std::count(svg.begin(), svg.end(), '<') == std::count(svg.begin(), svg.end(), '>'));
  }
  CHECK(work.run_well("coordinates p.txt -q -o a.svg --coordinates mean-value").empty());
}

TEST_CASE("What goes wrong with coordinates is said in two lines, and leaves no trace") {
  constexpr int data = 1, usage = 2;
  struct Row {
    std::string arguments;
    int status;
    std::string message;
  };
  const Row rows[] = {
      {"empty.txt -o a.csv", data, "empty.txt:1: expected the vertices of a polygon"},
      {"word.txt -o a.csv", data, "word.txt:2: expected two finite numbers"},
      {"crossing.txt -o a.svg", data, "crossing.txt: sides 0 and 2 of the domain cross"},
      {"missing.txt -o a.csv", data, "missing.txt: cannot be opened"},
      {"missing.cgb -o a.csv", data, "missing.cgb: cannot be opened for reading: No such"},
      {"word.cgb -o a.csv", data, "word.cgb:1: "},
      {". -o a.csv", data, ".: expected a file"},
      {"many.txt -o a.csv", data, "many.txt: 1001 vertices are too many for harmonic"},
      {"huge.txt -o a.csv", data, "huge.txt: the domain is too large or too small"},
      {"tiny.txt -o a.csv", data, "tiny.txt: the domain is too large or too small"},
      {"l.txt -o a.csv --target-error 1e-30", data, "l.txt: harmonic coordinates on a domain of 6"},
      {"l.txt -o a.txt", usage, "a.txt: expected a name that ends in .svg or .csv"},
      {"l.txt -o no/a.csv", data, "no/a.csv: cannot be opened"},
      {"l.txt -o directory.csv", data, "directory.csv: cannot be written"},
      {"l.csv -o l.csv", usage, "l.csv: cannot be written: it is the same file"},
      {"l.txt -o at.csv --at at.csv", usage, "at.csv: cannot be written: it is the same file"},
      {"l.txt -o a.csv --at missing.txt", data, "missing.txt: cannot be opened"},
      {"l.txt -o a.csv --at word.txt", data, "word.txt:2: expected two finite numbers"},
      {"l.txt -o a.csv --at empty.txt", data, "empty.txt:1: expected points"},
      {"l.txt -o old.csv --at word.txt", data, "word.txt:2: "},
      {"l.txt -o a.csv --coordinates wachspress", data, "l.txt: Wachspress"},
      {"r.txt -o a.csv --coordinates wachspress", data, "and corner 2 is reflex"},
      {"hole.txt -o a.csv --coordinates wachspress", data, "this one has holes"},
      {"l.txt -o a.csv --domain regular", usage, "l.txt: --domain is for patches"},
      {"l.txt -o a.csv --clearance 0.1", usage, "l.txt: --clearance is for patches"},
      {"l.txt -o a.svg --samples 9", usage, "--samples is for .csv files only"},
      {"l.txt -o a.svg --at at.csv", usage, "--at is for .csv files only"},
      {"l.txt -o a.svg --derivatives 1", usage, "--derivatives is for .csv files only"},
      {"l.txt -o a.csv --vertex 1", usage, "--vertex is for .svg files only"},
      {"l.txt -o a.svg --vertex 6", data, "--vertex must be less than 6"},
      {"l.txt -o a.csv --target-error 0", usage, "expected a positive number below 1, not 0\n"},
      {"l.txt -o a.csv --target-error nan", usage, "expected a positive number below 1, not nan\n"},
      {"l.txt -o a.csv --target-error 1e-4 --coordinates mean-value", usage, "harmonic"},
      {"l.txt -o a.csv --acceptable-error 1e-4 --coordinates mean-value", usage, "harmonic"},
      {"l.txt -o a.csv --acceptable-error 0", usage, "expected a positive number below 1, not 0\n"},
      {"l.txt -o a.csv --derivatives 3", usage, "--derivatives"},
      {"l.txt -o a.csv --samples 0", usage, "--samples"},
      {"l.txt -o a.csv --samples 1000001", usage, "--samples"},
      {"l.txt -o a.csv --samples 9 --at at.csv", usage, "excludes"},
      {"l.txt -o a.svg --vertex -1", usage, "-1"},
      {"l.txt", usage, "--output"},
      {"-o a.csv", usage, "INPUT"},
  };
  const Scratch work("coordinates_errors");
  fs::create_directory(work / "directory.csv");
  for (const std::string name : {"l.txt", "l.csv", "at.csv"})
    work.write(name, l_shape);
  work.write("r.txt", "0 2\n1 2\n1 1\n2 1\n2 0\n0 0\n"); // clockwise
  work.write("hole.txt", square_with_hole);
  work.write("empty.txt", "");
  work.write("word.txt", "0 0\n1 one\n");
  work.write("word.cgb", "word");
  work.write("crossing.txt", "0 0\n1 1\n1 0\n0 1\n");
  work.write("many.txt", polygon(1001));
  work.write("huge.txt", "0 0\n1e200 0\n0 1e200\n");
  work.write("tiny.txt", "0 0\n1e-310 0\n0 1e-310\n");
  work.write("old.csv", "old");
  const std::set<std::string> files = work.files();
  for (const Row& row : rows) {
    const Result result = work.run("coordinates " + row.arguments);
    INFO("multipatch coordinates " << row.arguments);
    CHECK(result.status == row.status);
    CHECK(result.out.empty());
    CHECK_THAT(result.err, StartsWith("multipatch: ") && Contains(row.message) && EndsWith("\n"));
    CHECK(std::count(result.err.begin(), result.err.end(), '\n') <= 2);
    CHECK(work.files() == files);
    CHECK(contents(work / "old.csv") == "old");
    CHECK(contents(work / "l.csv") == l_shape);
  }
}

TEST_CASE("A table that outgrows the limit of file sizes is an error, and leaves no trace") {
  const Scratch work("coordinates_file_size");
  work.write("l.txt", l_shape);
  const Result result =
      work.run("coordinates l.txt -o a.csv --samples 10000", ">../out", "ulimit -f 10 &&");
  CHECK(result.status == 1);
  CHECK_THAT(result.err, StartsWith("multipatch: a.csv: cannot be written"));
  CHECK(work.files() == std::set<std::string>{"l.txt"});
}
