/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <algorithm>
#include <charconv>
#include <string_view>
#include <system_error>
#include <vector>

namespace pcl::indoor::tool {

/** \brief The words of a line, between blanks, tabs and ends of lines. */
inline void
splitWords(std::string_view line, std::vector<std::string_view>& words)
{
  constexpr std::string_view gaps = " \t\r\n";
  words.clear();
  for (auto begin = line.find_first_not_of(gaps); begin != line.npos;) {
    const auto end = std::min(line.find_first_of(gaps, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(gaps, end);
  }
}

/** \brief Read a number that is all of a word, perhaps behind a plus.
 * \return whether it is one, and in the range of its type; if not, \a value may have
 * changed
 */
template <typename T>
bool
readWord(std::string_view word, T& value)
{
  if (!word.empty() && word.front() == '+')
    word.remove_prefix(1);
  const char* const end = word.data() + word.size();
  const auto read = std::from_chars(word.data(), end, value);
  return read.ec == std::errc() && read.ptr == end;
}

} // namespace pcl::indoor::tool
