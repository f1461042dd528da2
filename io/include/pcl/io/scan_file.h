/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/io/input_error.h>
#include <pcl/io/station.h>
#include <pcl/PCLPointCloud2.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pcl::indoor {

struct ScanContent;

/** \brief How the scan of a building is read. */
struct ScanOptions {
  /** Columns of a table (XYZ, CSV, PTS), such as "x,y,z,_,r,g,b", of which _ is left
   * out; empty: as its header says, or by their number. */
  std::string columns;
  /** Scans with more points are read from disk in parts, so memory depends on the
   * largest rooms only; 0 = always load all. */
  std::uint64_t points_at_once = 20000000;
  /** File with the positions of the scanner, x y z in each line, in frame and unit of
   * the scan; empty: as the scan's own files tell them. */
  std::string stations;
  bool ignore_stations = false; ///< do as if it were not known where it stood
};

/** \brief The scan of a building, as its files have it.
 *
 * Copies share one scan. It is to be used by one thread at a time.
 */
class PCL_INDOOR_EXPORTS Scan {
public:
  explicit Scan(std::shared_ptr<ScanContent> content);

  /** \brief The name of its file, or what several are called. */
  const std::string&
  name() const;

  std::uint64_t
  pointCount() const;

  /** \brief Has it more points than are read at once? */
  bool
  isReadInParts() const;

  /** \brief All fields, bytes unchanged; of a scan that is read in parts without
   * points. */
  const PCLPointCloud2&
  cloud() const;

  /** \brief The points in the order of the files, each coordinate minus offset(); NaN
   * where one is not finite; null if the scan is read in parts. */
  PointCloud<PointXYZ>::ConstPtr
  points() const;

  /** \brief Whole units near the middle of coordinates that are large, and what the
   * file tells; of a scan that is read in parts what the file tells. */
  Eigen::Vector3d
  offset() const;

  /** \brief Where the scanner stood, if the files tell. */
  const std::vector<Station>&
  stations() const;

  /** \brief What was odd and how it was taken, a line each. */
  const std::vector<std::string>&
  notes() const;

  /** \brief For this library. */
  ScanContent&
  content() const
  {
    return *content_;
  }

private:
  std::shared_ptr<ScanContent> content_;
};

/** \brief Read the scan of a building: PCD, PLY, LAS, LAZ, E57, PTX, OBJ, STL, OFF,
 * GLB or a table (XYZ, CSV, PTS ...); its content says what it is. Of a folder, all
 * scans in it are stations of one building.
 * \throws InputError if there is no such file, or if it is none of these or damaged
 */
PCL_INDOOR_EXPORTS Scan
loadScan(const std::string& path, const ScanOptions& options = {});

/** \brief The same of several files or folders, the stations of one building: their
 * points one after the other. */
PCL_INDOOR_EXPORTS Scan
loadScan(const std::vector<std::string>& paths, const ScanOptions& options = {});

} // namespace pcl::indoor
