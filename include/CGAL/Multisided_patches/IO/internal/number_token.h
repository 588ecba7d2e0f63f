// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_MULTISIDED_PATCHES_IO_INTERNAL_NUMBER_TOKEN_H
#define CGAL_MULTISIDED_PATCHES_IO_INTERNAL_NUMBER_TOKEN_H

#include <charconv>
#include <cstddef>
#include <string>
#include <system_error>

namespace CGAL {
namespace Multisided_patches {
namespace internal {

// What readers of text files share: a token is what stands between white space.

// Longer tokens are no numbers; readers hold no more than this of a token, whatever the file.
constexpr std::size_t max_token_length = 64;

inline bool is_space(int c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

// Adds a character to a token, in a form that error messages can show. False if it is too long.
inline bool append_to_token(std::string& token, int c) {
  token += c >= 32 && c < 127 ? static_cast<char>(c) : '?';
  return token.size() <= max_token_length;
}

// The start of a token that is too long, for an error message.
inline std::string start_of_token(const std::string& token) {
  return token.substr(0, 20) + "...";
}

// Whether the whole token is a number that `Number` can hold. The locale has no effect.
template <typename Number>
bool parse_number(const std::string& token, Number& value) {
  // from_chars knows no plus sign; what follows one must not be a second sign.
  const bool plus = token.size() > 1 && token[0] == '+' && token[1] != '-';
  const char* first = token.data() + (plus ? 1 : 0);
  const char* last = token.data() + token.size();
  const auto [end, error] = std::from_chars(first, last, value);
  return error == std::errc() && end == last;
}

} // namespace internal
} // namespace Multisided_patches
} // namespace CGAL

#endif // CGAL_MULTISIDED_PATCHES_IO_INTERNAL_NUMBER_TOKEN_H
