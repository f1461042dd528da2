/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/convex_unions.h>
#include <pcl/segmentation/direction_hull.h>

#include "segment_boxes.h"

#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <queue>
#include <tuple>

namespace {

using pcl::indoor::commonHull;
using pcl::indoor::ConvexUnionOptions;
using pcl::indoor::DirectionHulls;
using pcl::indoor::hullOfBoth;
using pcl::indoor::HullReach;
using pcl::indoor::SurfaceVoxels;

constexpr double never = std::numeric_limits<double>::infinity();

/** A set of voxels. */
struct Piece {
  std::size_t size = 0; ///< voxels; 0 = there is no such piece
  HullReach reach;
  double volume = 0, box_volume = 0; // m^3
};

/** How a piece touches another. */
struct Contact {
  double share = 0;  ///< of its voxels that touch the other
  double length = 0; ///< over the side of a square as large as the piece
};

Contact
contactOf(std::size_t size, std::size_t touching)
{
  const auto count = static_cast<double>(std::min(size, touching));
  return {count / static_cast<double>(size),
          count / std::sqrt(static_cast<double>(size))};
}

/** What the union of two pieces holds beyond them, over the smaller one. */
double
airOf(double both, double common, double a, double b)
{
  return (both - a - b + common) / std::min(a, b);
}

/** The rule by which two pieces are one. */
class UnionRule {
public:
  explicit UnionRule(const ConvexUnionOptions& options)
  : options_(options)
  , hulls_(options.axes)
  {}

  Piece
  pieceOf(const std::vector<Eigen::Vector3f>& places) const
  {
    Piece piece;
    piece.size = places.size();
    piece.reach =
        hulls_.reachOf(places, 0.5f * static_cast<float>(options_.voxel_size));
    measure(piece);
    return piece;
  }

  /** \return whether the hull has become larger */
  bool
  add(const Piece& other, Piece& piece) const
  {
    piece.size += other.size;
    const auto reach = hullOfBoth(piece.reach, other.reach);
    if (reach == piece.reach)
      return false;
    piece.reach = reach;
    measure(piece);
    return true;
  }

  /** Air for the contact, as a share of what is allowed; never if above it. */
  double
  cost(const Piece& a, const Piece& b, const Contact& contact) const
  {
    const auto [smaller, larger] = std::minmax(a.size, b.size);
    if (contact.length < options_.min_contact_length ||
        static_cast<double>(smaller) >
            options_.max_size_ratio * static_cast<double>(larger))
      return never;
    const auto both = hullOfBoth(a.reach, b.reach);
    const double volume = hulls_.volume(both);
    // Nothing need be in common: a first bound
    if (airOf(volume, 0, a.volume, b.volume) > options_.max_air)
      return never;
    const auto common = commonHull(a.reach, b.reach);
    const double air = airOf(volume, hulls_.volume(common), a.volume, b.volume);
    if (air > options_.max_air)
      return never;
    const double box_air = airOf(
        hulls_.boxVolume(both), hulls_.boxVolume(common), a.box_volume, b.box_volume);
    const auto over = [&](double held, double per_contact) {
      return per_contact > 0 ? held / (per_contact * contact.share) : never;
    };
    const double cost = std::min(over(air, options_.air_per_contact),
                                 over(box_air, options_.box_air_per_contact));
    return cost <= 1 ? cost : never;
  }

  bool
  limitsSizes() const
  {
    return options_.max_size_ratio < 1;
  }

private:
  void
  measure(Piece& piece) const
  {
    piece.volume = hulls_.volume(piece.reach);
    piece.box_volume = hulls_.boxVolume(piece.reach);
  }

  ConvexUnionOptions options_;
  DirectionHulls hulls_;
};

/** Segments that are joined, each known by one of them. */
class Unions {
public:
  Unions(const SurfaceVoxels& voxels,
         const std::vector<std::uint8_t>& left_out,
         const std::vector<std::uint32_t>& segment_of_voxel,
         const ConvexUnionOptions& options)
  : rule_(options)
  {
    const auto count =
        1 + *std::max_element(segment_of_voxel.begin(), segment_of_voxel.end());
    parent_.resize(count);
    std::iota(parent_.begin(), parent_.end(), 0u);
    version_.assign(count, 0);
    pieces_.resize(count);
    touching_.resize(count);
    std::vector<std::vector<Eigen::Vector3f>> places(count);
    std::vector<std::uint32_t> around;
    for (std::size_t v = 0; v < voxels.size(); ++v) {
      if (left_out[v])
        continue;
      const auto segment = segment_of_voxel[v];
      places[segment].push_back(voxels.centroids[v]);
      around.clear();
      for (auto j = voxels.neighbors.offsets[v]; j < voxels.neighbors.offsets[v + 1];
           ++j) {
        const auto other = voxels.neighbors.targets[j];
        if (!left_out[other] && segment_of_voxel[other] != segment)
          around.push_back(segment_of_voxel[other]);
      }
      std::sort(around.begin(), around.end());
      around.erase(std::unique(around.begin(), around.end()), around.end());
      for (const auto other : around)
        ++touching_[segment][other];
    }
    for (std::uint32_t s = 0; s < count; ++s)
      if (!places[s].empty())
        pieces_[s] = rule_.pieceOf(places[s]);
    for (std::uint32_t a = 0; a < count; ++a)
      for (const auto& entry : touching_[a])
        if (a < entry.first)
          propose(a, entry.first);
  }

