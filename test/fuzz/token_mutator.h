// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTISIDED_PATCHES_TEST_FUZZ_TOKEN_MUTATOR_H
#define MULTISIDED_PATCHES_TEST_FUZZ_TOKEN_MUTATOR_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

// Changes files of numbers number by number. Changing bytes alone hardly ever gives another valid
// .cgb file, as the sides of a patch must still meet: the same number stands in several places.
namespace fuzz {

class Token_mutator {
public:
  Token_mutator(const std::string& bytes, unsigned seed) : random_(seed) {
    // Every token keeps the white space that follows it.
    for (std::size_t begin = 0; begin < bytes.size();) {
      const std::size_t space = (std::min)(bytes.find_first_of(spaces, begin), bytes.size());
      const std::size_t end = (std::min)(bytes.find_first_not_of(spaces, space), bytes.size());
      tokens_.push_back({bytes.substr(begin, space - begin), bytes.substr(space, end - space)});
      begin = end;
    }
  }

  std::string mutated() {
    if (tokens_.empty())
      return number() + '\n';
    const std::size_t k = index(tokens_.size());
    const std::string text = tokens_[k].text;
    switch (index(8)) {
    case 0:
      repeat(k, 1 + index(4));
      break;
    case 1:
      tokens_.erase(iterator(k), iterator((std::min)(k + 1 + index(4), tokens_.size())));
      break;
    case 2:
      tokens_[k].text = number();
      break;
    case 3:
      std::swap(tokens_[k].text, tokens_[index(tokens_.size())].text);
      break;
    case 4:
      tokens_[k].text = changed(text);
      break;
    case 5:
      scale(exponent());
      break;
    default: // the same number wherever it stands, so that what met still meets
      replace_all(text, index(3) == 0 ? number() : changed(text));
    }
    return joined();
  }

private:
  struct Token {
    std::string text, space;
  };
  static constexpr const char* spaces = " \t\n\v\f\r";

  std::size_t index(std::size_t n) { return random_() % n; }
  std::vector<Token>::iterator iterator(std::size_t k) {
    return tokens_.begin() + static_cast<std::ptrdiff_t>(k);
  }

  // Numbers at which computations are likely to go wrong, and some that are harmless.
  std::string number() {
    static const char* const numbers[] = {
        "0",     "1",      "2",      "3",       "-1",     "-0",     "0.5",     "100",
        "1000",  "5e-324", "1e-308", "1e-160",  "1e-152", "2e-152", "1e-77",   "1e-9",
        "1e-16", "1e77",   "1e152",  "0.9e152", "1e154",  "1e300",  "1e308",   "-1e308",
        "nan",   "inf",    "1e999",  "+1",      "4",      "0.1",    "50",      "51",
        "101",   "1e15",   "1e16",   "1e-10",   "1e-8",   "-1e-9",  "0.1e-15", "1.0000001"};
    return numbers[index(std::size(numbers))];
  }

  // The same with one byte changed, or as the engine likes, which knows a dictionary.
  std::string changed(std::string text) {
    if (index(2) == 0 && !text.empty()) {
      text[index(text.size())] = "0123456789.-+e"[index(14)];
      return text;
    }
    const std::size_t size = text.size(), max_size = 40;
    text.resize((std::max)(size, max_size));
    auto* const data = reinterpret_cast<std::uint8_t*>(&text[0]);
    text.resize(LLVMFuzzerMutate(data, size, text.size()));
    return text;
  }

  std::string exponent() {
    static const char* const exponents[] = {"e-300", "e-160", "e-150", "e-76", "e-9",
                                            "e9",    "e76",   "e150",  "e160", "e300"};
    return exponents[index(std::size(exponents))];
  }

  void repeat(std::size_t k, std::size_t length) {
    const std::vector<Token> part(iterator(k), iterator((std::min)(k + length, tokens_.size())));
    tokens_.insert(iterator(k), part.begin(), part.end());
  }

  // Numbers with a decimal point are lengths, the others may say how many numbers follow.
  void scale(const std::string& factor) {
    for (Token& token : tokens_)
      if (token.text.find('.') != std::string::npos)
        token.text += factor;
  }

  void replace_all(const std::string& from, const std::string& to) {
    for (Token& token : tokens_)
      if (token.text == from)
        token.text = to;
  }

  std::string joined() const {
    std::string bytes;
    for (const Token& token : tokens_)
      bytes += token.text + token.space;
    return bytes;
  }

  std::mt19937 random_;
  std::vector<Token> tokens_;
};

// What LLVMFuzzerCustomMutator does for files of numbers.
inline std::size_t mutate_tokens(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                 unsigned seed) {
  if (seed % 3 == 0)
    return LLVMFuzzerMutate(data, size, max_size);
  const std::string bytes = Token_mutator(std::string(data, data + size), seed).mutated();
  const std::size_t new_size = (std::min)(bytes.size(), max_size);
  std::memcpy(data, bytes.data(), new_size);
  return new_size;
}

} // namespace fuzz

#endif // MULTISIDED_PATCHES_TEST_FUZZ_TOKEN_MUTATOR_H
