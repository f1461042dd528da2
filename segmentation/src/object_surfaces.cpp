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
constexpr int column_reach = 3;     // columns around an object that show floor, ceiling
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

/** \brief Replace each value by the best one within column_reach columns, row by row
 * and then column by column. */
template <typename Better>
void
spread(const Columns& columns, std::vector<float>& values, const Better& better)
{
  const auto pass = [&](int lines, int length, const auto& at) {
    std::vector<float> line(static_cast<std::size_t>(length));
    for (int l = 0; l < lines; ++l) {
      for (int k = 0; k < length; ++k)
        line[static_cast<std::size_t>(k)] = values[at(l, k)];
      for (int k = 0; k < length; ++k) {
        const int first = std::max(k - column_reach, 0);
        const int last = std::min(k + column_reach, length - 1);
        float best = line[static_cast<std::size_t>(first)];
        for (int other = first + 1; other <= last; ++other)
          best = better(best, line[static_cast<std::size_t>(other)]);
        values[at(l, k)] = best;
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

/** \brief The lowest and the highest voxel around each column. */
struct FloorAndCeiling {
  FloorAndCeiling(const Columns& columns, const std::vector<Eigen::Vector3f>& centroids)
  : floor(columns.size(), std::numeric_limits<float>::infinity())
  , ceiling(columns.size(), -std::numeric_limits<float>::infinity())
  {
    for (const auto& centroid : centroids) {
      const auto column = columns.indexOf(centroid);
      floor[column] = std::min(floor[column], centroid.z());
      ceiling[column] = std::max(ceiling[column], centroid.z());
    }
    spread(columns, floor, [](float a, float b) { return std::min(a, b); });
    spread(columns, ceiling, [](float a, float b) { return std::max(a, b); });
  }

  std::vector<float> floor;
  std::vector<float> ceiling;
};

float
median(std::vector<float>& values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/** \brief Set the distances of an object from floor and ceiling. */
void
measureHeights(const Columns& columns,
               const FloorAndCeiling& room,
               ObjectSurface& surface)
{
  std::vector<float> floors, ceilings;
  float lowest = std::numeric_limits<float>::infinity();
  float highest = -lowest;
  for (const auto& point : surface.points) {
    const auto column = columns.indexOf(point.position);
    floors.push_back(room.floor[column]);
    ceilings.push_back(room.ceiling[column]);
    lowest = std::min(lowest, point.position.z());
    highest = std::max(highest, point.position.z());
  }
  surface.floor_distance = std::max(lowest - median(floors), 0.0f);
  surface.ceiling_distance = std::max(median(ceilings) - highest, 0.0f);
}

/** \brief The two nearest walls of different objects around each column: the distance
 * of the nearest, and of the nearest that is another object. */
class WallDistances {
public:
  explicit WallDistances(const Columns& columns)
  : columns_(columns)
  , nearest_(columns.size())
  , second_(columns.size())
  {}

  void
  addWall(std::size_t column, std::uint32_t object)
  {
    offer(column, {0.0f, object});
  }

  /** \brief Two sweeps of a chamfer distance, in columns. */
  void
  sweep()
  {
    constexpr float diagonal = 1.41421356f;
    const auto visit = [&](int x, int y, int step) {
      const auto from = [&](int dx, int dy, float distance) {
        const int nx = x + dx, ny = y + dy;
        if (nx < 0 || ny < 0 || nx >= columns_.width() || ny >= columns_.height())
          return;
        const auto other = columns_.index(nx, ny);
        offer(columns_.index(x, y), farther(nearest_[other], distance));
        offer(columns_.index(x, y), farther(second_[other], distance));
      };
      from(-step, 0, 1.0f);
      from(-step, -step, diagonal);
      from(0, -step, 1.0f);
      from(step, -step, diagonal);
    };
    for (int y = 0; y < columns_.height(); ++y)
      for (int x = 0; x < columns_.width(); ++x)
        visit(x, y, 1);
    for (int y = columns_.height() - 1; y >= 0; --y)
      for (int x = columns_.width() - 1; x >= 0; --x)
        visit(x, y, -1);
  }

  /** \brief Metres from a column to the nearest wall that is not the object. */
  float
  at(std::size_t column, std::uint32_t object) const
  {
    const auto& wall =
        nearest_[column].object == object ? second_[column] : nearest_[column];
    return std::min(column_size * wall.distance, farthest_wall);
  }

private:
  struct Wall {
    float distance = std::numeric_limits<float>::infinity(); // columns
    std::uint32_t object = nothing;
  };

  static Wall
  farther(Wall wall, float distance)
  {
    wall.distance += distance;
    return wall;
  }

  void
  offer(std::size_t column, const Wall& wall)
  {
    auto& first = nearest_[column];
    auto& second = second_[column];
    if (wall.distance < first.distance) {
      if (wall.object != first.object)
        second = first;
      first = wall;
    }
    else if (wall.object != first.object && wall.distance < second.distance)
      second = wall;
  }

  const Columns& columns_;
  std::vector<Wall> nearest_;
  std::vector<Wall> second_;
};

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
  const Columns columns(voxels.centroids);
  WallDistances walls(columns);
  for (std::size_t voxel = 0; voxel < voxels.size(); ++voxel) {
    const auto& normal = voxels.normals[voxel];
    const auto object =
        objectOfVoxel(voxels.cells, voxel, object_of_point, object_count);
    if (room.plane_of_voxel[voxel] != 0 && std::abs(normal.z()) < 0.5f)
      walls.addWall(columns.indexOf(voxels.centroids[voxel]), object);
    if (object != nothing && normal.squaredNorm() > 0.5f)
      surfaces[object].points.push_back({voxels.centroids[voxel], normal});
  }
  walls.sweep();
  const FloorAndCeiling heights(columns, voxels.centroids);
  for (std::uint32_t object = 0; object < object_count; ++object) {
    auto& surface = surfaces[object];
    if (surface.points.empty())
      continue;
    measureHeights(columns, heights, surface);
    surface.wall_distance = farthest_wall;
    for (const auto& point : surface.points)
      surface.wall_distance = std::min(
          surface.wall_distance, walls.at(columns.indexOf(point.position), object));
  }
  return surfaces;
}

} // namespace indoor
} // namespace pcl
