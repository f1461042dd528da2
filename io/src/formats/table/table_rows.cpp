/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/table/table_rows.h"

#include "files/tool_error.h"
#include "formats/file_header.h" // for throwTruncated
#include "formats/table/table_layout.h"
#include "formats/table/table_words.h"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace pcl::indoor::tool {
namespace {

using Kind = TableColumn::Kind;

constexpr std::size_t most_columns = 1000;
constexpr const char* two_roles =
    ": commas part the values and the decimals, too; export it with points as "
    "decimals, or with semicolons between the values";

std::vector<bool>
areNumbers(const std::vector<std::string_view>& words)
{
  std::vector<bool> are;
  for (const auto word : words)
    are.push_back(isNumber(word));
  return are;
}

bool
isCount(const std::vector<std::string_view>& words)
{
  return words.size() == 1 && words[0].size() <= 18 &&
         words[0].find_first_not_of("0123456789") == std::string_view::npos;
}

bool
nameThePlace(const std::vector<std::string>& names)
{
  return placeProblem(columnsOf(names).columns).empty();
}

bool
areUnits(const std::vector<std::string_view>& words)
{
  return std::all_of(
      words.begin(), words.end(), [](auto word) { return isUnit(std::string(word)); });
}

/** May a column hold anything, since no result depends on it? */
bool
isFree(const TableColumn& column)
{
  return column.kind == Kind::Real && column.field != "intensity" &&
         column.field.rfind("normal_", 0) != 0;
}

} // namespace

TableRows::TableRows(std::string path, const TableColumns& columns)
: path_(std::move(path))
{
  if (!columns.names.empty())
    option_names_ = listedNames(columns.names);
}

std::string
TableRows::place(std::uint64_t line) const
{
  return path_ + ": line " + std::to_string(line);
}

void
TableRows::refuse(const std::string& problem) const
{
  throw ToolError(place(line_) + problem);
}

void
TableRows::refuseWord(std::string_view word) const
{
  if (word.empty())
    refuse(": a value is missing");
  const auto text = "'" + std::string(word.substr(0, 20)) + "'";
  if (word.find_first_of(" \t") != word.npos)
    refuse(": " + text +
           " is no number; where commas part values, decimals need a point");
  refuse(": " + text + " is not a number");
}

/** Of a header that does not name x, y and z, say what would. */
void
TableRows::refusePlace(const Header& header, const std::vector<bool>& are_numbers) const
{
  const auto columns = columnsOf(header.names).columns;
  const auto problem = placeProblem(columns);
  const bool is_angle = problem.find("angles") != problem.npos;
  const auto proposal = columnsProposal(columns, are_numbers);
  throw ToolError(
      place(header.line) + problem +
      (is_angle ? ""
       : proposal.empty()
           ? ", nor other numbers that could be it; blanks, tabs, commas or "
             "semicolons part them"
           : "; name them, for example -columns " + proposal));
}

/** Bytes that are no text stand in a number or in place of a separator. */
std::string
TableRows::withoutControls(std::string_view line)
{
  if (damaged_lines_++ == 0)
    first_damaged_line_ = line_;
  std::string joined, parted;
  for (const char letter : line) {
    const bool is_control = hasControlCharacter({&letter, 1});
    parted += is_control ? separator_ : letter;
    if (!is_control)
      joined += letter;
  }
  splitLine(joined, separator_, words_);
  return columns_.empty() || words_.size() == columns_.size() ? joined : parted;
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
  parts_.push_back(count);
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
  if (is_comment && columns_.empty()) { // it may name the columns: "//X Y Z R G B"
    line.remove_prefix(std::min(line.find_first_not_of("#/"), line.size()));
    splitLine(line, separatorOf(line), words_);
    if (const auto names = namesOf(words_); nameThePlace(names))
      comment_ = {names, line_};
  }
  if (is_comment || line.empty())
    return;
  std::string cleaned;
  if (hasControlCharacter(line)) {
    cleaned = withoutControls(line);
    line = trimmed(cleaned);
  }
  if (columns_.empty())
    return addBeforeRows(line);
  splitLine(line, separator_, words_);
  if (words_.size() + 1 == columns_.size() && !line.empty() &&
      line.back() == separator_)
    words_.emplace_back(); // an empty value at the end of the line
  if (!has_count_ || !readCount())
    addRow();
}

