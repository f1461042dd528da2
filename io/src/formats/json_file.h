/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/tool_error.h"
#include "text/printable.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <string>

namespace pcl::indoor::tool {

/** \brief What a JSON file gives, read by a function.
 * \throws ToolError naming the file, if it is missing or no JSON, or if the function
 * looks for something that is not there
 */
template <typename Read>
auto
fromJsonFile(const std::string& path, const Read& read)
{
  std::ifstream stream(path);
  if (!stream)
    throw ToolError(path + ": cannot be opened");
  try {
    return read(nlohmann::json::parse(stream));
  } catch (const nlohmann::json::exception& problem) {
    throw ToolError(path + ": " + messageOf(problem));
  }
}

} // namespace pcl::indoor::tool
