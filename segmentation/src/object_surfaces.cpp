/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/exceptions.h>
#include <pcl/segmentation/object_surfaces.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace indoor {

namespace {

constexpr float column_size = 0.1f; // metres
constexpr int column_reach = 3;     // columns around an object that show the floor
constexpr std::uint32_t nothing = 0xFFFFFFFFu;

/** \brief A map of upright columns over a room. */
class Columns {
public:
  explicit Columns(const std::vector<Eigen::Vector3f>& points)
  {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    Eigen::Vector2f upper(-infinity, -infinity);
    lower_.setConstant(infinity);
    for (const auto& point : points) {
      lower_ = lower_.cwiseMin(point.head<2>());
      upper = upper.cwiseMax(point.head<2>());
    }
    if (points.empty())
      lower_ = upper = Eigen::Vector2f::Zero();
    width_ = static_cast<int>((upper.x() - lower_.x()) / column_size) + 1;
    height_ = static_cast<int>((upper.y() - lower_.y()) / column_size) + 1;
  }

  int
  width() const
  {
    return width_;
  }

  int
  height() const
  {
    return height_;
  }

  std::size_t
  size() const
  {
    return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  }

  std::size_t
  index(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  std::size_t
  indexOf(const Eigen::Vector3f& point) const
  {
    const Eigen::Vector2f place = (point.head<2>() - lower_) / column_size;
    return index(static_cast<int>(place.x()), static_cast<int>(place.y()));
  }

private:
  Eigen::Vector2f lower_;
  int width_ = 1;
  int height_ = 1;
};

/** \brief The object that most points of a voxel belong to. */
std::uint32_t
objectOfVoxel(const PointCells& cells,
              std::size_t voxel,
              const std::vector<std::uint32_t>& object_of_point,
              std::uint32_t object_count)
{
  std::uint32_t object = nothing;
  int lead = 0; // Boyer and Moore's vote
  for (auto k = cells.offsets[voxel]; k < cells.offsets[voxel + 1]; ++k) {
    const auto own = object_of_point[cells.points[k]];
    if (own >= object_count)
      continue;
    if (lead == 0)
      object = own;
    lead += own == object ? 1 : -1;
  }
  return object;
}

/** \brief Replace each value by the lowest one within column_reach columns, row by row
 * and then column by column. */
void
spreadLowest(const Columns& columns, std::vector<float>& values)
{
  const auto pass = [&values](int lines, int length, const auto& at) {
    std::vector<float> line(static_cast<std::size_t>(length));
    for (int l = 0; l < lines; ++l) {
      for (int k = 0; k < length; ++k)
        line[static_cast<std::size_t>(k)] = values[at(l, k)];
      for (int k = 0; k < length; ++k) {
        const auto first = line.begin() + std::max(k - column_reach, 0);
        const auto last = line.begin() + std::min(k + column_reach + 1, length);
        values[at(l, k)] = *std::min_element(first, last);
      }
    }
  };
  pass(columns.height(), columns.width(), [&](int y, int x) {
    return columns.index(x, y);
  });
  pass(columns.width(), columns.height(), [&](int x, int y) {
    return columns.index(x, y);
  });
}

/** \brief The lowest voxel around each column. */
std::vector<float>
floorHeights(const Columns& columns, const std::vector<Eigen::Vector3f>& centroids)
{
  std::vector<float> floor(columns.size(), std::numeric_limits<float>::infinity());
  for (const auto& centroid : centroids) {
    auto& lowest = floor[columns.indexOf(centroid)];
    lowest = std::min(lowest, centroid.z());
  }
  spreadLowest(columns, floor);
  return floor;
}

/** \brief From the lowest point to the median floor below the points. */
float
floorDistance(const Columns& columns,
              const std::vector<float>& floor,
              const std::vector<OrientedPoint>& points)
{
  std::vector<float> floors;
  float lowest = std::numeric_limits<float>::infinity();
  for (const auto& point : points) {
    floors.push_back(floor[columns.indexOf(point.position)]);
    lowest = std::min(lowest, point.position.z());
  }
  const auto middle = floors.begin() + static_cast<std::ptrdiff_t>(floors.size() / 2);
  std::nth_element(floors.begin(), middle, floors.end());
  return std::max(lowest - *middle, 0.0f);
}

} // namespace

std::vector<ObjectSurface>
objectSurfaces(const ObjectSegmentation& room,
               const std::vector<std::uint32_t>& object_of_point,
               std::uint32_t object_count)
{
  const auto& voxels = room.voxels;
  if (object_of_point.size() != voxels.cells.cell_of_point.size())
    PCL_THROW_EXCEPTION(BadArgumentException,
                        object_of_point.size()
                            << " objects do not fit "
                            << voxels.cells.cell_of_point.size() << " points");
  std::vector<ObjectSurface> surfaces(object_count);
  for (std::size_t voxel = 0; voxel < voxels.size(); ++voxel) {
    const auto object =
        objectOfVoxel(voxels.cells, voxel, object_of_point, object_count);
    if (object != nothing && voxels.normals[voxel].squaredNorm() > 0.5f)
      surfaces[object].points.push_back(
          {voxels.centroids[voxel], voxels.normals[voxel]});
  }
  const Columns columns(voxels.centroids);
  const auto floor = floorHeights(columns, voxels.centroids);
  for (auto& surface : surfaces)
    if (!surface.points.empty())
      surface.floor_distance = floorDistance(columns, floor, surface.points);
  return surfaces;
}

} // namespace indoor
} // namespace pcl
