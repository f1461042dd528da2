/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/sign_graph.h>

#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace {

using pcl::indoor::SignEdge;

constexpr int mutual_rounds = 40; // afterwards, chains are joined at once
constexpr std::uint32_t none = 0xffffffffu;

/** Sets of nodes whose signs relative to each other are decided. */
class SignedSets {
public:
  explicit SignedSets(std::size_t count)
  : parent_(count)
  , sign_(count, 1)
  {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  /** The root of a node's set; sign(node) is relative to it afterwards. */
  std::uint32_t
  find(std::uint32_t node)
  {
    auto root = node;
    std::int8_t sign = 1;
    while (parent_[root] != root) {
      sign = static_cast<std::int8_t>(sign * sign_[root]);
      root = parent_[root];
    }
    while (parent_[node] != root && node != root) { // make the way short
      const auto next = parent_[node];
      const auto next_sign = static_cast<std::int8_t>(sign * sign_[node]);
      parent_[node] = root;
      sign_[node] = sign;
      sign = next_sign;
      node = next;
    }
    return root;
  }

  std::int8_t
  sign(std::uint32_t node) const
  {
    return sign_[node];
  }

  /** Join the sets of two roots, the second's signs times \a sign. */
  void
  join(std::uint32_t root, std::uint32_t other, std::int8_t sign)
  {
    parent_[other] = root;
    sign_[other] = sign;
  }

private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::int8_t> sign_; // relative to the parent; of a root 1
};

/** Express edges by the roots of their nodes and add up those of the same pair. */
void
contract(SignedSets& sets, std::vector<SignEdge>& edges)
{
  std::size_t kept = 0;
  for (auto edge : edges) {
    const auto a = sets.find(edge.source), b = sets.find(edge.target);
    if (a == b)
      continue;
    const int sign = sets.sign(edge.source) * sets.sign(edge.target);
    edges[kept++] = {
        std::min(a, b), std::max(a, b), static_cast<float>(sign) * edge.weight};
  }
  edges.resize(kept);
  const auto key = [](const SignEdge& edge) {
    return (static_cast<std::uint64_t>(edge.source) << 32) | edge.target;
  };
  std::stable_sort(edges.begin(), edges.end(), [&](const auto& a, const auto& b) {
    return key(a) < key(b);
  });
  kept = 0;
  for (std::size_t i = 0; i < edges.size();) {
    auto sum = edges[i];
    for (++i; i < edges.size() && key(edges[i]) == key(sum); ++i)
      sum.weight += edges[i].weight;
    edges[kept++] = sum;
  }
  edges.resize(kept);
}

/** Join sets along the strongest edge of each, where it is that of both if \a mutual.
 * \return whether any were joined */
bool
joinStrongest(bool mutual,
              const std::vector<SignEdge>& edges,
              SignedSets& sets,
              std::vector<std::uint32_t>& strongest)
{
  std::fill(strongest.begin(), strongest.end(), none);
  for (std::uint32_t i = 0; i < edges.size(); ++i)
    for (const auto node : {edges[i].source, edges[i].target})
      if (edges[i].weight != 0 &&
          (strongest[node] == none ||
           std::abs(edges[i].weight) > std::abs(edges[strongest[node]].weight)))
        strongest[node] = i;
  bool joined = false;
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    const auto& edge = edges[i];
    const bool of_source = strongest[edge.source] == i;
    const bool of_target = strongest[edge.target] == i;
    if (mutual ? !(of_source && of_target) : !(of_source || of_target))
      continue;
    const auto a = sets.find(edge.source), b = sets.find(edge.target);
    if (a == b)
      continue;
    const int wish = edge.weight > 0 ? 1 : -1;
    const int sign = wish * sets.sign(edge.source) * sets.sign(edge.target);
    sets.join(a, b, static_cast<std::int8_t>(sign));
    joined = true;
  }
  return joined;
}

/** Flip single signs while that lowers the energy. */
void
flipSingle(const std::vector<SignEdge>& edges, std::vector<std::int8_t>& signs)
{
  std::vector<std::uint32_t> offsets(signs.size() + 1, 0), ends;
  for (const auto& edge : edges)
    for (const auto node : {edge.source, edge.target})
      ++offsets[node + 1];
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<std::uint32_t> incident(2 * edges.size());
  ends.assign(offsets.begin(), offsets.end() - 1);
  for (std::uint32_t i = 0; i < edges.size(); ++i)
    for (const auto node : {edges[i].source, edges[i].target})
      incident[ends[node]++] = i;
  std::vector<std::uint32_t> queue(signs.size());
  std::iota(queue.begin(), queue.end(), 0u);
  std::vector<std::uint8_t> queued(signs.size(), 1);
  // Rounding could make two neighbours flip for ever.
  const std::size_t most = 20 * signs.size();
  for (std::size_t head = 0; head < queue.size() && head < most; ++head) {
    const auto node = queue[head];
    queued[node] = 0;
    double support = 0, strength = 0;
    for (auto j = offsets[node]; j < offsets[node + 1]; ++j) {
      const auto& edge = edges[incident[j]];
      if (edge.source == edge.target)
        continue;
      support += signs[edge.source] * signs[edge.target] * edge.weight;
      strength += std::abs(edge.weight);
    }
    if (!(support < -1e-6 * strength))
      continue;
    signs[node] = static_cast<std::int8_t>(-signs[node]);
    for (auto j = offsets[node]; j < offsets[node + 1]; ++j) {
      const auto& edge = edges[incident[j]];
      const auto other = edge.source == node ? edge.target : edge.source;
      if (!queued[other])
        queue.push_back(other);
      queued[other] = 1;
    }
  }
}

} // namespace

namespace pcl::indoor {

std::vector<std::int8_t>
findSigns(std::size_t node_count,
          const std::vector<SignEdge>& edges,
          std::vector<std::uint32_t>* component)
{
  for (const auto& edge : edges)
    if (edge.source >= node_count || edge.target >= node_count)
      PCL_THROW_EXCEPTION(BadArgumentException,
                          "An edge leaves the graph of " << node_count << " nodes.");
  SignedSets sets(node_count);
  auto contracted = edges;
  std::vector<std::uint32_t> strongest(node_count);
  contract(sets, contracted);
  for (int round = 0; joinStrongest(round < mutual_rounds, contracted, sets, strongest);
       ++round)
    contract(sets, contracted);
  std::vector<std::int8_t> signs(node_count, 1);
  std::vector<std::uint32_t> number(node_count, none), of_node(node_count);
  std::vector<std::uint32_t> first;
  for (std::uint32_t node = 0; node < node_count; ++node) {
    const auto root = sets.find(node);
    signs[node] = sets.sign(node);
    if (number[root] == none) {
      number[root] = static_cast<std::uint32_t>(first.size());
      first.push_back(node);
    }
    of_node[node] = number[root];
  }
  flipSingle(edges, signs);
  std::vector<std::int8_t> sign_of_first;
  for (const auto node : first)
    sign_of_first.push_back(signs[node]);
  for (std::uint32_t node = 0; node < node_count; ++node)
    signs[node] = static_cast<std::int8_t>(signs[node] * sign_of_first[of_node[node]]);
  if (component)
    *component = std::move(of_node);
  return signs;
}

} // namespace pcl::indoor
