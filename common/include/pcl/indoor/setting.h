/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <string>

namespace pcl::indoor {

/** \brief An option with the value that is used. */
struct Setting {
  enum class Kind { Number, Text, Flag };

  std::string name;  ///< with its dash
  std::string value; ///< "on" or "off" of a flag
  std::string unit;  ///< of a number; may be empty
  Kind kind = Kind::Text;
};

} // namespace pcl::indoor
