/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

namespace pcl::indoor {

/** \brief Union-find over 0 ... n - 1, by size and with path halving. */
class DisjointSets {
public:
  explicit DisjointSets(std::size_t count)
  : parent_(count)
  , size_(count, 1)
  {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  /** \brief Get the representative of the set that holds the element. */
  std::uint32_t
  find(std::uint32_t element)
  {
    while (parent_[element] != element)
      element = parent_[element] = parent_[parent_[element]];
    return element;
  }

  /** \brief Join two sets given by their representatives.
   * \return the representative of the union
   */
  std::uint32_t
  merge(std::uint32_t a, std::uint32_t b)
  {
    if (a == b)
      return a;
    if (size_[a] < size_[b])
      std::swap(a, b);
    parent_[b] = a;
    size_[a] += size_[b];
    return a;
  }

  /** \brief Get the number of elements of the set with this representative. */
  std::uint32_t
  size(std::uint32_t representative) const
  {
    return size_[representative];
  }

  /** \brief Number the sets from 0 in the order of their first elements.
   * \return the number of each element's set
   */
  std::vector<std::uint32_t>
  labels()
  {
    constexpr std::uint32_t none = 0xffffffffu;
    std::vector<std::uint32_t> label_of_root(parent_.size(), none);
    std::vector<std::uint32_t> labels(parent_.size());
    std::uint32_t next = 0;
    for (std::uint32_t i = 0; i < parent_.size(); ++i) {
      auto& label = label_of_root[find(i)];
      if (label == none)
        label = next++;
      labels[i] = label;
    }
    return labels;
  }

private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> size_;
};

} // namespace pcl::indoor
