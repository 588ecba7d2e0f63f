// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "catch.h"
#include "fixtures.h"
#include "io_fixtures.h"

#include <CGAL/Multisided_patches/IO/CGB.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <utility>
#include <vector>

using namespace fixtures;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using Model = MP::Concave_bezier_model_3<Kernel>;

namespace {

// Three sides with degrees 1, 2, 1 and 1, 1, 2 layers, and two extra corner control points.
const std::string valid_text = R"(0
2
0.05
0.1
3
1 1 0.5
1 1
0 0 0
4 0 0
2 1
4 0 0
3 3 0
0 4 0
1 2
0 4 0
0 0 0
1 3 0.5
1 1 0.5
2
2 0 0 0.1
0 1 0 0.1
)";

std::vector<std::string> valid_lines() {
  std::vector<std::string> lines;
  std::istringstream in(valid_text);
  for (std::string line; std::getline(in, line);)
    lines.push_back(line);
  return lines;
}

std::string joined(const std::vector<std::string>& lines, const std::string& separator = "\n") {
  std::string text;
  for (const auto& line : lines)
    text += line + separator;
  return text;
}

std::vector<std::string> valid_tokens() {
  std::istringstream in(valid_text);
  return {std::istream_iterator<std::string>(in), {}};
}

Model read(const std::string& text) {
  std::istringstream in(text);
  return MP::IO::read_CGB<Kernel>(in, "x.cgb");
}

std::string written(const Model& model) {
  std::ostringstream out;
  MP::IO::write_CGB(out, model);
  return out.str();
}

std::string error_of(const std::string& text) {
  return input_error_of([&] { read(text); });
}

// All that a model says, so that two models are the same if and only if these are.
std::vector<std::uint64_t> bits(const Model& model) {
  std::vector<std::uint64_t> result;
  const auto add = [&](auto... values) { (result.push_back(std::uint64_t(values)), ...); };
  const auto add_double = [&](double x) { std::memcpy(&result.emplace_back(), &x, sizeof x); };
  const auto add_point = [&](const Point_3& p) {
    for (int i = 0; i < 3; ++i)
      add_double(p[i]);
  };
  add(model.central_weight, model.domain.generator, model.loop.size());
  add_double(model.domain.clearance);
  add_double(model.parameter_dilation);
  add_point(model.central_point.value());
  for (const Ribbon& ribbon : model.loop.ribbons()) {
    add(ribbon.degree(), ribbon.layers());
    std::for_each(ribbon.control_points().begin(), ribbon.control_points().end(), add_point);
  }
  for (const auto& corner : model.corner_control_points) {
    add(corner.index);
    add_point(corner.point);
  }
  return result;
}

} // namespace

TEST_CASE("The entries of a .cgb file arrive where they belong") {
  const Model model = read(valid_text);
  CHECK(model.central_weight == MP::Central_weight::weight_deficiency);
  CHECK(model.domain.generator == MP::Domain_generator::similarity_outer);
  CHECK(model.domain.clearance == 0.05);
  CHECK(model.parameter_dilation == 0.1);
  CHECK(model.central_point == Point_3(1, 1, 0.5));
  REQUIRE(model.loop.size() == 3);
  CHECK(model.loop[1].degree() == 2);
  CHECK(model.loop[1].control_point(1, 0) == Point_3(3, 3, 0));
  CHECK(model.loop[2].layers() == 2);
  CHECK(model.loop[2].control_point(0, 1) == Point_3(1, 3, 0.5));
  REQUIRE(model.corner_control_points.size() == 2);
  CHECK(model.corner_control_points[0].index == 2);
  CHECK(model.corner_control_points[1].point == Point_3(1, 0, 0.1));
}

TEST_CASE("White space of any kind separates the numbers of a .cgb file") {
  const Model model = read(valid_text);
  for (const std::string separator : {"\r\n", " ", "\t\t", "\n\n  \n", "\v\f", "\r"})
    CHECK(bits(read(joined(valid_lines(), separator))) == bits(model));
  CHECK(bits(read("\n +" + valid_text)) == bits(model));
}

