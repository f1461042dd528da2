/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <string>

namespace pcl::indoor::tool {

/** \brief Say what a cloud file of another format is, and the command that makes it
 * readable: by its first bytes, else by the ending of its name.
 * \param[in] beginning a few hundred bytes, or fewer if the file is shorter
 * \return for example "a LAS file; convert it: pdal translate a.las a.ply"; empty if
 * the format is not known
 */
std::string
describeForeignFormat(const std::string& path, const std::string& beginning);

} // namespace pcl::indoor::tool
