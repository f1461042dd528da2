/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <algorithm>
#include <cctype>
#include <random>
#include <string>
#include <vector>

namespace pcl::indoor::fuzz {

using Random = std::mt19937;

/** \brief A number below \a end; 0 if that is 0. */
inline std::size_t
below(Random& random, std::size_t end)
{
  return end == 0 ? 0 : random() % end;
}

/** \brief Replace the number that stands at or after a place by one that readers may
 * not expect. */
inline void
replaceNumber(std::string& bytes, Random& random)
{
  static const std::vector<std::string> numbers = {"0",          "-1",
                                                   "1",          "2",
                                                   "3",          "255",
                                                   "256",        "65536",
                                                   "2147483647", "-2147483648",
                                                   "4294967295", "1e9",
                                                   "1e20",       "1e308",
                                                   "1e-308",     "nan",
                                                   "inf",        "-inf",
                                                   "1e999",      "0x10",
                                                   "9999999999", "18446744073709551616",
                                                   "0.5",        "1000000",
                                                   "",           "1,5"};
  const auto is_digit = [](char letter) {
    return std::isdigit(static_cast<unsigned char>(letter)) != 0;
  };
  std::size_t begin = below(random, bytes.size());
  while (begin < bytes.size() && !is_digit(bytes[begin]))
    ++begin;
  std::size_t end = begin;
  while (end < bytes.size() && (is_digit(bytes[end]) || bytes[end] == '.'))
    ++end;
  bytes.replace(begin, end - begin, numbers[below(random, numbers.size())]);
}

/** \brief Replace a word in quotes by another one, of the same file or another. */
inline void
replaceWord(std::string& bytes, const std::string& other, Random& random)
{
  const auto word = [&random](const std::string& text, std::size_t& begin) {
    begin = text.find('"', below(random, text.size()));
    const auto end = begin == text.npos ? begin : text.find('"', begin + 1);
    return end == text.npos ? "" : text.substr(begin, end + 1 - begin);
  };
  std::size_t to = 0, from = 0;
  const auto old_word = word(bytes, to), new_word = word(other, from);
  if (!old_word.empty())
    bytes.replace(to, old_word.size(), new_word);
}

/** \brief Let a file begin as one of another kind does. */
inline void
replaceBeginning(std::string& bytes, Random& random)
{
  static const std::vector<std::string> beginnings = {
      "LASF", "ASTM-E57", "\x1f\x8b", "PK\x03\x04", "1 2 3\n", "ply\n", "OFF\n", "#"};
  bytes.replace(0,
                std::min<std::size_t>(bytes.size(), below(random, 20)),
                beginnings[below(random, beginnings.size())]);
}

/** \brief Change a file's bytes in one random way.
 * \param[in] other a file of the same kind, to take a piece of
 */
inline void
mutateOnce(std::string& bytes, const std::string& other, Random& random)
{
  const std::size_t at = below(random, bytes.size());
  const std::size_t length = 1 + below(random, 64);
  switch (below(random, 50) == 0 ? 9 : below(random, 9)) {
  case 0: // one bit
    if (!bytes.empty())
      bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(random, 8)));
    break;
  case 1: // a byte with a meaning
    if (!bytes.empty())
      bytes[at] = "\0\xff\x7f\x80\n -.\"{[1"[below(random, 12)];
    break;
  case 2:
    bytes.resize(at);
    break;
  case 3:
    bytes.erase(at, length);
    break;
  case 4:
    bytes.insert(at, bytes.substr(at, length));
    break;
  case 5:
    bytes.insert(at, other.substr(below(random, other.size()), length));
    break;
  case 6: // four bytes at once, as counts are stored
    for (std::size_t i = at; i < at + 4 && i < bytes.size(); ++i)
      bytes[i] = static_cast<char>(random());
    break;
  case 9:
    replaceBeginning(bytes, random);
    break;
  default:
    replaceNumber(bytes, random);
  }
}

/** \brief Change a file's bytes in one to eight random ways; every third file only one
 * number or word of it, by which it keeps its form. */
inline std::string
mutated(std::string bytes, const std::string& other, Random& random)
{
  if (below(random, 3) == 0) {
    if (below(random, 2) == 0)
      replaceNumber(bytes, random);
    else
      replaceWord(bytes, other, random);
    return bytes;
  }
  for (std::size_t left = 1 + below(random, 8); left > 0; --left)
    mutateOnce(bytes, other, random);
  return bytes;
}

} // namespace pcl::indoor::fuzz