TEST_CASE("A model that is written is read back bit for bit") {
  const unsigned seed = GENERATE(range(1u, 21u));
  CAPTURE(seed);
  Random random(seed);
  const std::size_t n = random.integer(3, 9);
  Model model(random_loop(random, n, 0.02));
  model.central_weight = MP::IO::internal::central_weights[seed % 4];
  model.domain.generator = MP::IO::internal::domain_types[seed / 4 % 4];
  model.domain.clearance = random.in(0, 1);
  model.parameter_dilation = random.in(-2, 2);
  model.central_point = Point_3(-0.0, random.in(-1, 1) * 1e-300, 1 / 3.0);
  for (std::size_t k = random.integer(0, n); k > 0; --k)
    model.corner_control_points.push_back(
        {random.integer(0, n - 1), Point_3(random.in(-1e9, 1e9), 5e-324, 1e300)});

  CHECK(bits(read(written(model))) == bits(model));
  const Scratch_directory directory;
  MP::IO::write_CGB(directory / "model.cgb", model);
  CHECK(bits(MP::IO::read_CGB<Kernel>(directory / "model.cgb")) == bits(model));
  CHECK(contents(directory / "model.cgb") == written(model));
}

TEST_CASE("What the .cgb format cannot say is written as its closest choice") {
  Model model = read(valid_text);
  model.central_point.reset();
  model.domain.generator = GENERATE(MP::Domain_generator::automatic, MP::Domain_generator::circular,
                                    MP::Domain_generator::regular);
  const Model again = read(written(model));
  CHECK(again.domain.generator == MP::Domain_generator::similarity);
  CHECK(again.central_point == model.default_central_point());
}

TEST_CASE("A byte order mark at the beginning of a .cgb file makes no difference") {
  CHECK(bits(read("\xef\xbb\xbf" + valid_text)) == bits(read(valid_text)));
}

TEST_CASE("An automatic central weight is refused, and a loop is written without a central point") {
  Model model = read(valid_text);
  model.central_weight = MP::Central_weight::automatic;
  CHECK_THAT(input_error_of([&] { written(model); }), Contains("with_resolved_central_weight()"));
  const Scratch_directory directory;
  CHECK_THROWS_AS(MP::IO::write_CGB(directory / "model.cgb", model), MP::Input_error);
  CHECK(!std::filesystem::exists(directory / "model.cgb"));

  MP::IO::write_CGB(directory / "loop.cgb", model.loop);
  CHECK(MP::IO::read_CGB<Kernel>(directory / "loop.cgb").central_weight ==
        MP::Central_weight::none);
}

TEST_CASE("Models in exact numbers are read and written, with no need of coordinates") {
  using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  std::istringstream in(valid_text);
  const auto model = MP::IO::read_CGB<Exact>(in, "x.cgb");
  std::ostringstream out;
  MP::IO::write_CGB(out, model);
  CHECK(out.str() == written(read(valid_text)));
  std::ostringstream loop;
  MP::IO::write_CGB(loop, model.loop);
  CHECK_THAT(loop.str(), StartsWith("1\n"));
}

TEST_CASE("A model is written alike whatever the format flags and the locale of the stream") {
  const Model model = read(valid_text);
  std::ostringstream out;
  out.imbue(decimal_comma);
  out << std::fixed << std::showpos << std::hex;
  out.precision(2);
  MP::IO::write_CGB(out, model);
  CHECK(out.str() == written(model));
  CHECK(out.precision() == 2);

  const Global_locale foreign(decimal_comma);
  const Scratch_directory directory;
  MP::IO::write_CGB(directory / "model.cgb", model);
  CHECK(contents(directory / "model.cgb") == written(model));
}

