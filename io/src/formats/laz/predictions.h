/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Facts of the format: M. Isenburg, LASzip: lossless compression of LiDAR data, PE&RS
// 2013.
#pragma once

#include "formats/las/las_header.h" // for numberAt

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

namespace pcl::indoor::tool {

/** \brief Write a number to a place of a point, little-endian as this machine is. */
template <typename T>
void
putNumber(char* bytes, T value)
{
  std::memcpy(bytes, &value, sizeof(T));
}

/** \brief The sum of two numbers, from the greatest on to the least. */
inline std::int32_t
wrappedSum(std::int32_t a, std::int32_t b)
{
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) +
                                   static_cast<std::uint32_t>(b));
}

/** \brief The same of a product. */
inline std::int32_t
wrappedProduct(std::int32_t a, std::int32_t b)
{
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) *
                                   static_cast<std::uint32_t>(b));
}

/** \brief About the median of the numbers so far: of five, from which a new one drives
 * out the greatest and the least by turns. */
class RunningMedian {
public:
  std::int32_t
  value() const
  {
    return sorted_[2];
  }

  void
  add(std::int32_t number)
  {
    if (drops_greatest_) {
      const bool is_low = number < sorted_[2];
      insert(number, 4);
      drops_greatest_ = is_low;
    }
    else {
      const bool is_high = sorted_[2] < number;
      insert(number, 0);
      drops_greatest_ = !is_high;
    }
  }

private:
  /** Put a number in order in place of the one at an end. */
  void
  insert(std::int32_t number, std::size_t end)
  {
    sorted_[end] = number;
    if (end == 4)
      for (std::size_t k = 4; k > 0 && sorted_[k] < sorted_[k - 1]; --k)
        std::swap(sorted_[k], sorted_[k - 1]);
    else
      for (std::size_t k = 0; k < 4 && sorted_[k + 1] < sorted_[k]; ++k)
        std::swap(sorted_[k], sorted_[k + 1]);
  }

  std::array<std::int32_t, 5> sorted_{};
  bool drops_greatest_ = true;
};

/** \brief In which of the groups that are predicted apart a point is.
 * \param[in] returns of the pulse, and which of these, at most 7
 * \return below 16 */
unsigned
returnGroup(unsigned returns, unsigned number);

/** \brief The same of the layered formats.
 * \param[in] returns of the pulse, and which of these, at most 15
 * \return below 6 */
unsigned
layeredReturnGroup(unsigned returns, unsigned number);

/** \brief How many returns a point is from the last one, at most 7. */
inline unsigned
returnLevel(unsigned returns, unsigned number)
{
  return std::min(returns > number ? returns - number : number - returns, 7u);
}

/** \brief The context of a coordinate: of single returns, and by bits of other ones. */
inline unsigned
lengthContext(unsigned returns, unsigned length, unsigned most)
{
  return (returns == 1) + (length < most ? length & ~1u : most);
}

} // namespace pcl::indoor::tool
