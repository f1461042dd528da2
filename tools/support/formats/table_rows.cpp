/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/table_rows.h"

#include "command_line/options.h" // for ToolError
#include "formats/file_header.h"  // for throwTruncated

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace pcl::indoor::tool {
namespace {

constexpr std::string_view blanks = " \t\r";
constexpr std::size_t most_columns = 1000;

std::string_view
trimmed(std::string_view text)
{
  const auto begin = text.find_first_not_of(blanks);
  if (begin == text.npos)
    return {};
  return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

bool
isCount(const std::vector<std::string_view>& words)
{
  return words.size() == 1 && words[0].size() <= 18 &&
         words[0].find_first_not_of("0123456789") == std::string_view::npos;
}

/** Digits, a comma and digits. */
bool
hasDecimalComma(std::string_view word)
{
  const auto comma = word.find(',');
  double value = 0;
  return comma != word.npos && comma > 0 && comma + 1 < word.size() &&
         readNumber(word.substr(0, comma), value) &&
         std::isdigit(static_cast<unsigned char>(word[comma + 1])) != 0;
}

bool
areNumbers(const std::vector<std::string_view>& words)
{
  double value = 0;
  return std::all_of(
      words.begin(), words.end(), [&](auto word) { return readNumber(word, value); });
}

bool
isWhole(double value, double largest)
{
  return value >= 0 && value <= largest && value == std::floor(value);
}

bool
nameThePlace(const std::vector<std::string>& names)
{
  const auto has = [&names](char axis) {
    return std::any_of(names.begin(), names.end(), [axis](const auto& name) {
      return name.size() == 1 && (name[0] | 0x20) == axis;
    });
  };
  return has('x') && has('y') && has('z');
}

} // namespace

char
separatorOf(std::string_view line)
{
  if (line.find(';') != line.npos)
    return ';';
  return line.find(',') != line.npos ? ',' : ' ';
}

void
splitLine(std::string_view line, char separator, std::vector<std::string_view>& words)
{
  words.clear();
  line = trimmed(line);
  while (!line.empty()) {
    const auto end =
        std::min(separator == ' ' ? line.find_first_of(blanks) : line.find(separator),
                 line.size());
    auto word = trimmed(line.substr(0, end));
    if (word.size() > 1 && word.front() == '"' && word.back() == '"')
      word = word.substr(1, word.size() - 2);
    words.push_back(word);
    line = trimmed(line.substr(std::min(end + 1, line.size())));
  }
}

bool
readNumber(std::string_view word, double& value)
{
  if (!word.empty() && word.front() == '+')
    word.remove_prefix(1);
  const char* const end = word.data() + word.size();
  const auto read = std::from_chars(word.data(), end, value);
  if (read.ptr != end || read.ec == std::errc::invalid_argument || word.empty())
    return false;
  if (read.ec == std::errc::result_out_of_range) // too small or too large for a double
    value = std::strtod(std::string(word).c_str(), nullptr);
  return true;
}

TableRows::TableRows(std::string path, const TableColumns& columns)
: path_(std::move(path))
{
  if (!columns.names.empty())
    option_names_ = listedNames(columns.names);
}

std::string
TableRows::place() const
{
  return path_ + ": line " + std::to_string(line_);
}

void
TableRows::refuse(const std::string& problem) const
{
  throw ToolError(place() + problem);
}

void
TableRows::refuseWord(std::string_view word) const
{
  if (word.empty())
    refuse(": a value is missing");
  const std::string text(word.substr(0, 20));
  if (hasDecimalComma(word) || word.find_first_of(blanks) != word.npos)
    refuse(": '" + text + "' is no number; decimals need a point, not a comma");
  refuse(": '" + text + "' is not a number");
}

/** A comment may name the columns: "//X Y Z R G B". */
void
TableRows::readNames(std::string_view comment)
{
  splitLine(comment, separatorOf(comment), words_);
  const std::vector<std::string> names(words_.begin(), words_.end());
  if (!nameThePlace(names))
    return;
  comment_names_ = names;
  comment_line_ = line_;
}

/** The number of points that follow; there may be several parts. */
bool
TableRows::readCount()
{
  if (!isCount(words_) || (has_count_ ? rows_ != promised_ || rows_ == 0 : rows_ > 0))
    return false;
  std::uint64_t count = 0;
  std::from_chars(words_[0].data(), words_[0].data() + words_[0].size(), count);
  promised_ += count;
  has_count_ = true;
  return true;
}

void
TableRows::add(std::string_view line)
{
  if (++line_ == 1 && line.substr(0, 3) == "\xef\xbb\xbf")
    line.remove_prefix(3);
  line = trimmed(line);
  const bool is_comment = line.substr(0, 1) == "#" || line.substr(0, 2) == "//";
  if (is_comment && columns_.empty())
    readNames(line.substr(std::min(line.find_first_not_of("#/"), line.size())));
  if (is_comment || line.empty())
    return;
  if (columns_.empty())
    return addFirstRow(line);
  splitLine(line, separator_, words_);
  if (words_.size() + 1 == columns_.size() && line.back() == separator_)
    words_.emplace_back(); // an empty value at the end of the line
  if (!has_count_ || !readCount())
    addRow();
}

/** A line before the first row: names, a count, or that row itself. */
void
TableRows::addFirstRow(std::string_view line)
{
  separator_ = separatorOf(line);
  splitLine(line, separator_, words_);
  if (readCount())
    return;
  if (!areNumbers(words_) && !has_names_ &&
      (!has_count_ || nameThePlace({words_.begin(), words_.end()}))) {
    double value = 0;
    for (const auto word : words_) { // "5 2" of "1,5 2,5" is no name
      const auto blank = word.find_first_of(blanks);
      const bool has_both =
          blank != word.npos && readNumber(word.substr(0, blank), value);
      if (hasDecimalComma(word) || has_both)
        refuseWord(word);
    }
    header_names_.assign(words_.begin(), words_.end());
    header_line_ = line_;
    has_names_ = true;
    if (option_names_.empty())
      columnsOf(header_names_, place());
    return;
  }
  const std::size_t count = words_.size();
  const auto values = " has " + std::to_string(count) + " values, ";
  if (count > most_columns)
    refuse(values + "at most " + std::to_string(most_columns) + " are read");
  const auto requireAsMany = [&](const auto& names, const std::string& where) {
    if (names.size() != count)
      refuse(values + where + " names " + std::to_string(names.size()));
  };
  if (!option_names_.empty()) {
    requireAsMany(option_names_,
                  "'" + boost::algorithm::join(option_names_, ",") + "'");
    columns_ = columnsOf(option_names_, "-columns: it");
  }
  else if (has_names_) {
    requireAsMany(header_names_, "line " + std::to_string(header_line_));
    columns_ =
        columnsOf(header_names_, path_ + ": line " + std::to_string(header_line_));
  }
  else if (comment_names_.size() == count)
    columns_ =
        columnsOf(comment_names_, path_ + ": line " + std::to_string(comment_line_));
  else if (count < 3)
    refuse(values + "a point has at least 3");
  else
    columns_.assign(count, {"", TableColumn::Kind::Real}); // until all rows are known
  addRow();
}

void
TableRows::addRow()
{
  if (words_.size() != columns_.size())
    refuse(" has " + std::to_string(words_.size()) + " values, the rows before have " +
           std::to_string(columns_.size()));
  if (has_count_ && rows_ == promised_)
    refuse(": a point more than the " + std::to_string(promised_) +
           " that the file promises");
  for (std::size_t c = 0; c < words_.size(); ++c) {
    const auto kind = columns_[c].kind;
    double value = 0;
    if (kind != TableColumn::Kind::Skipped && !readNumber(words_[c], value))
      refuseWord(words_[c]);
    const bool is_color = isWhole(value, 255);
    if (kind == TableColumn::Kind::Color && !is_color)
      refuse(": the colour '" + std::string(words_[c].substr(0, 20)) +
             "' is not a whole number of 0 to 255");
    if (kind == TableColumn::Kind::Label && !isWhole(value, 4294967295.0))
      refuse(": the label '" + std::string(words_[c].substr(0, 20)) +
             "' is not a whole number of 0 to 4294967295");
    if (c >= 3 && c + 3 >= words_.size())
      could_be_colors_ = could_be_colors_ && is_color;
    values_.push_back(value);
  }
  ++rows_;
}

void
TableRows::finish()
{
  if (has_count_ && rows_ < promised_)
    throwTruncated(path_, promised_, rows_, "points");
  if (rows_ == 0)
    throw ToolError(path_ + ": the cloud is empty (0 points)");
  if (columns_[0].field.empty() && columns_[1].field.empty() &&
      columns_[2].field.empty())
    columns_ = columnsByNumber(columns_.size(), could_be_colors_);
}

} // namespace pcl::indoor::tool
