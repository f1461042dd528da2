/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/convex_unions.h>

#include <pcl/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <numeric>
#include <queue>
#include <tuple>

namespace {

using pcl::indoor::ConvexUnionOptions;
using pcl::indoor::SurfaceVoxels;

constexpr std::size_t direction_count = 50;

/** How far a set of places reaches in each of the directions. */
using Reach = std::array<float, direction_count>;

/** Fixed directions and the volume between their half-spaces. */
class Polytopes {
public:
  explicit Polytopes(const Eigen::Matrix3f& axes)
  : axes_(axes)
  {
    // Normals of a cube's faces, edges and corners, and those half-way between the
    // first two kinds, shortest first: the axes themselves come at 0 to 5.
    std::size_t next = 0;
    for (const int length : {1, 2, 3, 5})
      for (int x = -2; x <= 2; ++x)
        for (int y = -2; y <= 2; ++y)
          for (int z = -2; z <= 2; ++z)
            if (x * x + y * y + z * z == length)
              directions_[next++] = Eigen::Vector3f(x, y, z).normalized();
  }

  Reach
  reachOf(const std::vector<Eigen::Vector3f>& places, float margin) const
  {
    Reach reach;
    std::vector<float> heights(places.size());
    const auto rest = static_cast<std::ptrdiff_t>(places.size() / 100); // outliers
    for (std::size_t d = 0; d < direction_count; ++d) {
      const Eigen::Vector3f direction = axes_ * directions_[d];
      std::transform(places.begin(), places.end(), heights.begin(), [&](const auto& p) {
        return direction.dot(p);
      });
      const auto last = heights.end() - 1 - rest;
      std::nth_element(heights.begin(), last, heights.end());
      reach[d] = *last + margin;
    }
    return reach;
  }

  /** By samples in the box around. */
  double
  volume(const Reach& reach) const
  {
    constexpr int samples = 12; // in each direction
    const Eigen::Array3f low(-reach[0], -reach[1], -reach[2]);
    const Eigen::Array3f high(reach[5], reach[4], reach[3]);
    const Eigen::Array3f step = (high - low) / samples;
    int inside = 0;
    for (int x = 0; x < samples; ++x)
      for (int y = 0; y < samples; ++y)
        for (int z = 0; z < samples; ++z) {
          const Eigen::Vector3f place =
              low + step * (Eigen::Array3f(x, y, z) + Eigen::Array3f::Constant(0.5f));
          inside += holds(reach, place);
        }
    return static_cast<double>(step.prod()) * inside;
  }

private:
  bool
  holds(const Reach& reach, const Eigen::Vector3f& place) const
  {
    for (std::size_t d = 6; d < direction_count; ++d)
      if (directions_[d].dot(place) > reach[d])
        return false;
    return true;
  }

  Eigen::Matrix3f axes_;
  std::array<Eigen::Vector3f, direction_count> directions_; // in the frame of the axes
};

/** Segments that are joined, each known by one of them. */
class Unions {
public:
  Unions(const SurfaceVoxels& voxels,
         const std::vector<std::uint8_t>& left_out,
         const std::vector<std::uint32_t>& segment_of_voxel,
         const ConvexUnionOptions& options)
  : polytopes_(options.axes)
  , max_growth_(options.max_growth)
  {
    const auto count =
        1 + *std::max_element(segment_of_voxel.begin(), segment_of_voxel.end());
    parent_.resize(count);
    std::iota(parent_.begin(), parent_.end(), 0u);
    version_.assign(count, 0);
    reach_.resize(count);
    volume_.assign(count, 0);
    neighbors_.resize(count);
    std::vector<std::vector<Eigen::Vector3f>> places(count);
    for (std::size_t v = 0; v < voxels.size(); ++v) {
      if (left_out[v])
        continue;
      const auto segment = segment_of_voxel[v];
      places[segment].push_back(voxels.centroids[v]);
      for (auto j = voxels.neighbors.offsets[v]; j < voxels.neighbors.offsets[v + 1];
           ++j) {
        const auto other = voxels.neighbors.targets[j];
        if (!left_out[other] && segment_of_voxel[other] != segment)
          neighbors_[segment][segment_of_voxel[other]] = true;
      }
    }
    const float margin = 0.5f * static_cast<float>(options.voxel_size);
    for (std::uint32_t s = 0; s < count; ++s)
      if (!places[s].empty()) {
        reach_[s] = polytopes_.reachOf(places[s], margin);
        volume_[s] = polytopes_.volume(reach_[s]);
      }
    for (std::uint32_t a = 0; a < count; ++a)
      for (const auto& entry : neighbors_[a])
        if (a < entry.first)
          propose(a, entry.first);
  }

