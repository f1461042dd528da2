/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <cstring>

namespace pcl::indoor {

/** \brief A number that the bits of a point's coordinates tell, spread over 64 bits: to
 * sample points whatever their order is, and to find those in one place. 0 and -0
 * differ.
 */
inline std::uint64_t
pointHash(const Eigen::Vector3f& point)
{
  std::uint32_t bits[3];
  std::memcpy(bits, point.data(), sizeof(bits));
  std::uint64_t hash = 0;
  for (const std::uint32_t part : bits)
    hash = (hash + part + 1) * 0x9e3779b97f4a7c15u;
  return (hash ^ hash >> 29) * 0xbf58476d1ce4e5b9u;
}

} // namespace pcl::indoor
