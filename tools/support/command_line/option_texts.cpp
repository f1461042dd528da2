/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/options.h"

#include <algorithm>
#include <numeric>

namespace pcl::indoor::tool {
namespace {

/** Letters to insert, remove or change to make one word the other (Levenshtein). */
std::size_t
editDistance(const std::string& one, const std::string& two)
{
  std::vector<std::size_t> row(two.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (std::size_t i = 0; i < one.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < two.size(); ++j) {
      const std::size_t changed = diagonal + (one[i] == two[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

} // namespace

std::string
OptionParser::suggestion(const std::string& argument)
{
  const auto equals = argument.find('=');
  std::string name = argument.substr(0, equals);
  name = "-" + name.substr(std::min(name.find_first_not_of('-'), name.size()));
  std::replace(name.begin() + 1, name.end(), '-', '_');
  const std::string value =
      equals == argument.npos ? "" : " " + argument.substr(equals + 1);
  if (find(name) != nullptr)
    return "write " + name + value;
  std::size_t least = std::min<std::size_t>(2, name.size() / 3) + 1;
  std::string nearest;
  for (const auto& option : options_) {
    const auto distance = editDistance(name, option.name);
    if (distance < least) {
      least = distance;
      nearest = option.name;
    }
  }
  return nearest.empty() ? "-h lists the known ones" : "did you mean " + nearest + "?";
}

std::string
OptionParser::usage() const
{
  std::string syntax = "Syntax is: " + program_;
  std::string lines;
  const auto add = [&](const std::string& name, const std::string& meaning) {
    syntax += " " + name;
    lines += "  " + name + " = " + meaning + "\n";
  };
  for (std::size_t i = 0; i <= positionals_.size(); ++i) {
    if (rest_variable_ != nullptr && i == before_rest_)
      add(rest_.name + " ...", rest_.meaning);
    if (i < positionals_.size())
      add(positionals_[i].name, positionals_[i].meaning);
  }
  std::string text = summary_ + "\n\n" + syntax + " <options>\n\n" + lines;
  text += "  where options are:\n";
  const auto is_expert = [](const Option& option) { return option.expert; };
  for (const auto& option : options_)
    if (!option.expert && option.name != "-quiet")
      text += line(option);
  text += line(options_.front()); // -quiet
  text += "    -h = show this text\n    --version = show the version\n";
  if (std::any_of(options_.begin(), options_.end(), is_expert))
    text += "  and, for experts, whose defaults suit most scans:\n";
  for (const auto& option : options_)
    if (option.expert)
      text += line(option);
  return text;
}

std::string
OptionParser::line(const Option& option)
{
  std::string text = "    " + option.name;
  text += option.placeholder.empty() ? "" : " " + option.placeholder;
  text += " = " + option.meaning;
  text += option.range.empty() ? "" : ", " + option.range;
  text += option.placeholder.empty() ? "" : " (default: " + option.default_value + ")";
  return text + "\n";
}

std::vector<Setting>
OptionParser::settings() const
{
  std::vector<Setting> settings;
  for (const auto& option : options_)
    if (option.name != "-quiet" && option.name != "-check" &&
        option.name != "-threads" && option.name != "-memory_limit" &&
        option.name != "-single_process")
      settings.push_back({option.name, option.value(), option.unit, option.kind});
  return settings;
}

std::string
OptionParser::values() const
{
  std::string text;
  for (const auto& setting : settings())
    text += (text.empty() ? "" : ", ") + setting.name + " " + setting.value +
            (setting.unit.empty() ? "" : " " + setting.unit);
  return text;
}

} // namespace pcl::indoor::tool
