/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <boost/crc.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace pcl::indoor {

/** \brief CRC-32 of bytes. */
inline std::uint32_t
checksum(const char* bytes, std::size_t count)
{
  boost::crc_32_type crc;
  crc.process_bytes(bytes, count);
  return crc.checksum();
}

/** \brief An unsigned number, the lowest byte first. */
template <typename T>
T
numberAt(const char* bytes)
{
  T number = 0;
  for (std::size_t k = 0; k < sizeof(T); ++k)
    number =
        static_cast<T>(number | T(static_cast<unsigned char>(bytes[k])) << (8 * k));
  return number;
}

/** \brief A floating-point number of 32 bits, the lowest byte first. */
inline float
floatAt(const char* bytes)
{
  const auto bits = numberAt<std::uint32_t>(bytes);
  float number = 0.0f;
  std::memcpy(&number, &bits, sizeof number);
  return number;
}

} // namespace pcl::indoor
