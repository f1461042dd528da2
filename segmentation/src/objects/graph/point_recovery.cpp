/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/graph/point_recovery.h"

#include <pcl/indoor/flood_fill.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>

namespace {

constexpr double accepted_share = 0.8; // P_r of Algorithm 1

constexpr std::uint32_t unlabelled = pcl::indoor::Supervoxels::none;

/** An entry of W in Algorithm 1. */
struct Proposal {
  float distance;
  std::uint32_t place;
  std::uint32_t label;
};

} // namespace

namespace pcl::indoor {

void
recoverLabels(const std::vector<Eigen::Vector3f>& positions,
              const std::vector<Eigen::Vector3f>& normals,
              const Adjacency& neighbors,
              const SurfaceDistance& distance,
              std::vector<std::uint32_t>& labels,
              unsigned most_rounds)
{
  assert(positions.size() == labels.size() && normals.size() == labels.size() &&
         neighbors.offsets.size() == labels.size() + 1);
  std::vector<std::uint32_t> open;
  for (std::uint32_t i = 0; i < labels.size(); ++i)
    if (labels[i] == unlabelled)
      open.push_back(i);
  const auto propose = [&](std::uint32_t place) {
    Proposal best{0, place, unlabelled};
    for (const auto other : neighbors.of(place)) {
      if (labels[other] == unlabelled)
        continue;
      const float d =
          distance(positions[place], normals[place], positions[other], normals[other]);
      if (best.label == unlabelled || d < best.distance)
        best = {d, place, labels[other]};
    }
    return best;
  };
  for (unsigned round = 0; !open.empty() && round < most_rounds; ++round) {
    std::vector<Proposal> proposals;
    for (const auto place : open) {
      const auto proposal = propose(place);
      if (proposal.label != unlabelled)
        proposals.push_back(proposal);
    }
    if (proposals.empty())
      break;
    auto accepted = proposals.size();
    if (round + 1 < recovery_rounds) {
      std::sort(proposals.begin(), proposals.end(), [](const auto& a, const auto& b) {
        return std::tie(a.distance, a.place) < std::tie(b.distance, b.place);
      });
      const auto share =
          std::lround(accepted_share * static_cast<double>(proposals.size()));
      accepted = static_cast<std::size_t>(std::max(1l, share));
    }
    for (std::size_t i = 0; i < accepted; ++i)
      labels[proposals[i].place] = proposals[i].label;
    open.erase(std::remove_if(open.begin(),
                              open.end(),
                              [&](auto place) { return labels[place] != unlabelled; }),
               open.end());
  }
}

void
labelRemainder(const Adjacency& neighbors,
               std::uint32_t next,
               std::vector<std::uint32_t>& labels)
{
  std::vector<std::uint32_t> part;
  const auto enter = [&](std::uint32_t place, std::uint32_t) {
    const bool is_open = labels[place] == unlabelled;
    if (is_open)
      labels[place] = next;
    return is_open;
  };
  for (std::uint32_t first = 0; first < labels.size(); ++first) {
    if (labels[first] != unlabelled)
      continue;
    labels[first] = next;
    part.assign(1, first);
    floodFill(part, neighbors, enter);
    ++next;
  }
}

} // namespace pcl::indoor
