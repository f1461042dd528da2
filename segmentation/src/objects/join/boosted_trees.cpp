/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/join/boosted_trees.h"

#include <pcl/exceptions.h>

#include <cmath>
#include <istream>
#include <string>

namespace pcl::indoor {

BoostedTrees
BoostedTrees::read(std::istream& stream)
{
  const auto require = [](bool holds, const char* problem) {
    if (!holds)
      PCL_THROW_EXCEPTION(pcl::BadArgumentException, "Boosted trees: " << problem);
  };
  BoostedTrees trees;
  std::string word;
  std::size_t count = 0;
  require(stream >> word >> trees.feature_count_ >> trees.base_ >> count &&
              word == "trees",
          "no header");
  require(trees.feature_count_ < 65536, "too many features"); // for Node::feature
  require(count < 100000, "too many trees");
  for (std::size_t t = 0; t < count; ++t) {
    std::size_t size = 0;
    require(stream >> size && size > 0 && size < 65536, "no tree");
    trees.roots_.push_back(static_cast<std::uint32_t>(trees.nodes_.size()));
    for (std::size_t n = 0; n < size; ++n) {
      Node node;
      if ((stream >> std::ws).peek() == 'v')
        stream.ignore(); // a leaf has no more than its value
      else
        stream >> node.feature >> node.next;
      require(static_cast<bool>(stream >> node.value), "a tree is cut off");
      require(node.next == 0 || (node.feature < trees.feature_count_ && node.next > n &&
                                 node.next + 1u < size),
              "a node leads nowhere");
      trees.nodes_.push_back(node);
    }
  }
  return trees;
}

float
BoostedTrees::probability(const float* features) const
{
  float sum = base_;
  for (const auto root : roots_) {
    const Node* const tree = &nodes_[root];
    const Node* node = tree;
    while (node->next != 0)
      node = tree + node->next + (features[node->feature] > node->value ? 1 : 0);
    sum += node->value;
  }
  return 1 / (1 + std::exp(-sum));
}

} // namespace pcl::indoor
