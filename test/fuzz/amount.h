/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstddef>
#include <string>

namespace pcl::indoor::fuzz {

/** \brief How much to try: a number of inputs, which gives the same each time, or
 * seconds. */
struct Amount {
  double seconds = 0;
  std::size_t count = 0;

  /** \param[in] text "2000x": inputs for each of the kinds; "60": seconds for all */
  static Amount
  parse(const std::string& text, std::size_t kinds)
  {
    if (!text.empty() && text.back() == 'x')
      return {0, std::stoul(text)};
    return {std::stod(text) / static_cast<double>(kinds), 0};
  }

  bool
  wantsMore(std::size_t done, double passed) const
  {
    return count > 0 ? done < count : passed < seconds;
  }
};

} // namespace pcl::indoor::fuzz
