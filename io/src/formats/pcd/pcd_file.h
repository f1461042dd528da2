/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"
#include "files/cloud_stream.h"

#include <cstdint>
#include <memory>
#include <string>

namespace pcl::indoor::tool {

/** \brief Is it a PCD file, by its first line that is no comment?
 * \param[in] beginning of the file, 512 bytes if it has as many
 */
bool
isPcd(const std::string& path, const std::string& beginning);

/** \brief Can it be one, whose comment is longer than this beginning? */
bool
isCommentedPcd(const std::string& path, const std::string& beginning);

/** \brief How many points the header promises.
 * \throws ToolError if it contradicts itself */
std::uint64_t
pcdPointCount(const std::string& path, const std::string& beginning);

/** \brief Open a file with DATA binary.
 * \return null if it is another one
 * \throws ToolError if its header is damaged */
std::unique_ptr<CloudStream>
openPcd(const std::string& path);

/** \brief Read a whole file, of any DATA.
 *
 * PCL's reader is given no more than it can trust: the header is compared with what
 * follows it before.
 * \throws ToolError if its header contradicts itself, or if it has no points, or fewer
 * bytes or lines than its header promises
 */
void
loadPcd(CloudFile& file, const TableColumns& columns);

} // namespace pcl::indoor::tool
