/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstddef>
#include <cstring>
#include <string>

namespace pcl::indoor::test {

/** \brief Writes the bytes of a value over those at a place. */
template <typename T>
void
put(std::string& bytes, std::size_t at, T value)
{
  std::memcpy(&bytes[at], &value, sizeof(value));
}

} // namespace pcl::indoor::test
