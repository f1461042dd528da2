/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <nlohmann/json.hpp>

#include <cmath>
#include <string>

namespace pcl::indoor::tool {

/** \brief A length, area, volume or share to four decimals: tenths of a millimetre are
 * finer than any scanner, and short to read. */
inline double
rounded(double value)
{
  return std::round(value * 1e4) / 1e4;
}

/** \brief The text of a file; names of files need not be UTF-8. */
inline std::string
jsonText(const nlohmann::ordered_json& json)
{
  using Json = nlohmann::ordered_json;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace pcl::indoor::tool
