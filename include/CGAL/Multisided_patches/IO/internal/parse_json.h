// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_IO_INTERNAL_PARSE_JSON_H
#define CGAL_MULTISIDED_PATCHES_IO_INTERNAL_PARSE_JSON_H

#include <CGAL/Multisided_patches/errors.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <istream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// What a JSON text may have. The depth is the number of arrays and objects around a value.
struct Json_limits {
  std::size_t size, values, depth;
};

// Text of a file, or about one, as an error message can show it.
inline std::string printable(const std::string& text, std::size_t longest = 40) {
  std::string result;
  for (std::size_t k = 0; k < text.size() && k < longest; ++k)
    result += text[k] >= 32 && text[k] < 127 ? text[k] : '?';
  return text.size() > longest ? result + "..." : result;
}

// Receives the parts of a JSON text one by one and puts them together; refuses what is too much,
// and keys that an object has twice, of which the last would count otherwise.
class Json_builder {
public:
  using Json = nlohmann::json;

  Json_builder(const std::string& text, const std::string& name, const Json_limits& limits)
      : text_(text), name_(name), limits_(limits) {}

  Json result() && { return std::move(root_); }

  // what nlohmann::json calls; the names are not ours
  bool null() { return add(nullptr); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(Json::number_integer_t value) { return add(value); }
  bool number_unsigned(Json::number_unsigned_t value) { return add(value); }
  bool number_float(Json::number_float_t value, const std::string&) { return add(value); }
  bool string(std::string& value) { return add(std::move(value)); }
  bool binary(Json::binary_t&) { return false; } // there is none in a text
  bool start_object(std::size_t) { return open(Json::object()); }
  bool start_array(std::size_t) { return open(Json::array()); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool key(std::string& key) {
    if (open_.back()->contains(key))
      fail("the key '" + printable(key) + "' is there twice", path(open_.size() - 1));
    keys_.back() = std::move(key);
    return true;
  }
  // `position` is the number of characters up to the first one that does not fit, this included.
  bool parse_error(std::size_t position, const std::string& token, const std::exception& error) {
    const std::size_t before = (std::min)((std::max)(position, std::size_t(1)) - 1, text_.size());
    const auto here = text_.begin() + static_cast<std::ptrdiff_t>(before);
    const auto line = 1 + std::count(text_.begin(), here, '\n');
    const std::size_t line_end = before == 0 ? std::string::npos : text_.rfind('\n', before - 1);
    const std::size_t column = line_end == std::string::npos ? before + 1 : before - line_end;
    const std::string why = reason(error.what(), token);
    const std::string found = before == text_.size()
                                  ? "the end of the file"
                                  : '\'' + printable(unexpected(before, token, why)) + '\'';
    throw Input_error(name_ + ":" + std::to_string(line) + ": expected JSON, found " + found +
                      " at column " + std::to_string(column) + ": " + printable(why, 90));
  }

private:
  // What the JSON library says about an error, without its prefixes ("[json.exception.parse_error.
  // 101] parse error at line 1, column 2: ") and the token, of which there may be very much.
  static std::string reason(std::string text, const std::string& token) {
    const auto skip = [&](const std::string& start, const std::string& end) {
      const std::size_t at = text.find(end);
      if (text.rfind(start, 0) == 0 && at != std::string::npos)
        text.erase(0, at + end.size());
    };
    skip("[json.exception.", "] ");
    skip("parse error at ", ": ");
    for (const char* words : {"; last read: '", " parsing '"}) {
      const std::string quote = words + token + '\'';
      const std::size_t at = text.find(quote);
      if (at != std::string::npos)
        text.erase(at, quote.size());
    }
    return text;
  }

  // What does not fit, and has been read up to the character at `last`. The token of the library is
  // that only if it is a string; else there may be something before it.
  std::string unexpected(std::size_t last, const std::string& token,
                         const std::string& reason) const {
    if (reason.find("unexpected string") != std::string::npos ||
        reason.find("invalid string") != std::string::npos)
      return token;
    const auto is_in_word = [&](std::size_t k) {
      const char c = text_[k];
      return ('0' <= c && c <= '9') || ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') ||
             c == '+' || c == '-' || c == '.';
    };
    std::size_t begin = last, end = last;
    if (reason.find("unexpected '") == std::string::npos) { // no bracket, comma or colon
      while (begin > 0 && is_in_word(begin - 1))
        --begin;
      while (end < text_.size() && is_in_word(end))
        ++end;
    }
    return text_.substr(begin, (std::max)(end - begin, std::size_t(1)));
  }

  template <typename Value>
  bool add(Value&& value) {
    insert(std::forward<Value>(value));
    return true;
  }
  bool open(Json value) {
    if (open_.size() == limits_.depth)
      fail("expected at most " + std::to_string(limits_.depth) + " levels", "");
    open_.push_back(&insert(std::move(value)));
    keys_.emplace_back();
    return true;
  }
  bool close() {
    open_.pop_back();
    keys_.pop_back();
    return true;
  }

  // Only the last element of a container is ever open, so that pointers to it stay valid.
  Json& insert(Json value) {
    if (++values_ > limits_.values)
      fail("expected at most " + std::to_string(limits_.values) + " values", "");
    if (open_.empty())
      return root_ = std::move(value);
    Json& top = *open_.back();
    if (!top.is_array())
      return top[keys_.back()] = std::move(value);
    top.push_back(std::move(value));
    return top.back();
  }

  // of the container that is open at a level
  std::string path(std::size_t level) const {
    std::string text;
    for (std::size_t k = 0; k < level; ++k)
      text +=
          '/' + (open_[k]->is_array() ? std::to_string(open_[k]->size() - 1) : printable(keys_[k]));
    return text;
  }

  [[noreturn]] void fail(const std::string& message, const std::string& path) const {
    throw Input_error(name_ + ": " + (path.empty() ? "" : path + ": ") + message);
  }

  const std::string &text_, &name_;
  Json_limits limits_;
  Json root_;
  std::vector<Json*> open_;       // from the outermost container to the innermost one
  std::vector<std::string> keys_; // the last one of each, if it is an object
  std::size_t values_ = 0;
};

// Reads all of a stream, if that is not more than the limit.
inline std::string read_all(std::istream& in, const std::string& name, std::size_t limit) {
  std::string text;
  std::vector<char> buffer(1 << 16);
  while (in.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) || in.gcount() > 0) {
    text.append(buffer.data(), static_cast<std::size_t>(in.gcount()));
    if (text.size() > limit)
      throw Input_error(name + ": the file is larger than " + std::to_string(limit) + " bytes");
  }
  if (in.bad())
    throw Input_error(name + ": the file cannot be read");
  return text;
}

// Parses a stream. Throws Input_error that names the file, and the line or the place in the data.
inline nlohmann::json parse_json(std::istream& in, const std::string& name,
                                 const Json_limits& limits) {
  const std::string text = read_all(in, name, limits.size);
  Json_builder builder(text, name, limits);
  nlohmann::json::sax_parse(text, &builder);
  return std::move(builder).result();
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_IO_INTERNAL_PARSE_JSON_H
