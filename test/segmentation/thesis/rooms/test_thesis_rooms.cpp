/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

/* The thesis's preset against chapter 3 by its definitions: dense matrices, no index
 * and no sparse solver. The interior space is that of the library, whose cut has a test
 * of its own. */

#include "rooms/map/building_steps.h"
#include "rooms/storeys/storey_space.h"
#include "segmentation/clustering/hdbscan_brute_force.h"
#include "support/synthetic_scenes.h"
#include "thesis/rooms/field_connectivity.h"
#include "thesis/rooms/field_rooms.h"

#include <pcl/segmentation/thesis.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

using namespace pcl::indoor;

namespace {

using Matrix = std::vector<std::vector<double>>;
using Voxel = Eigen::Vector3i;

template <typename Visit>
void
forEachVoxel(const GridShape& shape, const Visit& visit)
{
  for (int x = 0; x < shape.nx; ++x)
    for (int y = 0; y < shape.ny; ++y)
      for (int z = 0; z < shape.nz; ++z)
        visit(Voxel(x, y, z));
}

/** Whether the segment between two voxels' centres crosses the inside of a third. All
 * is doubled, so that it stays in integers; times are fractions of num over den. */
bool
crosses(const Voxel& from, const Voxel& to, const Voxel& box)
{
  double enter = 0, leave = 1; // exact: short integers over short integers
  for (int axis = 0; axis < 3; ++axis) {
    const double start = 2.0 * from[axis] + 1, step = 2.0 * (to[axis] - from[axis]);
    const double low = 2.0 * box[axis], high = low + 2;
    if (step == 0) {
      if (start <= low || start >= high)
        return false;
      continue;
    }
    const double a = (low - start) / step, b = (high - start) / step;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return leave - enter > 1e-9; // corners and edges are not the inside
}

/** Chapter 3 by its definitions, from the interior space on. */
class DenseRooms {
public:
  DenseRooms(const InteriorSpace& space, const thesis::FieldRoomsOptions& options)
  : space_(space)
  , options_(options)
  {
    findOccupied();
    findField();
    findClusters();
    addPeaks();
    walk();
  }

  /** "Occupied voxels" of Sec. 3.2.3: the ten nearest vote, with those as far as the
   * tenth; of equal votes the nearer ones win. */
  int
  labelOf(const Voxel& voxel) const
  {
    const auto own = [&](const Voxel& v) {
      return inside(v) ? labels.at(column(v)) : -1;
    };
    if (!space_.occupancy.at(voxel.x(), voxel.y(), voxel.z()))
      return own(voxel);
    std::vector<std::pair<int, int>> voters; // squared distance, label
    forEachVoxel(space_.occupancy.shape, [&](const Voxel& v) {
      const int distance = (v - voxel).squaredNorm();
      if (distance <= 15 * 15 && own(v) >= 0)
        voters.emplace_back(distance, own(v));
    });
    std::sort(voters.begin(), voters.end());
    std::map<int, std::pair<int, int>> counts; // minus votes, distances
    for (std::size_t i = 0; i < voters.size(); ++i) {
      if (i >= 10 && voters[i].first > voters[9].first)
        break;
      --counts[voters[i].second].first;
      counts[voters[i].second].second += voters[i].first;
    }
    int best = -1;
    for (const auto& [label, count] : counts)
      if (best < 0 || count < counts.at(best))
        best = label;
    return best;
  }

  std::map<std::pair<int, int>, int> clusters, labels; // by column
  std::map<std::pair<int, int>, float> field;

private:
  static std::pair<int, int>
  column(const Voxel& v)
  {
    return {v.x(), v.y()};
  }

  bool
  inside(const Voxel& v) const
  {
    return space_.inside.at(v.x(), v.y(), v.z()) &&
           !space_.occupancy.at(v.x(), v.y(), v.z());
  }

  void
  findOccupied()
  {
    forEachVoxel(space_.occupancy.shape, [&](const Voxel& v) {
      if (space_.occupancy.at(v.x(), v.y(), v.z()))
        occupied_.push_back(v);
    });
  }

  void
  findField()
  {
    std::vector<float> values;
    forEachVoxel(space_.occupancy.shape, [&](const Voxel& v) {
      if (!inside(v))
        return;
      int nearest = std::numeric_limits<int>::max();
      for (const auto& other : occupied_)
        if (other.z() >= v.z())
          nearest = std::min(nearest, (other - v).squaredNorm());
      auto& highest = highest_.emplace(column(v), v).first->second;
      highest = v.z() > highest.z() ? v : highest;
      if (nearest < std::numeric_limits<int>::max())
        field[column(v)] = std::max(field[column(v)], static_cast<float>(nearest));
    });
    for (const auto& entry : field) {
      values.push_back(entry.second);
      pixels_.push_back(entry.first);
    }
    thresholds_ = histogramPeaks(values, options_.peaks);
  }

  bool
  sees(const Voxel& from, const Voxel& to) const
  {
    const Voxel low = from.cwiseMin(to), high = from.cwiseMax(to);
    return std::none_of(occupied_.begin(), occupied_.end(), [&](const Voxel& other) {
      return (other.array() >= low.array()).all() &&
             (other.array() <= high.array()).all() && other != from && other != to &&
             crosses(from, to, other);
    });
  }

  /** Numbers of the components of the pixels of at least a threshold. */
  std::map<std::pair<int, int>, int>
  components(const std::set<std::pair<int, int>>& members) const
  {
    std::map<std::pair<int, int>, int> number;
    int next = 0;
    for (const auto& seed : members) {
      if (number.count(seed) > 0)
        continue;
      std::vector<std::pair<int, int>> stack{seed};
      number[seed] = next;
      while (!stack.empty()) {
        const auto [x, y] = stack.back();
        stack.pop_back();
        for (int u = x - 1; u <= x + 1; ++u)
          for (int v = y - 1; v <= y + 1; ++v)
            if (members.count({u, v}) > 0 &&
                number.emplace(std::make_pair(u, v), next).second)
              stack.emplace_back(u, v);
      }
      ++next;
    }
    return number;
  }

  void
  findClusters()
  {
    const std::size_t n = pixels_.size();
    float a = 0;
    for (const auto& entry : field)
      a = std::max(a, entry.second);
    Matrix by_field(n, std::vector<double>(n, a)); // Eq. (3.3), in the order of k
    for (auto threshold = thresholds_.rbegin(); threshold != thresholds_.rend();
         ++threshold) {
      std::set<std::pair<int, int>> above;
      for (const auto& entry : field)
        if (entry.second >= *threshold)
          above.insert(entry.first);
      const auto part_of = components(above);
      std::vector<int> number(n, -1);
      for (std::size_t i = 0; i < n; ++i)
        if (part_of.count(pixels_[i]) > 0)
          number[i] = part_of.at(pixels_[i]);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          if (number[i] >= 0 && number[i] == number[j] && by_field[i][j] == a)
            by_field[i][j] = a - *threshold;
    }
    std::vector<std::vector<char>> seen(n, std::vector<char>(n, 1)); // s of Eq. (3.5)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < i; ++j)
        seen[i][j] = seen[j][i] =
            sees(highest_.at(pixels_[i]), highest_.at(pixels_[j]));
    double longest = 0;
    const auto apart = [&](std::size_t i, std::size_t j) {
      return std::hypot(pixels_[i].first - pixels_[j].first,
                        pixels_[i].second - pixels_[j].second);
    };
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        longest = std::max(longest, apart(i, j));
    Matrix distance(n, std::vector<double>(n, 0)); // Eq. (3.4)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        double differing = 0, sum = 0;
        for (std::size_t k = 0; k < n; ++k) {
          differing += seen[i][k] != seen[j][k];
          sum += seen[i][k] + seen[j][k];
        }
        distance[i][j] = 0.05 * differing / sum + 0.7 * apart(i, j) / longest +
                         0.25 * (i == j ? 0.0 : by_field[i][j] / a);
      }
    HDBSCANOptions clustering;
    clustering.min_cluster_size = 50; // 2 m^2
    clustering.min_samples = 10;      // 0.4 m^2
    const HDBSCANBruteForce dense(distance, clustering);
    for (std::size_t i = 0; i < n; ++i)
      clusters[pixels_[i]] = dense.labels[i];
  }

  void
  addPeaks()
  {
    labels = clusters;
    int next = 0;
    std::set<std::pair<int, int>> left_out;
    for (const auto& [pixel, label] : clusters) {
      next = std::max(next, label + 1);
      if (label < 0 && field.at(pixel) >= thresholds_.front())
        left_out.insert(pixel);
    }
    std::map<int, std::vector<std::pair<int, int>>> parts;
    for (const auto& [pixel, number] : components(left_out))
      parts[number].push_back(pixel);
    for (const auto& entry : parts)
      if (entry.second.size() >= 50) {
        for (const auto& pixel : entry.second)
          labels[pixel] = next;
        ++next;
      }
    label_count_ = next;
  }

  /** Eq. (2.11) to (2.13), one dense system for all pixels without a label. */
  void
  walk()
  {
    float highest = 0;
    for (const auto& entry : field)
      highest = std::max(highest, entry.second);
    std::vector<std::pair<int, int>> open;
    std::map<std::pair<int, int>, int> row;
    for (const auto& [pixel, label] : labels)
      if (label < 0) {
        row[pixel] = static_cast<int>(open.size());
        open.push_back(pixel);
      }
    const auto size = static_cast<Eigen::Index>(open.size());
    Eigen::MatrixXd laplacian = Eigen::MatrixXd::Zero(size, size);
    Eigen::MatrixXd seeds = Eigen::MatrixXd::Zero(size, label_count_);
    for (Eigen::Index i = 0; i < size; ++i) {
      const auto [x, y] = open[i];
      for (const auto& other : {std::make_pair(x - 1, y),
                                std::make_pair(x + 1, y),
                                std::make_pair(x, y - 1),
                                std::make_pair(x, y + 1)}) {
        if (labels.count(other) == 0)
          continue;
        const double step =
            (static_cast<double>(field.at(open[i])) - field.at(other)) / highest;
        const double w = std::max(std::exp(-100 * step * step), 1e-10);
        laplacian(i, i) += w;
        if (labels.at(other) >= 0)
          seeds(i, labels.at(other)) += w;
        else
          laplacian(i, row.at(other)) -= w;
      }
    }
    const Eigen::MatrixXd probability = laplacian.fullPivLu().solve(seeds);
    for (Eigen::Index i = 0; i < size; ++i) {
      Eigen::Index best = 0;
      probability.row(i).maxCoeff(&best);
      labels[open[i]] = static_cast<int>(best);
    }
  }

  const InteriorSpace& space_;
  const thesis::FieldRoomsOptions& options_;
  std::vector<Voxel> occupied_;
  std::vector<std::pair<int, int>> pixels_; // with a field
  std::map<std::pair<int, int>, Voxel> highest_;
  std::vector<float> thresholds_;
  int label_count_ = 0;
};

/** Two rooms with a door, a table in one of them. */
std::vector<Eigen::Vector3f>
smallRooms()
{
  auto scene =
      test::rooms({{{0, 0, 0}, {2, 1.8f, 2.2f}, 1}, {{2.2f, 0, 0}, {4, 1.8f, 2.2f}, 2}},
                  {test::doorway(1.95f, 2.25f, 0.6f, 1.2f, 1.8f)});
  std::mt19937 rng(2);
  scene.addBox({0.4f, 0.6f, 0}, {0.7f, 0.5f, 0.75f}, 1, 0.04f, 0.005f, rng);
  return scene.points;
}

void
expectAsDefined(const std::vector<Eigen::Vector3f>& points, std::size_t least_rooms)
{
  const auto options = thesisRoomOptions();
  const auto building = segmentBuilding(points, options);
  ASSERT_EQ(building.maps.size(), 1u);
  EXPECT_GE(building.rooms.size(), least_rooms);
  const auto& steps = stepsOf(building);
  EXPECT_EQ(steps.occupancy.yaw, 0.0);
  EXPECT_EQ(steps.interior.factor, 1);
  const auto space =
      storeySpace(steps.occupancy.grid, steps.interior, steps.storeys, 0);
  const DenseRooms dense(space.interior, options.field);

  const auto found = segmentFieldMap(space.interior, options.field);
  EXPECT_EQ(building.maps.front().potential.values, found.field.values);
  std::map<int, int> name; // of the dense version's labels
  for (int x = 0; x < found.clusters.nx; ++x)
    for (int y = 0; y < found.clusters.ny; ++y) {
      const auto field = dense.field.find({x, y});
      ASSERT_EQ(found.field.at(x, y),
                field == dense.field.end() ? 0.0f : field->second);
      if (field == dense.field.end())
        continue;
      ASSERT_EQ(found.clusters.at(x, y), dense.clusters.at({x, y})) << x << ' ' << y;
      const int label = dense.labels.at({x, y});
      ASSERT_EQ(name.emplace(label, found.labels.at(x, y)).first->second,
                found.labels.at(x, y));
    }

  const auto& grid = steps.occupancy.grid;
  std::map<std::int32_t, int> voted;
  std::map<int, std::uint32_t> room_of;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::int32_t cell = steps.occupancy.cells[i];
    if (voted.count(cell) == 0) {
      const int pixel = cell / grid.shape.nz;
      voted[cell] = dense.labelOf({pixel / grid.shape.ny,
                                   pixel % grid.shape.ny,
                                   cell % grid.shape.nz - space.first_layer});
    }
    const int label = voted.at(cell);
    const std::uint32_t expected =
        label < 0 ? 0 : room_of.emplace(label, building.point_labels[i]).first->second;
    ASSERT_EQ(building.point_labels[i], expected) << points[i].transpose();
  }
  EXPECT_EQ(room_of.size(), building.rooms.size());
}

} // namespace

