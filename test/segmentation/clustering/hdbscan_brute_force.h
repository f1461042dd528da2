/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#pragma once

#include <pcl/segmentation/hdbscan.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

/** HDBSCAN* by its definition: dense matrix, no spanning tree, sets of points split
 * where the graph of the pairs closer than a distance falls apart.
 */
class HDBSCANBruteForce {
public:
  using Matrix = std::vector<std::vector<double>>;

  HDBSCANBruteForce(Matrix distance, const pcl::indoor::HDBSCANOptions& options)
  : options_(options)
  , reach_(std::move(distance))
  {
    toMutualReachability();
    labels.assign(reach_.size(), -1);
    probabilities.assign(reach_.size(), 0.0);
    if (reach_.empty())
      return;
    findSmallestSplit();
    std::vector<std::size_t> all(reach_.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i] = i;
    const int root = follow(all, -1, std::numeric_limits<double>::infinity());
    select(root);
    const auto chosen = applyEpsilon();
    for (const int cluster : chosen)
      label(cluster);
    renumber();
  }

  std::vector<int> labels;
  std::vector<double> probabilities;

private:
  struct Cluster {
    int parent;
    double birth;
    std::vector<std::size_t> points;
    std::vector<double> leaves; // distance, parallel to points
    std::vector<int> children;
    double stability = 0.0, best = 0.0;
    bool selected = false;
  };

  void
  toMutualReachability()
  {
    const std::size_t n = reach_.size();
    const std::size_t k =
        options_.min_samples ? options_.min_samples : options_.min_cluster_size;
    std::vector<double> core(n);
    for (std::size_t i = 0; i < n; ++i) {
      auto row = reach_[i];
      row[i] = 0.0;
      std::sort(row.begin(), row.end());
      core[i] = row[std::min(k, n) - 1];
    }
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        reach_[i][j] = std::max({reach_[i][j], core[i], core[j]});
  }

  /** Parts of a set in which only pairs closer than a distance are linked. */
  std::vector<std::vector<std::size_t>>
  parts(const std::vector<std::size_t>& set, double below) const
  {
    std::vector<std::vector<std::size_t>> result;
    std::vector<char> used(reach_.size(), 0);
    for (const std::size_t seed : set) {
      if (used[seed])
        continue;
      std::vector<std::size_t> part{seed};
      used[seed] = 1;
      for (std::size_t k = 0; k < part.size(); ++k)
        for (const std::size_t other : set)
          if (!used[other] && reach_[part[k]][other] < below) {
            used[other] = 1;
            part.push_back(other);
          }
      result.push_back(part);
    }
    return result;
  }

  /** The smallest distance within which a set is connected. */
  double
  connectsAt(const std::vector<std::size_t>& set) const
  {
    std::vector<double> values;
    for (const std::size_t i : set)
      for (const std::size_t j : set)
        if (i < j)
          values.push_back(reach_[i][j]);
    std::sort(values.rbegin(), values.rend());
    for (const double value : values)
      if (parts(set, value).size() > 1)
        return value;
    return std::numeric_limits<double>::quiet_NaN();
  }

  void
  findSmallestSplit()
  {
    std::vector<std::vector<std::size_t>> sets(1);
    for (std::size_t i = 0; i < reach_.size(); ++i)
      sets[0].push_back(i);
    while (!sets.empty()) {
      const auto set = sets.back();
      sets.pop_back();
      if (set.size() < 2)
        continue;
      const double at = connectsAt(set);
      if (at > 0.0)
        smallest_ = std::min(smallest_, at);
      for (const auto& part : parts(set, at))
        sets.push_back(part);
    }
  }

  double
  density(double distance) const
  {
    const double zero = std::isfinite(smallest_) ? smallest_ / 2 : 1.0;
    return 1.0 / (distance > 0.0 ? distance : zero);
  }

