/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <vector>

namespace pcl {
namespace indoor {

/** \brief A sum of small decision trees that gives the probability of "yes". */
class BoostedTrees {
public:
  /** \brief A question, or the answer if there are no children. */
  struct Node {
    std::uint16_t feature = 0; ///< that is asked for
    std::uint16_t next = 0;    ///< within the tree: if at most the value, then the one
                               ///< after it; 0 in a leaf
    float value = 0;           ///< limit, or log-odds in a leaf
  };

  /** \brief Read trees as text: "trees FEATURES ROOT COUNT", then for each tree its
   * number of nodes and the nodes.
   * \throws pcl::BadArgumentException if the text is no such thing */
  static BoostedTrees
  read(std::istream& stream);

  /** \brief Get the number of features. */
  std::size_t
  featureCount() const
  {
    return feature_count_;
  }

  /** \brief Get the probability, 0 to 1.
   * \param[in] features featureCount() values */
  float
  probability(const float* features) const;

private:
  std::size_t feature_count_ = 0;
  float base_ = 0;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> roots_;
};

} // namespace indoor
} // namespace pcl
