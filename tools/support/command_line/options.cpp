/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/options.h"

#include "formats/reader_threads.h"
#include "text/number_text.h"
#include "text/printable.h"

#include <pcl/console/print.h>
#include <pcl/pcl_config.h> // for the version of PCL

#include <algorithm>
#include <cassert>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <type_traits>

namespace pcl::indoor::tool {
namespace {

bool
looksLikeOption(const std::string& argument)
{
  return argument.size() > 1 && argument[0] == '-' &&
         (std::isalpha(static_cast<unsigned char>(argument[1])) != 0 ||
          argument[1] == '-');
}

template <typename T>
T
readNumber(const std::string& name, const std::string& text, const Range& range)
{
  const std::string lead = name + ": '" + text + "' ";
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto as_real = std::from_chars(text.data(), end, value);
  if (as_real.ec == std::errc::result_out_of_range)
    throw ToolError(lead + "is out of range");
  if (as_real.ec != std::errc() || as_real.ptr != end || !std::isfinite(value))
    throw ToolError(lead + "is not a number");
  if (!range.contains(value))
    throw ToolError(lead + "is out of range, it must be " + range.text());
  if constexpr (std::is_integral_v<T>) {
    T whole = 0;
    const auto as_whole = std::from_chars(text.data(), end, whole);
    if (as_whole.ec == std::errc::result_out_of_range ||
        (std::is_unsigned_v<T> && value < 0.0))
      throw ToolError(lead + "is out of range");
    if (as_whole.ec != std::errc() || as_whole.ptr != end)
      throw ToolError(lead + "is not a whole number");
    return whole;
  }
  else {
    const T number = static_cast<T>(value);
    if (!std::isfinite(number) || !range.contains(number))
      throw ToolError(lead + "is out of range");
    return number;
  }
}

bool
asksForVersion(const std::string& argument)
{
  return argument == "--version" || argument == "-version";
}

int
report(const std::string& program, const std::string& message)
{
  printComplaint(program, message);
  return EXIT_FAILURE;
}

} // namespace

bool
Range::contains(double value) const
{
  return (without_lowest ? value > lowest : value >= lowest) && value <= highest;
}

std::string
Range::text() const
{
  const bool below = std::isfinite(highest);
  if (!std::isfinite(lowest))
    return below ? "at most " + numberText(highest) : "";
  if (!below)
    return (without_lowest ? "greater than " : "at least ") + numberText(lowest);
  return (without_lowest ? "greater than " : "from ") + numberText(lowest) +
         (without_lowest ? " and at most " : " to ") + numberText(highest);
}

OptionParser::OptionParser(std::string program, std::string summary)
: program_(std::move(program))
, summary_(std::move(summary))
{
  flag("-quiet", quiet_, "show no progress");
}

OptionParser&
OptionParser::positional(const std::string& name,
                         std::string& variable,
                         const std::string& meaning)
{
  positionals_.push_back({name, meaning, &variable});
  return *this;
}

OptionParser&
OptionParser::positionals(const std::string& name,
                          std::vector<std::string>& variable,
                          const std::string& meaning,
                          std::size_t at_least)
{
  rest_ = {name, meaning, nullptr};
  rest_variable_ = &variable;
  rest_at_least_ = at_least;
  before_rest_ = positionals_.size();
  return *this;
}

template <typename T>
OptionParser&
OptionParser::number(const std::string& name,
                     T& variable,
                     const std::string& meaning,
                     const std::string& unit,
                     const Range& range)
{
  Option option;
  option.name = name;
  option.placeholder = "X";
  option.meaning = meaning + (unit.empty() ? "" : ", " + unit);
  option.range = range.text();
  option.default_value = numberText(variable);
  option.read = [name, range, &variable](const std::string& text) {
    variable = readNumber<T>(name, text, range);
  };
  option.value = [&variable] { return numberText(variable); };
  option.unit = unit;
  option.kind = Setting::Kind::Number;
  options_.push_back(std::move(option));
  return *this;
}

OptionParser&
OptionParser::text(const std::string& name,
                   std::string& variable,
                   const std::string& meaning,
                   const std::vector<std::string>& choices,
                   const std::function<void(const std::string&)>& others)
{
  std::string listed;
  for (const auto& choice : choices)
    listed += (listed.empty() ? "" : "|") + choice;
  Option option;
  option.name = name;
  option.placeholder = choices.empty() ? "TEXT" : listed;
  option.choices = choices;
  option.meaning = meaning;
  option.default_value = variable.empty() ? "none" : variable;
  option.read = [name, choices, listed, others, &variable](const std::string& text) {
    if (text.empty())
      throw ToolError(name + ": the value is empty");
    if (!choices.empty() &&
        std::find(choices.begin(), choices.end(), text) == choices.end()) {
      if (!others)
        throw ToolError(name + ": '" + text + "' is not one of " + listed);
      others(text);
    }
    variable = text;
  };
  option.value = [&variable] { return variable.empty() ? "none" : variable; };
  options_.push_back(std::move(option));
  return *this;
}

OptionParser&
OptionParser::flag(const std::string& name, bool& variable, const std::string& meaning)
{
  Option option;
  option.name = name;
  option.meaning = meaning;
  option.read = [&variable](const std::string&) { variable = true; };
  option.value = [&variable] { return variable ? "on" : "off"; };
  option.kind = Setting::Kind::Flag;
  options_.push_back(std::move(option));
  return *this;
}

OptionParser&
OptionParser::expert(const std::vector<std::string>& names)
{
  for (const auto& name : names) {
    auto* const option = find(name);
    assert(option != nullptr);
    option->expert = true;
  }
  return *this;
}

int
OptionParser::run(int argc,
                  const char* const* argv,
                  const std::function<void(Progress&)>& body)
{
  try {
    if (std::any_of(argv + 1, argv + argc, asksForVersion)) {
      std::printf("%s %s (PCL %s)\n",
                  program_.c_str(),
                  programVersion().c_str(),
                  PCL_VERSION_PRETTY);
      return EXIT_SUCCESS;
    }
    if (!parse(argc, argv)) {
      console::print_info("%s", usage().c_str());
      return EXIT_SUCCESS;
    }
    Progress progress(quiet_);
    if (!progress.isShown() && console::getVerbosityLevel() > console::L_ERROR)
      console::setVerbosityLevel(console::L_ERROR);
    body(progress);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    return report(program_, messageOf(error));
  }
}

bool
OptionParser::parse(int argc, const char* const* argv)
{
  const auto asks_for_help = [](const std::string& argument) {
    return argument == "-h" || argument == "-help" || argument == "--help";
  };
  for (const auto& option : options_)
    if (find(option.name) != &option)
      throw ToolError(option.name + ": two options have this name");
  if (std::any_of(argv + 1, argv + argc, asks_for_help))
    return false;
  std::vector<std::string> names;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (!looksLikeOption(argument)) {
      names.push_back(argument);
      continue;
    }
    auto* const option = find(argument);
    if (option == nullptr)
      throw ToolError(argument + ": unknown option, " + suggestion(argument));
    readOption(*option, argc, argv, i);
  }
  assignPositionals(names);
  if (const auto* const threads = find("-threads")) // what is no number, its tool says
    setReaderThreads(static_cast<int>(
        std::clamp(std::strtol(threads->value().c_str(), nullptr, 10), 0L, 1024L)));
  return true;
}

