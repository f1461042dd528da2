/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/table/table_words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <string>

namespace pcl::indoor::tool {
namespace {

constexpr std::string_view blanks = " \t\r";

bool
isDigit(char letter)
{
  return std::isdigit(static_cast<unsigned char>(letter)) != 0;
}

/** "1,5 2,25 3,5": three numbers or more, one of them with a decimal comma. */
bool
areDecimals(std::string_view line)
{
  std::vector<std::string_view> words;
  splitLine(line, ' ', words);
  return words.size() >= 3 && std::all_of(words.begin(), words.end(), isNumber);
}

/** "Point 1 <tab> 2.5 <tab> X (m)": three words or more, one of them with a blank that
 * does not part two numbers. */
bool
hasBlanksBetweenTabs(std::string_view line)
{
  std::vector<std::string_view> words, parts;
  splitLine(line, '\t', words);
  return words.size() >= 3 &&
         std::any_of(words.begin(), words.end(), [&parts](std::string_view word) {
           splitLine(word, ' ', parts);
           return parts.size() > 1 &&
                  !std::all_of(parts.begin(), parts.end(), isNumber);
         });
}

/** Where the word that a line begins with ends. */
std::size_t
endOfWord(std::string_view line, char separator)
{
  const auto quote = line.front() == '"' ? line.find('"', 1) : std::string_view::npos;
  const auto from = quote == line.npos ? 0 : quote;
  return std::min(separator == ' ' ? line.find_first_of(blanks, from)
                                   : line.find(separator, from),
                  line.size());
}

/** The value of a number that no double is near, whatever the locale of the program. */
double
zeroOrInfinite(std::string_view word)
{
  std::istringstream stream{std::string(word)};
  stream.imbue(std::locale::classic());
  double value = 0;
  stream >> value; // of too large ones the largest double
  const bool is_large = std::abs(value) == std::numeric_limits<double>::max();
  return is_large ? std::copysign(std::numeric_limits<double>::infinity(), value)
                  : value;
}

bool
readWithPoint(std::string_view word, double& value)
{
  if (!word.empty() && word.front() == '+')
    word.remove_prefix(1);
  const char* const end = word.data() + word.size();
  const auto read = std::from_chars(word.data(), end, value);
  if (read.ptr != end || read.ec == std::errc::invalid_argument || word.empty())
    return false;
  if (read.ec == std::errc::result_out_of_range) // too small or too large for a double
    value = zeroOrInfinite(word);
  return true;
}

} // namespace

char
separatorOf(std::string_view line)
{
  if (line.find(';') != line.npos)
    return ';';
  if (line.find(',') != line.npos)
    return areDecimals(line) ? ' ' : ',';
  return line.find('\t') != line.npos && hasBlanksBetweenTabs(line) ? '\t' : ' ';
}

void
splitLine(std::string_view line, char separator, std::vector<std::string_view>& words)
{
  words.clear();
  line = trimmed(line);
  while (!line.empty()) {
    const auto end = endOfWord(line, separator);
    auto word = trimmed(line.substr(0, end));
    if (word.size() > 1 && word.front() == '"' && word.back() == '"')
      word = word.substr(1, word.size() - 2);
    words.push_back(word);
    line.remove_prefix(std::min(end + 1, line.size()));
    if (separator != '\t') // between tabs a value may be missing
      line = trimmed(line);
  }
}

bool
readNumber(std::string_view word, double& value, char decimal)
{
  if (decimal == '.')
    return readWithPoint(word, value);
  std::array<char, 64> letters; // longer than any number that is written
  const auto comma = word.find(',');
  if (comma == word.npos || word.find('.') != word.npos || word.size() > letters.size())
    return false;
  if (comma == 0 || comma + 1 == word.size() || !isDigit(word[comma - 1]) ||
      !isDigit(word[comma + 1]))
    return false;
  std::copy(word.begin(), word.end(), letters.begin());
  letters[comma] = '.';
  return readWithPoint({letters.data(), word.size()}, value);
}

bool
isNumber(std::string_view word)
{
  double value = 0;
  return readNumber(word, value) || readNumber(word, value, ',');
}

bool
isWhole(std::string_view word)
{
  return !word.empty() &&
         word.find_first_not_of("0123456789", word.front() == '-') == word.npos;
}

std::vector<std::string>
namesOf(const std::vector<std::string_view>& words)
{
  std::vector<std::string> names;
  bool is_open = false;
  for (const auto word : words) {
    const bool opens = word.find_first_of("[(") == 0;
    if (!names.empty() && (opens || is_open))
      names.back() += " " + std::string(word);
    else
      names.emplace_back(word);
    is_open = word.find_last_of("[(") != word.npos
                  ? word.find_first_of("])", word.find_last_of("[(")) == word.npos
                  : is_open && word.find_first_of("])") == word.npos;
  }
  return names;
}

std::string_view
trimmed(std::string_view text)
{
  const auto begin = text.find_first_not_of(blanks);
  if (begin == text.npos)
    return {};
  return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

bool
hasControlCharacter(std::string_view line)
{
  return std::any_of(line.begin(), line.end(), [](char letter) {
    return (static_cast<unsigned char>(letter) < 0x20 && letter != '\t' &&
            letter != '\r') ||
           letter == 0x7f;
  });
}

} // namespace pcl::indoor::tool
