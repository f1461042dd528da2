/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/las/las_header.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief A field of the cloud: where its bytes are in a point of the file, and how
 * they are copied. */
struct LasField {
  std::string name;
  std::uint8_t type; ///< of PCLPointField, of what is written
  std::size_t size;  ///< bytes that are written
  std::function<void(const char* point, char* target)> copy;
};

/** \brief How a file's colours, in fields of 16 bits, become those of a cloud. */
struct LasColors {
  unsigned shift; ///< to 8 bits
  bool are_fine;  ///< they have fields of their own with all their bits, too
  /** Some points hold 8-bit colours, others 16-bit: a point whose channels are all at
   * most 255 is taken as 8-bit. */
  bool are_mixed;
};

/** \brief The fields of the points of a LAS file, x, y and z as doubles first.
 * \param[in] bytes of the file, up to its points
 * \param[in,out] notes what is left out is added
 */
std::vector<LasField>
lasFields(const std::string& bytes,
          const LasHeader& header,
          const LasColors& colors,
          std::vector<std::string>& notes);

} // namespace pcl::indoor::tool
