/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

namespace pcl::indoor::tool {

/** \brief A number at a place of a LAS file, which is little-endian as this machine is.
 */
template <typename T>
T
numberAt(const char* bytes)
{
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

/** \brief Where in a point of a format what is; 0 = nowhere. */
struct LasPointFormat {
  std::size_t size, classification, source, gps_time, colors, infrared;
};

/** \brief What the header of a LAS file says. */
struct LasHeader {
  std::size_t header_size = 0, body_begin = 0, records = 0, format = 0, step = 0;
  bool is_compressed = false; ///< a LAZ file
  std::uint64_t points = 0;
  std::uint64_t body_end = 0; ///< where waveforms or more records begin; 0 = nowhere
  std::array<double, 3> scales{}, offsets{};

  /** \brief Is it one of the formats whose classes have 8 bits, not 5? */
  bool
  isLong() const
  {
    return format >= 6;
  }

  const LasPointFormat&
  places() const;

  /** \brief Is a point no part of the scan any more? */
  bool
  isWithheld(const char* point) const;
};

/** \brief The header that some bytes begin with; nothing if it contradicts itself. */
std::optional<LasHeader>
parseLasHeader(const std::string& bytes);

/** \brief The content of the first record of variable length of a user with a number.
 * \param[in] bytes of the file before its points
 * \return empty if there is none
 */
std::string_view
lasRecord(const std::string& bytes,
          const LasHeader& header,
          std::string_view user,
          std::uint16_t id);

} // namespace pcl::indoor::tool
