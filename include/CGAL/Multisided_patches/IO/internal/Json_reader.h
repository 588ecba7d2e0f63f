// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_IO_INTERNAL_JSON_READER_H
#define CGAL_MULTISIDED_PATCHES_IO_INTERNAL_JSON_READER_H

#include <CGAL/Multisided_patches/IO/internal/parse_json.h>
#include <CGAL/Multisided_patches/IO/internal/similar_word.h>
#include <CGAL/Multisided_patches/errors.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// A value of a JSON file that knows where it is, so that errors can say so.
class Json_reader {
public:
  using Json = nlohmann::json;

  // The value must outlive the reader.
  Json_reader(const Json& value, std::string file, std::string path = "")
      : value_(&value), file_(std::move(file)), path_(std::move(path)) {}

  [[noreturn]] void fail(const std::string& message) const {
    throw Input_error(file_ + ": " + (path_.empty() ? "" : path_ + ": ") + message);
  }

  // Expects an object without other keys than these.
  void expect_keys(const std::vector<std::string>& keys) const {
    if (!value_->is_object())
      fail_expecting("an object");
    for (const auto& member : value_->items())
      if (std::find(keys.begin(), keys.end(), member.key()) == keys.end())
        fail_at_key(member.key(), keys);
  }
  bool has(const std::string& key) const { return value_->is_object() && value_->contains(key); }
  Json_reader operator[](const std::string& key) const {
    if (!has(key))
      fail("expected an object with the key '" + key + "'");
    return {(*value_)[key], file_, path_ + '/' + key};
  }

  // The number of elements of an array, which must be in a range.
  std::size_t size(const std::string& what, std::size_t min, std::size_t max) const {
    if (!value_->is_array())
      fail_expecting("an array of " + what);
    const std::size_t n = value_->size();
    if (n < min || n > max)
      fail("expected " +
           (min == max ? std::to_string(min) : std::to_string(min) + " to " + std::to_string(max)) +
           ' ' + what + ", found " + std::to_string(n));
    return n;
  }
  Json_reader operator[](std::size_t i) const {
    return {(*value_)[i], file_, path_ + '/' + std::to_string(i)};
  }

  std::string text() const {
    if (!value_->is_string())
      fail_expecting("a string");
    return value_->get<std::string>();
  }
  // JSON has no infinite numbers.
  double number() const {
    if (!value_->is_number())
      fail_expecting("a number");
    return value_->get<double>();
  }
  std::size_t integer(std::size_t min, std::size_t max) const {
    const bool good = value_->is_number_unsigned();
    const std::size_t n = good ? value_->get<std::size_t>() : 0;
    if (!good || n < min || n > max)
      fail_expecting("an integer from " + std::to_string(min) + " to " + std::to_string(max));
    return n;
  }
  // The first of some values that has the name which the text is.
  template <typename Values>
  auto choice(const Values& values) const {
    std::string names;
    for (const auto value : values) {
      if (value_->is_string() && value_->get_ref<const std::string&>() == to_string(value))
        return value;
      names += (names.empty() ? "" : ", ") + std::string(to_string(value));
    }
    fail_expecting("one of " + names);
  }

  template <std::size_t N>
  std::array<double, N> numbers() const {
    const std::string what = std::to_string(N) + " numbers";
    if (!value_->is_array())
      fail_expecting(what);
    if (value_->size() != N)
      fail("expected " + what + ", found an array of " + std::to_string(value_->size()));
    std::array<double, N> result;
    for (std::size_t c = 0; c < N; ++c) {
      if (!(*value_)[c].is_number())
        fail("expected " + what + ", found " + shown((*value_)[c]) + " among them");
      result[c] = (*value_)[c].get<double>();
    }
    return result;
  }

private:
  [[noreturn]] void fail_expecting(const std::string& what) const {
    fail("expected " + what + ", found " + shown(*value_));
  }
  [[noreturn]] void fail_at_key(const std::string& key,
                                const std::vector<std::string>& known) const {
    const std::string similar = similar_word(key, known);
    fail("the key '" + printable(key) + "' is not known" +
         (similar.empty() ? "" : "; is '" + similar + "' meant?"));
  }

  static std::string shown(const Json& value) {
    return value.is_primitive()
               ? printable(value.dump(-1, ' ', true, Json::error_handler_t::replace))
           : value.is_array() ? "an array"
                              : "an object";
  }

  const Json* value_;
  std::string file_, path_;
};

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_IO_INTERNAL_JSON_READER_H