  void
  joinAll()
  {
    while (!queue_.empty()) {
      const auto [growth, a, b, version_a, version_b] = queue_.top();
      queue_.pop();
      // A segment that was joined since has another version, or another name.
      if (version_[a] == version_a && version_[b] == version_b)
        join(a, b);
    }
  }

  std::uint32_t
  find(std::uint32_t segment)
  {
    while (parent_[segment] != segment)
      segment = parent_[segment] = parent_[parent_[segment]];
    return segment;
  }

private:
  using Proposal =
      std::tuple<double, std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;

  Reach
  reachOfBoth(std::uint32_t a, std::uint32_t b) const
  {
    Reach both;
    for (std::size_t d = 0; d < direction_count; ++d)
      both[d] = std::max(reach_[a][d], reach_[b][d]);
    return both;
  }

  void
  propose(std::uint32_t a, std::uint32_t b)
  {
    const double growth =
        polytopes_.volume(reachOfBoth(a, b)) / (volume_[a] + volume_[b]);
    if (growth <= max_growth_)
      queue_.emplace(growth,
                     std::min(a, b),
                     std::max(a, b),
                     version_[std::min(a, b)],
                     version_[std::max(a, b)]);
  }

  void
  join(std::uint32_t a, std::uint32_t b)
  {
    const bool a_has_more = neighbors_[a].size() >= neighbors_[b].size();
    const auto kept = a_has_more ? a : b, gone = a_has_more ? b : a;
    const Reach both = reachOfBoth(a, b);
    const bool grows = both != reach_[kept];
    if (grows) {
      reach_[kept] = both;
      volume_[kept] = polytopes_.volume(both);
      ++version_[kept];
    }
    parent_[gone] = kept;
    ++version_[gone];
    std::map<std::uint32_t, bool> moved;
    moved.swap(neighbors_[gone]);
    moved.erase(kept);
    neighbors_[kept].erase(gone);
    for (const auto& entry : moved) {
      neighbors_[entry.first].erase(gone);
      neighbors_[entry.first][kept] = true;
      neighbors_[kept][entry.first] = true;
    }
    // What a segment proposed before holds on if only its inside was filled.
    for (const auto& entry : grows ? neighbors_[kept] : moved)
      propose(kept, entry.first);
  }

  Polytopes polytopes_;
  double max_growth_;
  std::vector<std::uint32_t> parent_, version_;
  std::vector<Reach> reach_;
  std::vector<double> volume_;
  std::vector<std::map<std::uint32_t, bool>> neighbors_;
  std::priority_queue<Proposal, std::vector<Proposal>, std::greater<Proposal>> queue_;
};

} // namespace

namespace pcl {
namespace indoor {

void
joinConvexUnions(const SurfaceVoxels& voxels,
                 const std::vector<std::uint8_t>& left_out,
                 const ConvexUnionOptions& options,
                 std::vector<std::uint32_t>& segment_of_voxel)
{
  if (left_out.size() != voxels.size() || segment_of_voxel.size() != voxels.size())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        voxels.size()
                            << " voxels have " << left_out.size() << " flags and "
                            << segment_of_voxel.size() << " segments.");
  if (!(options.max_growth >= 0) || !(options.voxel_size > 0))
    PCL_THROW_EXCEPTION(
        pcl::BadArgumentException,
        "Convex unions need a growth of at least 0 and a positive voxel "
        "size, not "
            << options.max_growth << " and " << options.voxel_size << ".");
  if (voxels.size() == 0 || options.max_growth == 0)
    return;
  Unions unions(voxels, left_out, segment_of_voxel, options);
  unions.joinAll();
  for (std::size_t v = 0; v < voxels.size(); ++v)
    if (!left_out[v])
      segment_of_voxel[v] = unions.find(segment_of_voxel[v]);
}

} // namespace indoor
} // namespace pcl
