/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/las/las_header.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Gives the records of the points of a LAS or LAZ file. */
class LasSource {
public:
  virtual ~LasSource() = default;

  /** \brief Read some records; fast where they follow the last ones that were read.
   * \param[out] records \a count of them, of LasHeader::step bytes each
   * \throws ToolError if they cannot be read */
  virtual void
  read(std::uint64_t first, std::size_t count, char* records) = 0;
};

/** \brief A LAS or LAZ file up to its points. */
struct OpenLas {
  LasHeader header;  ///< its number of points is that of those that can be read
  std::string bytes; ///< before the points
  std::vector<std::string> notes; ///< what is odd, see CloudFile::notes
  std::shared_ptr<LasSource> source;
};

/** \brief Open a file, and make its number of points fit to it as far as it can.
 * \throws ToolError if it is damaged, or has fewer points than its header promises
 */
OpenLas
openLas(const std::string& path);

} // namespace pcl::indoor::tool
