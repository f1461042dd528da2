/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cmath>
#include <sstream>
#include <string>
#include <utility>

namespace pcl {
namespace indoor {

/** \brief Keeps the first complaint about options of objects. */
class FirstProblem {
public:
  explicit FirstProblem(std::string problem = {})
  : problem_(std::move(problem))
  {}

  void
  require(bool holds, const char* what, double value, const char* unit = "")
  {
    if (holds || !problem_.empty())
      return;
    std::ostringstream problem;
    problem << "The " << what << ", not " << value << unit << '.';
    problem_ = problem.str();
  }

  const std::string&
  text() const
  {
    return problem_;
  }

  static bool
  isSize(double value)
  {
    return value >= 0 && std::isfinite(value);
  }

  static bool
  isWeight(float value) // the square of a distance is finite
  {
    return value >= 0 && value <= 1e6f;
  }

private:
  std::string problem_;
};

} // namespace indoor
} // namespace pcl
