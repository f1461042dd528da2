/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_writer.h"
#include "files/tool_error.h"
#include "formats/table/table_columns.h"

#include <pcl/indoor/exports.h>
#include <pcl/io/station.h>
#include <pcl/PCLPointCloud2.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief A point cloud as its file gave it, and its points for computing. */
struct CloudFile {
  std::string path;
  PCLPointCloud2 cloud; ///< every field of the file, bytes unchanged
  CloudPose pose;       ///< the sensor's pose and the offset that the file tells

  /** The points in the file's order and arrangement, each coordinate minus \a offset;
   * NaN where one is not finite, or too large to compute with, see isUsable(). Its
   * sensor's pose is in the same frame. */
  PointCloud<PointXYZ>::Ptr points;
  /** The offset that the file tells, and whole units near the middle of coordinates
   * that are large all the same (for example UTM); otherwise zero. */
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
  /** The greatest distance between neighbouring numbers in which large coordinates are
   * stored: floats are coarse. 0 without large coordinates. */
  double coordinate_step = 0.0;
  std::size_t finite_count = 0; ///< of \a points without NaN
  std::size_t copy_count = 0;   ///< of \a points in exactly the place of another
  /** Places of thousands of points that are none, in the coordinates of the file; NaN
   * in \a points. */
  std::vector<Eigen::Vector3d> left_out;
  /** The file has normal_x, normal_y, normal_z, and they are normals. */
  bool has_normals = false;
  std::vector<Station> stations; ///< see CloudStream::stations()
  /** What was odd in the file and how it was taken, a line each without its name. */
  std::vector<std::string> notes;
};

/** \brief Print the notes of a file on stderr, a line each. */
PCL_INDOOR_EXPORTS void
printNotes(const CloudFile& file);

/** \brief Read a file of any of the formats of cloudFormatOf(): its content says which
 * one it is, or the ending of a table's name. It may be packed, see isPacked().
 *
 * Prints nothing.
 * \param[in] columns of a table
 * \throws ToolError if the file is missing, is no cloud, is shorter than its header
 * says, lacks float x, y, z, or holds fewer than \a least_points finite points
 */
PCL_INDOOR_EXPORTS CloudFile
loadCloud(const std::string& path,
          const TableColumns& columns = {},
          std::size_t least_points = 2);

/** \brief Read the one scan in a packed file.
 * \param[in] load reads the file that was unpacked
 * \throws ToolError as UnpackedFiles and \a load, and if there are several scans in it
 */
CloudFile
loadUnpacked(const std::string& path,
             const std::function<CloudFile(const std::string& file)>& load);

/** \brief The same of a cloud that was read.
 * \param[in] path names it in errors
 * \param[in] notes of its reader
 */
PCL_INDOOR_EXPORTS CloudFile
withPoints(const std::string& path,
           PCLPointCloud2 cloud,
           const CloudPose& pose,
           std::size_t least_points = 2,
           std::vector<std::string> notes = {});

/** \brief What is subtracted from the coordinates of a cloud before they become floats:
 * whole units near the middle of those that are large. */
struct CoordinateOrigin {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  double step = 0.0; ///< see CloudFile::coordinate_step
};

PCL_INDOOR_EXPORTS CoordinateOrigin
coordinateOrigin(const PCLPointCloud2& cloud);

/** \brief Is it exactly one of some places? */
bool
isOneOf(const Eigen::Vector3d& point, const std::vector<Eigen::Vector3d>& places);

/** \brief The points of a cloud, each coordinate minus \a middle; NaN where one is not
 * finite, or too large to compute with.
 * \param[out] finite_count of points without NaN
 * \param[in] left_out places that are no points, NaN as well
 */
PCL_INDOOR_EXPORTS PointCloud<PointXYZ>::Ptr
pointsAround(const PCLPointCloud2& cloud,
             const Eigen::Vector3d& middle,
             std::size_t& finite_count,
             const std::vector<Eigen::Vector3d>& left_out = {});

/** \brief The coordinates of a cloud as its file gives them. */
class CloudPlaces {
public:
  /** \param[in] cloud must outlive this */
  explicit CloudPlaces(const PCLPointCloud2& cloud);

  std::size_t
  size() const;

  Eigen::Vector3d
  at(std::size_t point) const;

private:
  const PCLPointCloud2* cloud_;
  int fields_[3];
};

/** \brief Does the cloud have real numbers of this name? */
bool
isRealField(const PCLPointCloud2& cloud, const std::string& name);

/** \brief Does the cloud have normal_x, normal_y and normal_z as real numbers? */
PCL_INDOOR_EXPORTS bool
hasNormals(const PCLPointCloud2& cloud);

/** \brief The normals of a cloud with \a has_normals, in its order; curvature 0 where
 * the file has none. */
PCL_INDOOR_EXPORTS PointCloud<Normal>::Ptr
readNormals(const CloudFile& file);

/** \brief The same of a part of a file. */
PCL_INDOOR_EXPORTS PointCloud<Normal>::Ptr
readNormals(const PCLPointCloud2& cloud);

/** \brief The colours of a cloud, from its field rgb or rgba, in its order.
 * \throws ToolError if it has none
 */
PCL_INDOOR_EXPORTS PointCloud<RGB>::Ptr
readColors(const CloudFile& file);

/** \brief Does the cloud have such a field? */
PCL_INDOOR_EXPORTS bool
hasField(const PCLPointCloud2& cloud, const std::string& name);

/** \brief A field of whole numbers, one value per point.
 * \throws ToolError if the field is missing or a value is negative, fractional or too
 * large
 */
PCL_INDOOR_EXPORTS std::vector<std::uint32_t>
readLabels(const CloudFile& file, const std::string& name);

/** \brief A field of any numbers, one value per point.
 * \throws ToolError if the field is missing
 */
PCL_INDOOR_EXPORTS std::vector<double>
readNumbers(const CloudFile& file, const std::string& name);

/** \brief Take a field away, if there is one of that name; its bytes stay as padding.
 */
PCL_INDOOR_EXPORTS void
removeField(PCLPointCloud2& cloud, const std::string& name);

/** \brief A field to be appended: labels or real numbers, one per point, which have to
 * outlive it. */
struct PCL_INDOOR_EXPORTS NewField {
  NewField(std::string its_name, const std::vector<std::uint32_t>& labels);
  NewField(std::string its_name, const std::vector<float>& reals);

  std::string name;
  std::uint8_t datatype;
  const void* values;
  std::size_t count;
};

/** \brief Append fields, in one pass over the points; fields of these names are
 * replaced. */
PCL_INDOOR_EXPORTS void
appendFields(PCLPointCloud2& cloud, const std::vector<NewField>& fields);

inline void
appendField(PCLPointCloud2& cloud,
            const std::string& name,
            const std::vector<std::uint32_t>& labels)
{
  appendFields(cloud, {{name, labels}});
}

inline void
appendRealField(PCLPointCloud2& cloud,
                const std::string& name,
                const std::vector<float>& reals)
{
  appendFields(cloud, {{name, reals}});
}

} // namespace pcl::indoor::tool