TEST_CASE("A bad entry of a .cgb file is an error that says where it is and what was expected") {
  struct Row {
    std::string what;
    std::size_t line;
    std::string text, expected;
  };
  const Row rows[] = {
      {"central weight too large", 1, "4", "the central weight, an integer from 0 to 3, found '4'"},
      {"negative central weight", 1, "-1", "the central weight"},
      {"fractional central weight", 1, "1.5", "the central weight, an integer from 0 to 3"},
      {"half a byte order mark", 1, "\xef\xbb\x30", "the central weight"},
      {"two byte order marks", 1, "\xef\xbb\xbf\xef\xbb\xbf\x30", "the central weight"},
      {"domain type too large", 2, "4", "the domain type, an integer from 0 to 3, found '4'"},
      {"negative domain type", 2, "-1", "the domain type"},
      {"fractional domain type", 2, "1.5", "the domain type"},
      {"negative tolerance", 3, "-0.1", "a domain tolerance that is not negative"},
      {"tolerance NaN", 3, "nan", "the domain tolerance, a finite number, found 'nan'"},
      {"infinite dilation", 4, "inf", "the parameter dilation, a finite number, found 'inf'"},
      {"two signs", 4, "+-0.5", "the parameter dilation"},
      {"n = 0", 5, "0", "the number of sides, an integer from 3 to 1000, found '0'"},
      {"n = 1", 5, "1", "the number of sides"},
      {"n = 2", 5, "2", "the number of sides"},
      {"n = 10^9", 5, "1000000000", "the number of sides, an integer from 3 to 1000"},
      {"n beyond 64 bits", 5, "99999999999999999999", "the number of sides"},
      {"negative n", 5, "-3", "the number of sides"},
      {"n with a point", 5, "3.0", "the number of sides"},
      {"n in hexadecimal", 5, "0x3", "the number of sides"},
      {"n as a word", 5, "three", "the number of sides"},
      {"n is NaN", 5, "NaN", "the number of sides"},
      {"a remark", 5, "3 # sides", "x of the central control point, a finite number, found '#'"},
      {"a coordinate NaN", 6, "1 nan 0", "y of the central control point"},
      {"degree 0", 7, "0 1", "the degree of side 0, an integer from 1 to 100, found '0'"},
      {"a coordinate beyond double", 8, "1e999 0 0", "x of point 0 in row 0 of side 0, a finite"},
      {"an infinite coordinate", 9, "4 0 -inf", "z of point 1 in row 0 of side 0"},
      {"a NUL byte", 9, std::string("4 0\0 0", 6), "y of point 1 in row 0 of side 0"},
      {"degree 10^6", 10, "1000000 1", "the degree of side 1"},
      {"a hexadecimal coordinate", 12, "0x1p3 3 0", "x of point 1 in row 0 of side 1"},
      {"negative degree", 14, "-1 2", "the degree of side 2"},
      {"no layers", 14, "1 0", "the number of layers of side 2, an integer from 1 to 50"},
      {"10^6 layers", 14, "1 1000000", "the number of layers of side 2"},
      {"a decimal comma", 17, "1 3 0,5", "z of point 0 in row 1 of side 2"},
      {"a lone sign", 18, "+ 1 0.5", "x of point 1 in row 1 of side 2"},
      {"half an exponent", 18, "1 1e 0.5", "y of point 1 in row 1 of side 2"},
      {"negative k", 19, "-1", "the number of extra corner control points"},
      {"k > n", 19, "4", "the number of extra corner control points, an integer from 0 to 3"},
      {"a negative corner index", 20, "-1 0 0 0", "the index of extra corner control point 0"},
      {"a corner index out of range", 21, "3 1 0 0", "the index of extra corner control point 1"},
      {"a word at the end", 21, "0 1 0 0.1 end", "the end of the file, found 'end'"},
  };
  for (const Row& row : rows) {
    std::vector<std::string> lines = valid_lines();
    lines[row.line - 1] = row.text;
    INFO(row.what);
    CHECK_THAT(error_of(joined(lines)),
               StartsWith("x.cgb:" + std::to_string(row.line) + ": expected " + row.expected));
  }
}

TEST_CASE("Numbers of a .cgb file that do not fit together are an error") {
  struct Row {
    std::string what;
    std::vector<std::pair<std::size_t, std::string>> changes; // line and what it becomes
    std::string message;
  };
  const Row rows[] = {
      {"a point too few", {{12, ""}}, ":15: expected the number of layers of side 2"},
      {"k too large", {{19, "3"}}, ":22: expected the index of extra corner control point 2"},
      {"k too small", {{19, "1"}}, ":21: expected the end of the file, found '0'"},
      {"a gap after side 0",
       {{11, "4 1 0"}},
       ": the loop does not close: side 0 ends at (4, 0, 0), 1 away"},
      {"a gap after side 2",
       {{16, "0 0 2"}},
       ": the loop does not close: side 2 ends at (0, 0, 2), 2 away"},
      {"a tiny gap",
       {{11, "4 0 2e-8"}},
       ": the loop does not close: side 0 ends at (4, 0, 0), 2e-08 away"},
      {"a point for a side", {{13, "0 0 0"}, {15, "0 0 0"}}, ": the boundary curve of side 2 is a"},
      {"squares overflow", {{12, "3e200 3 0"}}, ": the control points"},
  };
  for (const Row& row : rows) {
    std::vector<std::string> lines = valid_lines();
    for (const auto& [line, text] : row.changes)
      lines[line - 1] = text;
    INFO(row.what);
    CHECK_THAT(error_of(joined(lines)), StartsWith("x.cgb" + row.message));
  }
}

