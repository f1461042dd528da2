/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/cloud_pose.h"

#include <pcl/indoor/exports.h>
#include <pcl/io/station.h>
#include <pcl/PCLPointCloud2.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Reads the points of a file part by part, as loadCloud() would give them. */
class PCL_INDOOR_EXPORTS CloudStream {
public:
  virtual ~CloudStream() = default;

  /** \brief Open a file whose points can be read in parts: a binary PCD, a binary PLY
   * without faces and lists, a LAS, LAZ, E57 or PTX file.
   * \return null if it is none of these, or damaged: then loadCloud() can read it, or
   * says what is wrong
   */
  static std::unique_ptr<CloudStream>
  open(const std::string& path);

  /** \brief Fields, width and height of the whole; no points. */
  const PCLPointCloud2&
  layout() const
  {
    return layout_;
  }

  const CloudPose&
  pose() const
  {
    return pose_;
  }

  /** \brief What is odd in the file, see CloudFile::notes. */
  const std::vector<std::string>&
  notes() const
  {
    return notes_;
  }

  void
  addNote(const std::string& note)
  {
    notes_.push_back(note);
  }

  /** \brief Where the scanner stood, if the file tells; of several stations the field
   * station tells from 1 at which one a point was measured. */
  const std::vector<Station>&
  stations() const
  {
    return stations_;
  }

  std::uint64_t
  pointCount() const
  {
    return static_cast<std::uint64_t>(layout_.width) * layout_.height;
  }

  /** \brief Read some points, one row of them.
   * \throws ToolError if the file has become shorter */
  virtual PCLPointCloud2
  read(std::uint64_t first, std::size_t count) = 0;

  /** \brief Read all points, part by part.
   * \param[in] visit is called with the number of the first point of the part */
  void
  forEachPart(
      const std::function<void(std::uint64_t first, PCLPointCloud2& part)>& visit);

protected:
  /** \brief Tell the only station, and the sensor's pose as far as floats have it.
   * \param[in] turn of the scan's coordinates; may be no rotation */
  void
  setStation(const std::string& name,
             const Eigen::Vector3d& position,
             const Eigen::Matrix3d& turn);

  PCLPointCloud2 layout_;
  CloudPose pose_;
  std::vector<std::string> notes_;
  std::vector<Station> stations_;
};

/** \brief A row of so many points with the fields of a layout, which have no bytes yet.
 */
PCLPointCloud2
emptyPart(const PCLPointCloud2& layout, std::size_t count);

} // namespace pcl::indoor::tool
