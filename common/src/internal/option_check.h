/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <limits>
#include <sstream>
#include <string>

namespace pcl::indoor {

/** \brief Keeps the first complaint about options. */
class OptionCheck {
public:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double endless = std::numeric_limits<double>::max(); // finite
  static constexpr double longest = 1000.0;      // metres; larger than any building
  static constexpr double shortest_voxel = 1e-4; // metres; finer than any scan

  /** \brief Complain unless it holds: "The <rule>, not <value>." */
  template <typename Value>
  void
  require(bool holds, const char* rule, Value value, const char* unit = "")
  {
    if (holds || !problem_.empty())
      return;
    std::ostringstream text;
    text << "The " << rule << ", not " << value << unit << '.';
    problem_ = text.str();
  }

  /** Both ends are legal; NaN never is. */
  void
  between(double low, double high, const char* what, double value, const char* unit)
  {
    if (!problem_.empty() || (low <= value && value <= high))
      return;
    std::ostringstream text;
    text << "The " << what << " must ";
    if (high >= endless && low == 0.0)
      text << "not be negative";
    else if (high >= endless)
      text << "be at least " << low << unit;
    else
      text << "lie in " << low << " ... " << high << unit;
    text << ", not " << value << unit << '.';
    problem_ = text.str();
  }

  void
  finite(const char* what, double value, const char* unit)
  {
    between(0.0, endless, what, value, unit);
  }

  /** Also 0; at most so many voxels of the smallest size as an int can count. */
  void
  length(const char* what, double value)
  {
    between(0.0, longest, what, value, " m");
  }

  /** 0 is automatic. */
  void
  voxel(double size)
  {
    length("voxel size", size);
    if (!problem_.empty() || size == 0.0 || size >= shortest_voxel)
      return;
    std::ostringstream text;
    text << "The voxel size must be 0 or at least " << shortest_voxel << " m, not "
         << size << " m.";
    problem_ = text.str();
  }

  void
  positive(const char* what, double value, double high, const char* unit)
  {
    if (value > 0.0)
      between(0.0, high, what, value, unit);
    else if (problem_.empty()) {
      std::ostringstream text;
      text << "The " << what << " must be positive, not " << value << unit << '.';
      problem_ = text.str();
    }
  }

  void
  positiveLength(const char* what, double value)
  {
    positive(what, value, longest, " m");
  }

  void
  area(const char* what, double value)
  {
    between(0.0, infinity, what, value, " m^2");
  }

  /** In distances of which the square is finite. */
  void
  weight(const char* what, double value)
  {
    between(0.0, 1e6, what, value, "");
  }

  void
  share(const char* what, double value)
  {
    between(0.0, 1.0, what, value, "");
  }

  const std::string&
  problem() const
  {
    return problem_;
  }

private:
  std::string problem_;
};

} // namespace pcl::indoor