TEST(ThesisRooms, TwoRoomsAsDefined) { expectAsDefined(smallRooms(), 2); }

TEST(ThesisRooms, TurnedRoomsAsDefined)
{
  auto points = smallRooms();
  const Eigen::AngleAxisf turn(0.4f, Eigen::Vector3f::UnitZ());
  for (auto& point : points)
    point = turn * point;
  expectAsDefined(points, 1); // so small, HDBSCAN finds one cluster
}

TEST(ThesisRooms, DominantDirectionsFollowLeaningWalls)
{
  // two pairs of walls; those along y lean by 20 degrees
  std::mt19937 rng(3);
  test::LabelledPoints room;
  const float lean = std::tan(20.0f * static_cast<float>(M_PI) / 180);
  room.addBox({0, 0, 0}, {6, 4, 2.6f}, 1, 0.04f, 0.004f, rng);
  for (auto& point : room.points)
    point.x() += lean * point.z();
  OccupancyGridOptions grid;
  grid.voxel_size = 0.2;
  const auto building = occupancyGrid(room.points, grid);
  const auto directions =
      dominantDirections(room.points, building, thesisRoomOptions().shared.interior);
  ASSERT_EQ(directions.size(), 2u);
  const Eigen::Vector3d leaning = Eigen::Vector3d(1, 0, -lean).normalized();
  for (const auto& expected : {leaning, Eigen::Vector3d(Eigen::Vector3d::UnitY())})
    EXPECT_GT(std::max(std::abs(directions[0].dot(expected)),
                       std::abs(directions[1].dot(expected))),
              std::cos(0.03));
  for (const auto& level :
       wallDirections(room.points, building, thesisRoomOptions().shared.interior))
    EXPECT_LT(std::min(std::abs(level.x()), std::abs(level.y())), 0.03);
}

TEST(ThesisRooms, DefaultsAreNoneOfIt)
{
  const BuildingRoomsOptions options;
  EXPECT_TRUE(options.align_grid && options.interior.upright_walls);
  EXPECT_EQ(findProblem(thesisRoomOptions()), "");
}
