/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "objects/graph/border_clustering.h"

#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <queue>
#include <tuple>

namespace {

using pcl::indoor::Border;

/** Sum over the borders between two segments. */
struct BorderSum {
  double cost = 0; // times length
  double length = 0;

  double
  mean() const
  {
    return cost / length;
  }
};

/** Segments, each known by one of its nodes, with the borders between them. */
class RegionGraph {
public:
  RegionGraph(std::size_t node_count, const std::vector<Border>& borders)
  : parent_(node_count)
  , size_(node_count, 1)
  , borders_(node_count)
  {
    std::iota(parent_.begin(), parent_.end(), 0u);
    for (const auto& border : borders) {
      if (border.source == border.target)
        continue;
      const BorderSum sum{border.cost * border.length, border.length};
      add(border.source, border.target, sum);
    }
    for (std::uint32_t a = 0; a < node_count; ++a)
      for (const auto& entry : borders_[a])
        if (a < entry.first)
          propose(a, entry.first);
  }

  /** Join over borders in ascending order of mean cost, up to the threshold. */
  void
  joinUpTo(double threshold)
  {
    while (!queue_.empty() && std::get<0>(queue_.top()) <= threshold) {
      const auto [cost, a, b] = queue_.top();
      queue_.pop();
      // Proposals stay in the queue when their segments or borders change.
      const auto border = borders_[a].find(b);
      if (border != borders_[a].end() && border->second.mean() == cost)
        join(a, b);
    }
  }

  /** Join each segment that is too small over its cheapest border. */
  void
  joinSmall(std::uint32_t min_segment_size)
  {
    for (std::uint32_t node = 0; node < parent_.size(); ++node)
      for (auto a = find(node); size_[a] < min_segment_size && !borders_[a].empty();
           a = find(node)) {
        const auto cheapest = std::min_element(
            borders_[a].begin(), borders_[a].end(), [](const auto& x, const auto& y) {
              return x.second.mean() < y.second.mean();
            });
        join(a, cheapest->first);
      }
  }

  std::vector<std::uint32_t>
  labels()
  {
    constexpr std::uint32_t none = 0xffffffffu;
    std::vector<std::uint32_t> label_of(parent_.size(), none), labels;
    std::uint32_t next = 0;
    for (std::uint32_t node = 0; node < parent_.size(); ++node) {
      auto& label = label_of[find(node)];
      if (label == none)
        label = next++;
      labels.push_back(label);
    }
    return labels;
  }

private:
  using Proposal = std::tuple<double, std::uint32_t, std::uint32_t>;

  std::uint32_t
  find(std::uint32_t node)
  {
    while (parent_[node] != node)
      node = parent_[node] = parent_[parent_[node]];
    return node;
  }

  void
  add(std::uint32_t a, std::uint32_t b, const BorderSum& sum)
  {
    auto& border = borders_[a][b];
    border.cost += sum.cost;
    border.length += sum.length;
    borders_[b][a] = border;
  }

  void
  propose(std::uint32_t a, std::uint32_t b)
  {
    queue_.emplace(borders_[a].at(b).mean(), std::min(a, b), std::max(a, b));
  }

  void
  join(std::uint32_t a, std::uint32_t b)
  {
    // Moving the shorter list of borders keeps the total effort at n log n.
    const bool a_is_longer = borders_[a].size() >= borders_[b].size();
    const auto kept = a_is_longer ? a : b, gone = a_is_longer ? b : a;
    parent_[gone] = kept;
    size_[kept] += size_[gone];
    std::map<std::uint32_t, BorderSum> moved;
    moved.swap(borders_[gone]);
    borders_[kept].erase(gone);
    moved.erase(kept);
    for (const auto& entry : moved) {
      borders_[entry.first].erase(gone);
      add(kept, entry.first, entry.second);
      propose(kept, entry.first);
    }
  }

  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> size_;
  std::vector<std::map<std::uint32_t, BorderSum>> borders_; // by the other segment
  std::priority_queue<Proposal, std::vector<Proposal>, std::greater<Proposal>> queue_;
};

void
requireValid(std::size_t node_count, const std::vector<Border>& borders)
{
  for (const auto& border : borders) {
    if (border.source >= node_count || border.target >= node_count)
      PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                          "The border from " << border.source << " to " << border.target
                                             << " leaves a graph of " << node_count
                                             << " nodes.");
    if (!std::isfinite(border.cost) || !(border.length > 0) ||
        !std::isfinite(border.length))
      PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                          "A border needs a finite cost and a positive length, not "
                              << border.cost << " and " << border.length << ".");
  }
}

} // namespace

namespace pcl::indoor {

std::vector<std::uint32_t>
clusterByBorders(std::size_t node_count,
                 const std::vector<Border>& borders,
                 double threshold,
                 std::uint32_t min_segment_size)
{
  requireValid(node_count, borders);
  RegionGraph regions(node_count, borders);
  regions.joinUpTo(threshold);
  regions.joinSmall(min_segment_size);
  return regions.labels();
}

} // namespace pcl::indoor
