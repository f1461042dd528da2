/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "text/text_table.h"

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <new>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Says on a terminal what a tool is doing, in PCL's form "> Loading room.pcd
 * [done, 12 ms : 34 points]".
 *
 * Silent where stdout is not a terminal, but for the summary, and after -quiet. Not for
 * use from several threads at once.
 */
class Progress {
public:
  explicit Progress(bool quiet = false);

  /** \brief Begin a step. */
  void
  start(const std::string& what);

  /** \brief Show how far the step is and, after two seconds, about how long it will
   * take from there; cheap to call often.
   * \param[in] detail shown behind, for example "accuracy 93 %"
   */
  void
  update(std::size_t done, std::size_t all, const std::string& detail = "");

  /** \brief End the step with what came out of it, for example "34 points". */
  void
  done(const std::string& result = "");

  /** \brief A line of its own, for example where the results lie. */
  void
  note(const std::string& text);

  /** \brief What is done once the results are in place: end the step of saving, say
   * what came out. It does not undo the results: where the memory does not suffice for
   * it, one warning says so.
   * \param[in] tell called once
   */
  template <typename Function>
  static void
  conclude(const Function& tell)
  {
    try {
      tell();
    } catch (const std::bad_alloc&) {
      std::fputs("Warning: There is not enough memory to say what came out\n", stderr);
    }
  }

  /** \brief What came out of all, on one line: also where stdout is no terminal, but
   * not after -quiet. */
  void
  summary(const std::string& text);

  /** \brief A text on stderr, but not after -quiet. */
  void
  say(const std::string& text);

  /** \brief A table after the summary, wherever that is said. */
  void
  table(const TextTable& table);

  /** \brief A step that has ended. */
  struct Stage {
    std::string name;
    double seconds = 0.0;
  };

  /** \brief The steps so far, in their order, whether they are shown or not. */
  const std::vector<Stage>&
  stages() const
  {
    return stages_;
  }

  bool
  isShown() const
  {
    return shown_;
  }

private:
  void
  replaceText(const std::string& text);

  bool quiet_;
  bool shown_;
  std::vector<Stage> stages_;
  std::string name_; ///< of the step
  int percent_ = -1;
  std::string text_;           ///< how far the step is, as it stands on the terminal
  std::size_t first_done_ = 0; ///< of the step's first update(), where it goes on
  std::chrono::steady_clock::time_point begin_;
};

/** \brief A time for people: "45 s", "3 min", "2.5 h". */
std::string
durationText(double seconds);

} // namespace pcl::indoor::tool
