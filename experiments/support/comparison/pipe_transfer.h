/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <unistd.h>

#include <cstddef>

namespace pcl::indoor::tool {

/** \brief Write all of some bytes to a pipe, or read as many from it.
 * \return false if the other end is closed before
 */
inline bool
transfer(int descriptor, void* data, std::size_t size, bool writes)
{
  auto* bytes = static_cast<char*>(data);
  while (size > 0) {
    const ssize_t moved =
        writes ? write(descriptor, bytes, size) : read(descriptor, bytes, size);
    if (moved <= 0)
      return false;
    bytes += moved;
    size -= static_cast<std::size_t>(moved);
  }
  return true;
}

} // namespace pcl::indoor::tool
