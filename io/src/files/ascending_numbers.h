/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Increasing numbers, stored as differences in groups of 7 bits: one or two
 * bytes each where gaps are small. */
class AscendingNumbers {
public:
  /** \brief REQUIRES: no number that was added is larger. */
  void
  add(std::uint64_t number)
  {
    std::uint64_t step = number - last_;
    for (; step >= more; step >>= bits)
      bytes_.push_back(static_cast<std::uint8_t>(step | more));
    bytes_.push_back(static_cast<std::uint8_t>(step));
    last_ = number;
  }

  /** \brief Give back the memory that more numbers would have taken. */
  void
  shrink()
  {
    bytes_.shrink_to_fit();
  }

  /** \brief Goes through the numbers, which must outlive it. */
  class Reader {
  public:
    explicit Reader(const AscendingNumbers& numbers)
    : bytes_(numbers.bytes_)
    {}

    /** \brief Go to the next number, the first one at first.
     * \return false if there is none */
    bool
    next()
    {
      if (at_ == bytes_.size())
        return false;
      for (int shift = 0;; shift += bits) {
        const std::uint64_t byte = bytes_[at_++];
        number_ += (byte & (more - 1)) << shift;
        if (byte < more)
          return true;
      }
    }

    /** \brief Where it is. REQUIRES: next() was true. */
    std::uint64_t
    number() const
    {
      return number_;
    }

  private:
    const std::vector<std::uint8_t>& bytes_;
    std::size_t at_ = 0;
    std::uint64_t number_ = 0;
  };

private:
  static constexpr int bits = 7;
  static constexpr std::uint64_t more = 1 << bits; // in a byte that is not the last

  std::vector<std::uint8_t> bytes_;
  std::uint64_t last_ = 0;
};

} // namespace pcl::indoor::tool