  int
  follow(std::vector<std::size_t> set, int parent, double birth)
  {
    const int id = static_cast<int>(clusters_.size());
    clusters_.push_back({parent, birth, set, std::vector<double>(set.size(), 0.0), {}});
    const auto leave = [&](std::size_t point, double distance) {
      auto& c = clusters_[id];
      const auto place = std::find(c.points.begin(), c.points.end(), point);
      c.leaves[place - c.points.begin()] = distance;
    };
    while (set.size() > 1) {
      const double at = connectsAt(set);
      std::vector<std::vector<std::size_t>> large;
      for (const auto& part : parts(set, at)) {
        if (part.size() >= options_.min_cluster_size)
          large.push_back(part);
        else
          for (const std::size_t point : part)
            leave(point, at);
      }
      if (large.size() == 1) {
        set = large[0];
        continue;
      }
      for (const auto& part : large) {
        for (const std::size_t point : part)
          leave(point, at);
        const int child = follow(part, id, at);
        clusters_[id].children.push_back(child);
      }
      break;
    }
    auto& c = clusters_[id];
    for (const double distance : c.leaves)
      c.stability += density(distance) - density(birth);
    return id;
  }

  bool
  rootAllowed() const
  {
    return options_.allow_single_cluster && reach_.size() >= options_.min_cluster_size;
  }

  void
  unselectBelow(int id)
  {
    for (const int child : clusters_[id].children) {
      clusters_[child].selected = false;
      unselectBelow(child);
    }
  }

  void
  select(int id)
  {
    double children = 0.0;
    for (const int child : clusters_[id].children) {
      select(child);
      children += clusters_[child].best;
    }
    auto& c = clusters_[id];
    const bool leaf = c.children.empty();
    // ties are not left to rounding, which differs from the implementation's
    const bool stable = c.stability >= children * (1.0 - 1e-12);
    const bool wins = options_.selection == pcl::indoor::ClusterSelection::Leaf
                          ? leaf
                          : leaf || stable;
    c.best = children;
    if ((id > 0 || rootAllowed()) && wins) {
      unselectBelow(id);
      c.selected = true;
      c.best = c.stability;
    }
  }

  std::vector<int>
  applyEpsilon()
  {
    for (std::size_t id = 0; id < clusters_.size(); ++id) {
      int up = static_cast<int>(id);
      while (clusters_[id].selected && clusters_[up].birth < options_.epsilon &&
             (clusters_[up].parent > 0 || rootAllowed()))
        up = clusters_[up].parent;
      if (up != static_cast<int>(id)) {
        clusters_[id].selected = false;
        clusters_[up].selected = true;
      }
    }
    std::vector<int> chosen;
    for (std::size_t id = 0; id < clusters_.size(); ++id)
      if (clusters_[id].selected) {
        unselectBelow(static_cast<int>(id));
        chosen.push_back(static_cast<int>(id));
      }
    return chosen;
  }

  void
  label(int id)
  {
    const auto& c = clusters_[id];
    const double last = *std::min_element(c.leaves.begin(), c.leaves.end());
    for (std::size_t k = 0; k < c.points.size(); ++k) {
      const bool cut = options_.epsilon > 0.0 && c.leaves[k] > options_.epsilon;
      if (id == 0 && !inChild(0, c.points[k]) && (cut || std::isinf(c.leaves[k])))
        continue;
      labels[c.points[k]] = id;
      const double top = density(last);
      // points of a cluster within this one are counted by where they leave that one
      const double leaves = std::min(density(leavesLast(id, c.points[k])), top);
      probabilities[c.points[k]] = top > 0.0 ? leaves / top : 1.0;
    }
  }

  bool
  inChild(int id, std::size_t point) const
  {
    return leavesLastIn(id, point) != id;
  }

  int
  leavesLastIn(int id, std::size_t point) const
  {
    for (const int child : clusters_[id].children) {
      const auto& p = clusters_[child].points;
      if (std::find(p.begin(), p.end(), point) != p.end())
        return leavesLastIn(child, point);
    }
    return id;
  }

  double
  leavesLast(int id, std::size_t point) const
  {
    const auto& c = clusters_[leavesLastIn(id, point)];
    return c
        .leaves[std::find(c.points.begin(), c.points.end(), point) - c.points.begin()];
  }

  void
  renumber()
  {
    std::vector<int> name(clusters_.size(), -1);
    int next = 0;
    for (int& l : labels) {
      if (l < 0)
        continue;
      if (name[l] < 0)
        name[l] = next++;
      l = name[l];
    }
  }

  pcl::indoor::HDBSCANOptions options_;
  Matrix reach_;
  double smallest_ = std::numeric_limits<double>::infinity();
  std::vector<Cluster> clusters_;
};
