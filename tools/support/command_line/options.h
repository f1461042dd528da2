/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "command_line/progress.h"
#include "files/tool_error.h"
#include "text/program_version.h"

#include <pcl/indoor/setting.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief The legal values of a number. */
struct Range {
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  bool without_lowest = false; ///< the lowest value itself is not legal

  /** \brief Greater than 0. */
  static Range
  positive()
  {
    return {0.0, std::numeric_limits<double>::infinity(), true};
  }

  static Range
  atLeast(double lowest)
  {
    return {lowest, std::numeric_limits<double>::infinity(), false};
  }

  /** \brief Both ends included. */
  static Range
  between(double lowest, double highest)
  {
    return {lowest, highest, false};
  }

  bool
  contains(double value) const;

  /** \brief For example "greater than 0" or "from 0 to 1". */
  std::string
  text() const;
};

/** \brief The command line of a tool in PCL's manners, read strictly.
 *
 * A tool names its arguments and the variables they are written to; the parser makes
 * the text of -h from them (with the value that a variable holds beforehand as its
 * default), refuses unknown, repeated, incomplete, unreadable and illegal options with
 * one line on stderr, and runs the tool's body. The options -h, --version and -quiet
 * always exist.
 * Options start with '-' and a letter, so "-1" is a value. File names may stand before,
 * between and after them.
 */
class OptionParser {
public:
  /** \param[in] program name of the tool, for example "pcl_room_segmentation"
   * \param[in] summary one sentence: what it does
   */
  OptionParser(std::string program, std::string summary);

  /** \brief A required file or folder name, in the order of the calls. */
  OptionParser&
  positional(const std::string& name,
             std::string& variable,
             const std::string& meaning);

  /** \brief Any number of names, at least \a at_least of them, between those that were
   * declared before and after it. */
  OptionParser&
  positionals(const std::string& name,
              std::vector<std::string>& variable,
              const std::string& meaning,
              std::size_t at_least = 1);

  /** \brief The last name may be missing if a flag is set.
   * \param[in] flag of an option; must outlive the parser */
  OptionParser&
  lastMayBeMissing(const bool& flag);

  /** \brief A number: float, double, int, std::uint32_t or std::uint64_t.
   * \param[in] name with its dash, for example "-voxel_size"
   * \param[in,out] variable its default beforehand, its value afterwards; it must
   * outlive the parser
   * \param[in] unit for example "m" or "points"; empty where there is none
   */
  template <typename T>
  OptionParser&
  number(const std::string& name,
         T& variable,
         const std::string& meaning,
         const std::string& unit = "",
         const Range& range = {});

  /** \brief A text, for example a file name; \a choices, where given, are the only
   * legal ones, or those and what \a others takes without throwing. */
  OptionParser&
  text(const std::string& name,
       std::string& variable,
       const std::string& meaning,
       const std::vector<std::string>& choices = {},
       const std::function<void(const std::string&)>& others = {});

  /** \brief An option without a value that sets the variable to true. */
  OptionParser&
  flag(const std::string& name, bool& variable, const std::string& meaning);

  /** \brief List these options apart in the text of -h, as ones that rarely need a
   * change. They must be registered already. */
  OptionParser&
  expert(const std::vector<std::string>& names);

  /** \brief Read the command line; if it is good, run the body.
   * \param[in] body the tool's work; it says why it stops by throwing ToolError or
   * pcl::PCLException
   * \return what main() returns: EXIT_SUCCESS after -h, --version and the body's end,
   * EXIT_FAILURE after any error
   */
  int
  run(int argc, const char* const* argv, const std::function<void(Progress&)>& body);

  /** \brief Read the command line.
   * \return false if -h was among the arguments
   * \throws ToolError on the first argument that is wrong
   */
  bool
  parse(int argc, const char* const* argv);

  /** \brief The text of -h. */
  std::string
  usage() const;

  /** \brief All options with the values that are used; but for those by which no
   * result changes: of threads, processes and memory, -quiet and -check. */
  std::vector<Setting>
  settings() const;

  /** \brief The same in one line, for the user to check. */
  std::string
  values() const;

private:
  struct Option {
    std::string name;
    std::string
        placeholder; ///< what -h shows in place of the value; empty: takes no value
    std::string meaning;
    std::string range;                            ///< empty: anything
    std::string default_value;                    ///< as it was at registration
    std::vector<std::string> choices;             ///< may begin with '-'
    std::function<void(const std::string&)> read; ///< throws ToolError
    std::function<std::string()> value;           ///< without its unit
    std::string unit;
    Setting::Kind kind = Setting::Kind::Text;
    bool given = false;
    bool expert = false;
  };

  struct Positional {
    std::string name;
    std::string meaning;
    std::string* variable = nullptr;
  };

  Option*
  find(const std::string& name);

  /** How an unknown option is spelled right; empty if none is like it. */
  std::string
  suggestion(const std::string& argument);

  static std::string
  line(const Option& option);

  void
  readOption(Option& option, int argc, const char* const* argv, int& position);

  void
  assignPositionals(std::vector<std::string> names);

  std::string program_;
  std::string summary_;
  std::vector<Positional> positionals_;
  Positional rest_;
  std::vector<std::string>* rest_variable_ = nullptr;
  std::size_t rest_at_least_ = 0;
  std::size_t before_rest_ = 0; // positionals
  const bool* last_may_be_missing_ = nullptr;
  std::vector<Option> options_;
  bool quiet_ = false;
};

} // namespace pcl::indoor::tool
