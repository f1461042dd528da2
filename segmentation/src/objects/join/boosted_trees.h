/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <vector>

namespace pcl::indoor {

/** \brief Boosted decision trees for a yes-or-no question: the answers of all trees are
 * added up to the log-odds of "yes". */
class PCL_INDOOR_EXPORTS BoostedTrees {
public:
  /** \brief An inner node compares a feature with a limit; a leaf has no children. */
  struct Node {
    std::uint16_t feature = 0; ///< number of the feature that is compared
    std::uint16_t next = 0; ///< child, within the tree, for features up to the limit;
                            ///< the other child follows it; 0 in a leaf
    float value = 0;        ///< the limit; in a leaf the log-odds
  };

  /** \brief Read trees as text: "trees FEATURES ROOT COUNT", then for each tree its
   * number of nodes and the nodes: "FEATURE NEXT VALUE", in a leaf "vVALUE".
   * \throws pcl::BadArgumentException if the text holds none */
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

} // namespace pcl::indoor
