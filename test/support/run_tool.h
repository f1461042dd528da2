/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstdlib>
#include <string>

namespace pcl::indoor::test {

/** Run one of the tools, found by PCL_INDOOR_TOOLS.
 * \param[in] said the file of what it prints; empty: it is printed
 * \param[in] complaints that of its complaints; empty: the same
 * \return its status as std::system() gives it */
inline int
runTool(const std::string& tool,
        const std::string& arguments,
        const std::string& said = "",
        const std::string& complaints = "")
{
  auto command = std::string(PCL_INDOOR_TOOLS) + "/" + tool + " " + arguments;
  if (!said.empty())
    command += " > " + said + (complaints.empty() ? " 2>&1" : " 2> " + complaints);
  return std::system(command.c_str());
}

} // namespace pcl::indoor::test