/** Names, their units, a count, or the first row. */
void
TableRows::addBeforeRows(std::string_view line)
{
  separator_ = separatorOf(line);
  splitLine(line, separator_, words_);
  if (readCount())
    return;
  const auto are_numbers = areNumbers(words_);
  const auto count = static_cast<std::size_t>(
      std::count(are_numbers.begin(), are_numbers.end(), true));
  const bool is_named = !header_.names.empty() && nameThePlace(header_.names);
  if (count < 3 && count < words_.size() && (!is_named || areUnits(words_)))
    return addText();
  chooseColumns();
  addRow();
}

/** A line of words before the rows. */
void
TableRows::addText()
{
  for (const auto word : words_) // "5 2" of "1,5 2,5" is no name
    if (const auto blank = word.find_first_of(" \t");
        blank != word.npos && isNumber(word.substr(0, blank)))
      refuseWord(word);
  const auto names = namesOf(words_);
  auto& known = header_.names;
  if (!known.empty() && areUnits(words_) && names.size() == known.size())
    for (std::size_t c = 0; c < names.size(); ++c)
      known[c] += " [" + names[c] + "]";
  else if (known.empty() || nameThePlace(names))
    header_ = {names, line_};
}

void
TableRows::requireAsMany(std::size_t count, const std::string& what) const
{
  if (words_.size() != count)
    refuse(" has " + std::to_string(words_.size()) + " values, " + what + " " +
           std::to_string(count));
}

/** Of the first row. */
void
TableRows::chooseColumns()
{
  const auto count = words_.size();
  if (count > most_columns)
    refuse(" has " + std::to_string(count) + " values, at most " +
           std::to_string(most_columns) + " are read; lines end in a line feed");
  if (!option_names_.empty())
    takeOption();
  else if (!header_.names.empty())
    takeHeader(header_);
  else if (comment_.names.size() == count)
    takeHeader(comment_);
  else if (count < 3)
    refuse(" has " + std::to_string(count) + " values, a point has at least 3");
  else
    for (const bool is_number : areNumbers(words_)) // the rest is told by all rows
      columns_.push_back({"", is_number ? Kind::Real : Kind::Skipped});
}

void
TableRows::takeOption()
{
  requireAsMany(option_names_.size(),
                "'" + boost::algorithm::join(option_names_, ",") + "' names");
  has_names_ = true;
  columns_ = columnsOf(option_names_).columns;
  if (const auto problem = placeProblem(columns_); !problem.empty())
    throw ToolError(path_ + ": line " + std::to_string(line_) + ": -columns" + problem);
}

void
TableRows::takeHeader(Header header)
{
  const auto count = header.names.size();
  if (words_.size() > count && separator_ == ',' &&
      std::all_of(words_.begin(), words_.end(), isWhole))
    refuse(two_roles);
  if (words_.size() == count + 1 && !isNumber(words_[0])) // names of rows have no name
    header.names.insert(header.names.begin(), "_");
  requireAsMany(header.names.size(), "line " + std::to_string(header.line) + " names");
  const auto named = columnsOf(header.names);
  if (!placeProblem(named.columns).empty())
    refusePlace(header, areNumbers(words_));
  has_names_ = true;
  are_names_plain_ = named.are_plain;
  units_ = named.units;
  columns_ = named.columns;
}

/** Is a word a number, with the decimals of the others? */
bool
TableRows::readWord(std::string_view word, double& value)
{
  const bool has_point = readNumber(word, value);
  if (has_point && decimal_ == '.')
    return true;
  if (!has_point && !readNumber(word, value, ','))
    return false;
  const char decimal = !has_point ? ',' : word.find('.') != word.npos ? '.' : decimal_;
  if (decimal_ != '\0' && decimal != decimal_)
    refuse(
        ": '" + std::string(word.substr(0, 20)) +
        "' has another decimal sign than numbers before; points and commas are mixed");
  decimal_ = decimal;
  return true;
}

/** A value of the row; of a column without numbers, which is left out from now on, it
 * does not matter. */
double
TableRows::numberOf(std::size_t column)
{
  auto& about = columns_[column];
  const auto word = words_[column];
  double value = 0;
  if (about.kind == Kind::Skipped || readWord(word, value))
    return value;
  if (!has_names_ || !option_names_.empty() || !isFree(about))
    refuseWord(word);
  if (word.empty())
    return std::numeric_limits<double>::quiet_NaN();
  left_out_.push_back("'" + about.field + "'");
  about.kind = Kind::Skipped;
  return value;
}

