/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/e57/e57_scans.h"

#include <pcl/PCLPointCloud2.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief What becomes of the fields of an E57 scan.
 *
 * The fields of the cloud are x, y, z as doubles, with the pose of the scan applied;
 * rgb and intensity; row, column, return_number (from 1), number_of_returns and time;
 * normal_x, normal_y, normal_z, turned as the pose tells; and others by their own
 * names. Points that the file flags as invalid are NaN, intensities that it flags, too.
 */
class E57Points {
public:
  /** \param[in] scan must outlive this
   * \throws ToolError naming the file if the points have no coordinates */
  E57Points(const E57Scan& scan, const std::string& path);

  /** \brief Fields and width; no points. */
  const PCLPointCloud2&
  layout() const
  {
    return layout_;
  }

  /** \brief Numbers of the fields of the scan that are read, without those that have
   * one value. */
  const std::vector<std::size_t>&
  wanted() const
  {
    return wanted_;
  }

  /** \brief Names of fields that are left out. */
  const std::vector<std::string>&
  leftOut() const
  {
    return left_out_;
  }

  /** \brief The number of the field whose value is not 0 where a point is invalid;
   * nothing if there is none. */
  std::optional<std::size_t>
  flag() const
  {
    return flag_;
  }

  /** \brief Was it measured from the origin of its coordinates, as those that are
   * spherical or in rows and columns? */
  bool
  isAtStation() const
  {
    return is_at_station_;
  }

  /** \brief Convert points.
   * \param[in] streams of wanted(), see E57Packets::read()
   * \param[in] first of the points: its number tells where in the first byte it begins
   * \param[out] points count times the layout's point_step bytes
   */
  void
  convert(const std::vector<std::string>& streams,
          std::uint64_t first,
          std::size_t count,
          std::uint8_t* points) const;

private:
  /** Values of each used field. */
  using Values = std::vector<std::vector<double>>;
  /** Writes a field of the cloud to points, from that of the first one on. */
  using Write =
      std::function<void(const Values&, std::size_t count, std::uint8_t* points)>;

  std::optional<std::size_t>
  find(const std::string& name) const;

  std::size_t
  use(std::size_t field);

  std::vector<std::size_t>
  useAll(const std::vector<std::string>& names);

  std::size_t
  append(const std::string& name, std::uint8_t type);

  void
  addPlaces(const std::string& path);

  template <typename ValueOf>
  void
  writeEach(std::size_t at, const ValueOf& value_of);

  void
  addColors();

  void
  addIntensity();

  void
  addNormals();

  void
  addOther(std::size_t field);

  template <typename T>
  void
  addNumber(std::size_t field,
            const std::string& name,
            std::uint8_t type,
            double added);

  const E57Scan& scan_;
  PCLPointCloud2 layout_;
  std::vector<std::size_t> used_, wanted_;
  std::optional<std::size_t> flag_;
  bool is_at_station_ = false;
  std::vector<std::string> left_out_;
  std::vector<Write> writes_;
};

} // namespace pcl::indoor::tool
