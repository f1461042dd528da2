/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/disjoint_sets.h>
#include <pcl/segmentation/rack_unions.h>

#include "segment_boxes.h"

#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace {

using pcl::indoor::RackUnionOptions;
using pcl::indoor::SegmentBox;

using Numbers = std::vector<std::uint32_t>;

/** Finds racks among segments that touch. */
class RackJoiner {
public:
  RackJoiner(std::vector<SegmentBox> boxes,
             const std::vector<std::pair<std::uint32_t, std::uint32_t>>& touching,
             const RackUnionOptions& options)
  : boxes_(std::move(boxes))
  , neighbors_(boxes_.size())
  , options_(options)
  {
    (options.axes.transpose() * options.up).cwiseAbs().maxCoeff(&up_);
    for (const auto& [a, b] : touching) {
      neighbors_[a].push_back(b);
      neighbors_[b].push_back(a);
    }
  }

  /** \return for each segment the one whose number its rack gets */
  Numbers
  rackOfSegments() const
  {
    auto rack = racksOfPieces();
    const auto outlines = outlinesOf(rack);
    auto joined = rack;
    for (std::uint32_t s = 0; s < boxes_.size(); ++s)
      if (boxes_[s].size > 0 && outlines.count(rack[s]) == 0)
        joined[s] = rackAround(s, rack, outlines);
    return joined;
  }

private:
  using Outlines = std::map<std::uint32_t, SegmentBox>;

  int
  level(int axis) const // 0, 1
  {
    return (up_ + 1 + axis) % 3;
  }

  /** A board, or a compartment, or a chest. */
  bool
  isWide(const SegmentBox& box) const
  {
    const double first = box.extent()[level(0)], second = box.extent()[level(1)];
    return box.size > 0 && std::min(first, second) >= options_.min_width &&
           std::max(first, second) >= options_.min_length;
  }

  bool
  isBoard(const SegmentBox& box) const
  {
    return isWide(box) && box.extent()[up_] <= options_.max_thickness;
  }

  /** Area, from above, in common over that of both. */
  double
  overlap(const SegmentBox& a, const SegmentBox& b) const
  {
    double common = 1, of_a = 1, of_b = 1;
    for (const int axis : {level(0), level(1)}) {
      common *= std::max(0.0,
                         std::min(a.high[axis], b.high[axis]) -
                             std::max(a.low[axis], b.low[axis]));
      of_a *= a.extent()[axis];
      of_b *= b.extent()[axis];
    }
    return common / (of_a + of_b - common);
  }

  Numbers
  racksOfPieces() const
  {
    pcl::indoor::DisjointSets racks(boxes_.size());
    const auto join = [&](std::uint32_t a, std::uint32_t b) {
      if (racks.find(a) != racks.find(b) &&
          overlap(boxes_[a], boxes_[b]) >= options_.min_overlap)
        racks.merge(racks.find(a), racks.find(b));
    };
    for (std::uint32_t s = 0; s < boxes_.size(); ++s) {
      if (isWide(boxes_[s]))
        for (const auto other : neighbors_[s])
          join(s, other);
      for (const auto board : neighbors_[s])
        if (isBoard(boxes_[board]))
          for (const auto other : neighbors_[s])
            join(board, other);
    }
    Numbers rack;
    for (std::uint32_t s = 0; s < boxes_.size(); ++s)
      rack.push_back(racks.find(s));
    return rack;
  }

  /** The boxes of those racks that have two pieces or more. */
  Outlines
  outlinesOf(const Numbers& rack) const
  {
    Outlines outlines;
    std::map<std::uint32_t, unsigned> pieces;
    for (std::uint32_t s = 0; s < boxes_.size(); ++s) {
      if (boxes_[s].size == 0)
        continue;
      auto& outline = outlines.emplace(rack[s], boxes_[s]).first->second;
      outline.low = outline.low.min(boxes_[s].low);
      outline.high = outline.high.max(boxes_[s].high);
      ++pieces[rack[s]];
    }
    for (const auto& [number, count] : pieces)
      if (count < 2)
        outlines.erase(number);
    return outlines;
  }

  /** \return the rack that the segment is within; itself if there is none */
  std::uint32_t
  rackAround(std::uint32_t segment, const Numbers& rack, const Outlines& outlines) const
  {
    const auto& box = boxes_[segment];
    std::map<std::uint32_t, unsigned> touched; // pieces of each rack around it
    for (const auto other : neighbors_[segment]) {
      const auto outline = outlines.find(rack[other]);
      if (outline != outlines.end() && isWithin(box, outline->second))
        ++touched[rack[other]];
    }
    const auto most = std::max_element(
        touched.begin(), touched.end(), [](const auto& a, const auto& b) {
          return a.second < b.second;
        });
    return most == touched.end() ? segment : most->first;
  }

  /** Within two voxels; an upright board may stand beside the ends of level ones, and
   * be higher than the highest. */
  bool
  isWithin(const SegmentBox& piece, const SegmentBox& rack) const
  {
    const double reach = 2 * options_.voxel_size;
    bool is_upright = false;
    for (const int axis : {level(0), level(1)}) {
      const double beside = piece.extent()[axis];
      const bool is_thin = beside <= options_.max_thickness;
      is_upright |= is_thin;
      if (!isWithin(piece, rack, axis, reach + (is_thin ? beside : 0)))
        return false;
    }
    return is_upright || isWithin(piece, rack, up_, reach);
  }

  static bool
  isWithin(const SegmentBox& piece, const SegmentBox& rack, int axis, double reach)
  {
    return piece.low[axis] >= rack.low[axis] - reach &&
           piece.high[axis] <= rack.high[axis] + reach;
  }

  std::vector<SegmentBox> boxes_;
  std::vector<Numbers> neighbors_;
  const RackUnionOptions& options_;
  int up_ = 2;
};

void
requireValid(const RackUnionOptions& options)
{
  if (!(options.voxel_size > 0) || !(options.max_thickness > 0) ||
      !(options.min_width >= 0) || !(options.min_length >= 0) ||
      !(options.min_overlap > 0) || !(std::abs(options.up.norm() - 1) < 1e-3f))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "Racks need positive sizes, a positive overlap and a unit "
                        "vector up.");
}

} // namespace

namespace pcl {
namespace indoor {

void
joinRacks(const SurfaceVoxels& voxels,
          const std::vector<std::uint8_t>& left_out,
          const RackUnionOptions& options,
          std::vector<std::uint32_t>& segment_of_voxel)
{
  requireOnePerVoxel(voxels, left_out, segment_of_voxel);
  requireValid(options);
  if (voxels.size() == 0)
    return;
  const RackJoiner joiner(
      segmentBoxes(
          voxels, left_out, segment_of_voxel, options.axes, options.voxel_size),
      touchingSegments(voxels, left_out, segment_of_voxel),
      options);
  const auto rack = joiner.rackOfSegments();
  renumberSegments(
      left_out, [&](auto s) { return rack[s]; }, segment_of_voxel);
}

} // namespace indoor
} // namespace pcl
