/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/exceptions.h>

#include <string>

namespace pcl::indoor {

/** \brief The text of an exception without the function, file and line that
 * PCL_THROW_EXCEPTION puts in front of it. */
inline std::string
plainMessage(const PCLException& error)
{
  const std::string text = error.what();
  if (error.getFileName() == nullptr)
    return text.rfind(": ", 0) == 0 ? text.substr(2) : text;
  const std::string line = "@ " + std::to_string(error.getLineNumber()) + " : ";
  const auto found = text.find(line);
  return found == std::string::npos ? text : text.substr(found + line.size());
}

} // namespace pcl::indoor