OptionParser::Option*
OptionParser::find(const std::string& name)
{
  const auto same_name = [&name](const Option& option) { return option.name == name; };
  const auto found = std::find_if(options_.begin(), options_.end(), same_name);
  return found == options_.end() ? nullptr : &*found;
}

void
OptionParser::readOption(Option& option,
                         int argc,
                         const char* const* argv,
                         int& position)
{
  if (option.given)
    throw ToolError(option.name + ": the option is given twice");
  option.given = true;
  if (option.placeholder.empty()) {
    option.read("");
    return;
  }
  const auto& choices = option.choices;
  const auto is_choice = [&choices](const std::string& text) {
    return std::find(choices.begin(), choices.end(), text) != choices.end();
  };
  if (position + 1 >= argc ||
      (looksLikeOption(argv[position + 1]) && !is_choice(argv[position + 1])))
    throw ToolError(option.name + ": the value is missing");
  option.read(argv[++position]);
}

OptionParser&
OptionParser::lastMayBeMissing(const bool& flag)
{
  last_may_be_missing_ = &flag;
  return *this;
}

void
OptionParser::assignPositionals(std::vector<std::string> names)
{
  const std::size_t required = positionals_.size() + rest_at_least_;
  if (last_may_be_missing_ != nullptr && *last_may_be_missing_ &&
      names.size() + 1 == required)
    names.emplace_back();
  if (names.size() < required) {
    const std::size_t next = names.size();
    const auto& missing = next < before_rest_ ? positionals_[next]
                          : next < before_rest_ + rest_at_least_
                              ? rest_
                              : positionals_[next - rest_at_least_];
    throw ToolError("The argument '" + missing.name + "' (" + missing.meaning +
                    ") is missing, -h shows the syntax");
  }
  if (rest_variable_ == nullptr && names.size() > positionals_.size())
    throw ToolError("'" + names[positionals_.size()] +
                    "' is one argument too many, -h shows the syntax");
  const std::size_t rest_count = names.size() - positionals_.size();
  for (std::size_t i = 0; i < positionals_.size(); ++i)
    *positionals_[i].variable =
        names[rest_variable_ != nullptr && i >= before_rest_ ? i + rest_count : i];
  if (rest_variable_ != nullptr) {
    const auto begin = names.begin() + static_cast<std::ptrdiff_t>(before_rest_);
    rest_variable_->assign(begin, begin + static_cast<std::ptrdiff_t>(rest_count));
  }
}

#define INSTANTIATE_NUMBER(T)                                                          \
  template OptionParser& OptionParser::number<T>(                                      \
      const std::string&, T&, const std::string&, const std::string&, const Range&);
INSTANTIATE_NUMBER(float)
INSTANTIATE_NUMBER(double)
INSTANTIATE_NUMBER(int)
INSTANTIATE_NUMBER(std::uint32_t)
INSTANTIATE_NUMBER(std::uint64_t)

} // namespace pcl::indoor::tool
