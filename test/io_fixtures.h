// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_IO_FIXTURES_H
#define MULTISIDED_PATCHES_TEST_IO_FIXTURES_H

#include "catch.h"

#include <CGAL/Multisided_patches/errors.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <locale>
#include <random>
#include <string>
#include <system_error>
#include <vector>

// What tests of files share.
namespace fixtures {

namespace fs = std::filesystem;

// A new directory that is removed with all that is in it.
class Scratch_directory {
public:
  Scratch_directory()
      : path_(fs::temp_directory_path() /
              ("multisided_patches_test" + std::to_string(std::random_device{}()))) {
    fs::create_directories(path_);
  }
  Scratch_directory(const Scratch_directory&) = delete;
  Scratch_directory& operator=(const Scratch_directory&) = delete;
  ~Scratch_directory() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(path_))
      names.push_back(entry.path().filename().string());
    return names;
  }

private:
  fs::path path_;
};

inline std::string contents(const std::string& file_name) {
  std::ifstream in(file_name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The message of the error that reading bad data throws, which is short and printable whatever the
// data are.
template <typename Function>
std::string input_error_of(const Function& read) {
  try {
    read();
  } catch (const CGAL::Multisided_patches::Input_error& error) {
    const std::string message = error.what();
    CHECK(message.size() < 200);
    for (const char c : message)
      CHECK((c >= 32 && c < 127));
    return message;
  }
  return "no error";
}

// Numbers as a country may write them: 1.234.567,8
struct Decimal_comma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

inline const std::locale decimal_comma(std::locale::classic(), new Decimal_comma);

// The locale of new streams, for a while.
class Global_locale {
public:
  explicit Global_locale(const std::locale& locale) : before_(std::locale::global(locale)) {}
  Global_locale(const Global_locale&) = delete;
  Global_locale& operator=(const Global_locale&) = delete;
  ~Global_locale() { std::locale::global(before_); }

private:
  std::locale before_;
};

} // namespace fixtures

#endif // MULTISIDED_PATCHES_TEST_IO_FIXTURES_H
