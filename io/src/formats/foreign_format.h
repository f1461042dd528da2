/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <string>

namespace pcl::indoor::tool {

/** \brief Say what a file of another format is and what makes it readable, a command
 * where there is one: by its first bytes, else by the ending of its name.
 *
 * Commands need what Debian has, or Python's packages.
 * \param[in] beginning a few hundred bytes, or fewer if the file is shorter
 * \return for example "an FBX scene; convert it ..."; empty if the format is
 * not known
 */
std::string
describeForeignFormat(const std::string& path, const std::string& beginning);

} // namespace pcl::indoor::tool
