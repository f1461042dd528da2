/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace pcl::indoor::tool {

/** \brief 64 bits that tell whether bytes are the same as before; no protection against
 * forgery. */
PCL_INDOOR_EXPORTS std::uint64_t
digestOf(const void* bytes, std::size_t size, std::uint64_t seed = 0);

PCL_INDOOR_EXPORTS std::uint64_t
digestOf(const std::string& text, std::uint64_t seed = 0);

/** \brief The same of all bytes of a file, block by block: the digest of each block
 * starts the next one's; the last is shorter than a block, or empty.
 * \param[in] block_size in bytes
 * \throws ToolError if it cannot be read */
PCL_INDOOR_EXPORTS std::uint64_t
digestOfFile(const std::string& path, std::size_t block_size = 1 << 20);

} // namespace pcl::indoor::tool