  void
  joinAll()
  {
    while (!queue_.empty()) {
      const auto [cost, a, b, version_a, version_b] = queue_.top();
      queue_.pop();
      // A segment whose hull has grown has another version, or another name.
      if (version_[a] != version_a || version_[b] != version_b)
        continue;
      // What was joined without making a hull larger may still have changed the cost.
      const double cost_now = costOf(a, b);
      if (cost_now <= cost)
        join(a, b);
      else if (cost_now < never)
        queue_.emplace(cost_now, a, b, version_a, version_b);
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

  double
  costOf(std::uint32_t a, std::uint32_t b) const
  {
    const auto contact_a = contactOf(pieces_[a].size, touching_[a].at(b)),
               contact_b = contactOf(pieces_[b].size, touching_[b].at(a));
    return rule_.cost(pieces_[a],
                      pieces_[b],
                      contact_a.share > contact_b.share ? contact_a : contact_b);
  }

  void
  propose(std::uint32_t a, std::uint32_t b)
  {
    const double cost = costOf(a, b);
    const auto first = std::min(a, b), second = std::max(a, b);
    if (cost < never)
      queue_.emplace(cost, first, second, version_[first], version_[second]);
  }

  void
  join(std::uint32_t a, std::uint32_t b)
  {
    const bool a_has_more = touching_[a].size() >= touching_[b].size();
    const auto kept = a_has_more ? a : b, gone = a_has_more ? b : a;
    const bool grows = rule_.add(pieces_[gone], pieces_[kept]);
    version_[kept] += grows;
    ++version_[gone];
    parent_[gone] = kept;
    std::map<std::uint32_t, std::size_t> moved;
    moved.swap(touching_[gone]);
    moved.erase(kept);
    touching_[kept].erase(gone);
    for (const auto& [other, count] : moved) {
      touching_[kept][other] += count;
      touching_[other][kept] += touching_[other].at(gone);
      touching_[other].erase(gone);
    }
    // What a segment proposed before holds on if only its inside was filled; but it may
    // be large enough now for what was too large beside it.
    for (const auto& entry : grows || rule_.limitsSizes() ? touching_[kept] : moved)
      propose(kept, entry.first);
  }

  UnionRule rule_;
  std::vector<std::uint32_t> parent_, version_;
  std::vector<Piece> pieces_;
  /** by the other segment: how many voxels touch it; voxels of segments that were
   * joined may count twice */
  std::vector<std::map<std::uint32_t, std::size_t>> touching_;
  std::priority_queue<Proposal, std::vector<Proposal>, std::greater<Proposal>> queue_;
};

void
requireValid(const ConvexUnionOptions& options)
{
  const auto require = [](double value, const char* name) {
    if (!(value >= 0))
      PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                          "Convex unions need " << name << " of at least 0, not "
                                                << value << ".");
  };
  require(options.air_per_contact, "air per contact");
  require(options.box_air_per_contact, "air of boxes per contact");
  require(options.max_air, "a limit of the air");
  require(options.min_contact_length, "a length of contact");
  if (!(options.max_size_ratio > 0))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "Convex unions need a positive ratio of sizes, not "
                            << options.max_size_ratio << ".");
  if (!(options.voxel_size > 0))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "Convex unions need a positive voxel size, not "
                            << options.voxel_size << " m.");
}

} // namespace

namespace pcl {
namespace indoor {

void
joinConvexUnions(const SurfaceVoxels& voxels,
                 const std::vector<std::uint8_t>& left_out,
                 const ConvexUnionOptions& options,
                 std::vector<std::uint32_t>& segment_of_voxel)
{
  requireOnePerVoxel(voxels, left_out, segment_of_voxel);
  requireValid(options);
  if (voxels.size() == 0 || options.air_per_contact == 0)
    return;
  Unions unions(voxels, left_out, segment_of_voxel, options);
  unions.joinAll();
  renumberSegments(
      left_out, [&](auto s) { return unions.find(s); }, segment_of_voxel);
}

} // namespace indoor
} // namespace pcl