TEST_CASE("A .cgb file that ends too early is an error wherever it ends") {
  const std::vector<std::string> tokens = valid_tokens();
  for (std::size_t k = 0; k < tokens.size(); ++k) {
    const std::string text = joined({tokens.begin(), tokens.begin() + static_cast<long>(k)});
    CHECK_THAT(error_of(text), Contains("x.cgb:" + std::to_string(k + 1) + ": expected ") &&
                                   Contains(", found the end of the file"));
  }
}

TEST_CASE("A word that is not a number is an error wherever it stands in a .cgb file") {
  for (const std::string word : {"nan", "-inf", "1e999", "0x10", "x", "-", "1e", "--1", "1_0"})
    for (std::size_t k = 0; k < valid_tokens().size(); ++k) {
      std::vector<std::string> tokens = valid_tokens();
      tokens[k] = word;
      CHECK_THAT(error_of(joined(tokens)), Contains("x.cgb:" + std::to_string(k + 1) + ": ") &&
                                               Contains("found '" + word + "'"));
    }
}

TEST_CASE("A file that is not a .cgb file at all is an error in its first line") {
  std::string every_byte;
  for (int c = 255; c >= 0; --c)
    every_byte += static_cast<char>(c);
  for (const std::string& text : {every_byte,
                                  std::string("\x7f"
                                              "ELF\x02\x01\x01\0\0\0\0",
                                              11),
                                  std::string(1 << 20, '1'), std::string(1 << 20, '\0'),
                                  std::string("ply\nformat ascii 1.0\n"), std::string("{}")})
    CHECK_THAT(error_of(text), Contains("x.cgb:1: expected "));
  CHECK_THAT(error_of(std::string(1 << 20, '\n')), Contains("found the end of the file"));
}

TEST_CASE("Errors name the file that cannot be read or written") {
  const Scratch_directory directory;
  const auto message = [](const auto& f) -> std::string {
    try {
      f();
    } catch (const MP::Error& error) {
      return error.what();
    }
    return "no error";
  };
  const auto reading = [&](const std::string& name) {
    return message([&] { MP::IO::read_CGB<Kernel>(name); });
  };
  const auto writing = [&](const std::string& name) {
    return message([&] { MP::IO::write_CGB(name, read(valid_text)); });
  };
  const std::string missing = directory / "missing", self = directory / ".";
  CHECK_THAT(reading(missing), Contains(missing + ": cannot be opened for reading"));
  CHECK_THAT(reading(self), Contains(self + ": expected a file, found a directory"));
  CHECK_THAT(writing(missing + "/x.cgb"), Contains(missing + "/x.cgb: cannot be opened"));
  CHECK_THAT(writing(self), Contains(self + ": cannot be written: it is a directory"));
  if (fs::exists("/dev/full"))
    CHECK_THAT(writing("/dev/full"), Contains("/dev/full: cannot be written"));
  CHECK(directory.files().empty());
}

TEST_CASE("Of a link, the file that it points to is replaced, and keeps its permissions") {
  const Scratch_directory directory;
  const std::string target = directory / "target", link = directory / "link";
  std::ofstream(target) << "old";
  fs::permissions(target, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink(target, link);
  MP::internal::Atomic_file file(link);
  file.stream() << "new";
  file.commit();
  CHECK(fs::is_symlink(link));
  CHECK(contents(target) == "new");
  CHECK(fs::status(target).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}

TEST_CASE("A model that the .cgb format cannot hold is not written") {
  Model model = read(valid_text);
  model.domain.clearance = -1;
  CHECK_THROWS_AS(written(model), MP::Input_error);
  model.domain.clearance = 0;
  model.parameter_dilation = std::nan("");
  CHECK_THROWS_AS(written(model), MP::Input_error);
  model.parameter_dilation = 0;
  model.corner_control_points[0].index = 3;
  CHECK_THROWS_AS(written(model), MP::Input_error);
}

TEST_CASE("A file is replaced as a whole or not at all") {
  const Scratch_directory directory;
  const std::string name = directory / "file";
  MP::internal::check_writable(name);
  CHECK(directory.files().empty());
  for (const std::string text : {"first", "second"}) {
    const std::string before = contents(name);
    {
      MP::internal::Atomic_file abandoned(name);
      abandoned.stream() << text << std::flush;
    }
    CHECK(contents(name) == before);
    MP::internal::Atomic_file file(name);
    file.stream() << text << std::flush;
    CHECK(contents(name) == before);
    file.commit();
    CHECK(contents(name) == text);
    CHECK(directory.files() == std::vector<std::string>{"file"});
    MP::internal::check_writable(name);
    CHECK(contents(name) == text);
  }
}