void
TableRows::requireFitting(const TableColumn& column,
                          std::string_view word,
                          double value) const
{
  if (column.kind == Kind::Color && !(value >= 0 && value <= 65535))
    refuse(": the colour '" + std::string(word.substr(0, 20)) +
           "' is not a number of 0 to 65535");
  constexpr double largest = std::numeric_limits<std::uint32_t>::max();
  if (column.kind == Kind::Label &&
      !(value >= 0 && value <= largest && value == std::floor(value)))
    refuse(": the label '" + std::string(word.substr(0, 20)) +
           "' is not a whole number of 0 to 4294967295");
}

void
TableRows::addRow()
{
  if (words_.size() != columns_.size())
    refuse(" has " + std::to_string(words_.size()) + " values, the rows before have " +
           std::to_string(columns_.size()) +
           (separator_ == ',' && decimal_ == '\0' &&
                    std::all_of(words_.begin(), words_.end(), isWhole)
                ? "; commas must not part decimals, too"
                : ""));
  if (has_count_ && rows_ == promised_)
    refuse(": a point more than the " + std::to_string(promised_) +
           " that the file promises");
  for (std::size_t c = 0; c < words_.size(); ++c) {
    const double value = numberOf(c);
    requireFitting(columns_[c], words_[c], value);
    values_.push_back(value);
    if (!has_names_ && c > 0 && fraction_line_ == 0 && words_[c].size() > 1 &&
        words_[c][0] == '0' && isWhole(words_[c]))
      fraction_line_ = line_;
  }
  ++rows_;
}

void
TableRows::finish()
{
  if (has_count_ && rows_ < promised_)
    throwTruncated(path_, promised_, rows_, "points");
  if (rows_ == 0 && !header_.names.empty() && !nameThePlace(header_.names))
    refusePlace(header_, {});
  if (rows_ == 0)
    throw ToolError(path_ + ": the cloud is empty (0 points)");
  if (separator_ == ',' && decimal_ == '\0' && fraction_line_ > 0)
    throw ToolError(place(fraction_line_) + two_roles);
  if (!has_names_)
    columns_ = columnsByValues(columns_, values_);
  makeNotes(scaleColors(columns_, values_));
}

/** \param[in] scaled what was done to colours */
void
TableRows::makeNotes(const std::string& scaled)
{
  const bool are_known = !option_names_.empty() || (has_names_ && are_names_plain_) ||
                         (!has_names_ && columns_.size() == 3);
  auto mirrored = columns_;
  for (auto& column : mirrored)
    if (column.kind == Kind::Coordinate && column.field != "z")
      column.field = column.field == "x" ? "y" : "x";
  // lists of surveyors have northing first
  const bool is_list = !has_names_ && columns_[0].kind == Kind::Skipped;
  if (!are_known)
    notes_.push_back(
        "its columns are taken as " + listOf(columns_) +
        (scaled.empty() ? "" : ", with " + scaled) + "; -columns says otherwise" +
        (is_list ? ", for example " + listOf(mirrored) + " where northing comes first"
                 : ""));
  else if (!scaled.empty())
    notes_.push_back("it has " + scaled);
  if (option_names_.empty() && !has_names_ && isFirstLikeTime(columns_, values_)) {
    auto timed = columns_;
    std::rotate(timed.begin(), timed.begin() + 3, timed.begin() + 4);
    timed[0] = {"", Kind::Skipped};
    notes_.push_back("its first column rises and never falls: if it is a time, set "
                     "-columns " +
                     listOf(timed));
  }
  if (!left_out_.empty())
    notes_.push_back("columns without numbers are left out: " +
                     boost::algorithm::join(left_out_, ", "));
  if (decimal_ == ',')
    notes_.emplace_back("its decimals have commas");
  if (damaged_lines_ > 0)
    notes_.push_back("control characters are left out in line " +
                     std::to_string(first_damaged_line_) +
                     (damaged_lines_ > 1
                          ? " and " + std::to_string(damaged_lines_ - 1) + " more"
                          : ""));
  if (const auto note = unitNote(units_); !note.empty())
    notes_.push_back(note);
}

} // namespace pcl::indoor::tool
