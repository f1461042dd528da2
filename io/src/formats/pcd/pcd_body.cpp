/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/pcd/pcd_body.h"

#include "files/field_value.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <vector>

namespace pcl::indoor::tool {
namespace {

/** Unpacks LZF piece by piece. A token is a count of bytes that follow as they are, or
 * a length and how far before they have been. */
class LzfReader {
public:
  /** \param[in] most bytes that are wanted at once */
  LzfReader(const std::uint8_t* packed, std::size_t size, std::size_t most)
  : packed_(packed)
  , end_(packed + size)
  , bytes_(farthest + std::max(most, std::size_t{1} << 16) + longest)
  {}

  /** How many bytes are next, at least so many unless they end before. */
  std::size_t
  available(std::size_t least)
  {
    if (filled_ - taken_ < least)
      refill();
    return filled_ - taken_;
  }

  const std::uint8_t*
  take(std::size_t count)
  {
    taken_ += count;
    return &bytes_[taken_ - count];
  }

  /** Whether all bytes were taken, and none were damaged. */
  bool
  isAtEnd()
  {
    return available(1) == 0 && packed_ == end_ && !is_damaged_;
  }

private:
  static constexpr std::size_t farthest = 1 << 13, longest = 264; // of a token

  void
  refill()
  {
    const std::size_t passed =
        std::min(taken_, filled_ > farthest ? filled_ - farthest : 0);
    std::memmove(bytes_.data(), &bytes_[passed], filled_ - passed);
    filled_ -= passed;
    taken_ -= passed;
    while (!is_damaged_ && packed_ != end_ && filled_ + longest <= bytes_.size())
      is_damaged_ = !unpackToken();
  }

  bool
  unpackToken()
  {
    const std::size_t token = *packed_++, left = end_ - packed_;
    if (token < 32) {
      const std::size_t count = token + 1;
      if (left < count)
        return false;
      std::memcpy(&bytes_[filled_], packed_, count);
      packed_ += count;
      filled_ += count;
      return true;
    }
    std::size_t length = token >> 5;
    if (left < (length == 7 ? 2 : 1))
      return false;
    if (length == 7)
      length += *packed_++;
    length += 2;
    const std::size_t distance = ((token & 31) << 8 | *packed_++) + 1;
    if (distance > filled_)
      return false;
    auto* to = &bytes_[filled_];
    for (std::size_t i = 0; i < length; ++i) // both may overlap
      to[i] = to[i - distance];
    filled_ += length;
    return true;
  }

  const std::uint8_t* packed_;
  const std::uint8_t* end_;
  std::vector<std::uint8_t> bytes_; // those that a token may repeat, and the next
  std::size_t taken_ = 0, filled_ = 0;
  bool is_damaged_ = false;
};

template <typename Real>
bool
allFinite(const std::uint8_t* bytes, std::size_t size)
{
  bool are_finite = true;
  for (std::size_t at = 0; at + sizeof(Real) <= size; at += sizeof(Real)) {
    Real value;
    std::memcpy(&value, bytes + at, sizeof(Real));
    are_finite &= std::isfinite(value);
  }
  return are_finite;
}

bool
isDense(const PCLPointField& field, const std::uint8_t* bytes, std::size_t size)
{
  return field.datatype == PCLPointField::FLOAT32   ? allFinite<float>(bytes, size)
         : field.datatype == PCLPointField::FLOAT64 ? allFinite<double>(bytes, size)
                                                    : true;
}

/** Bring values to their points: of a size that is known, faster. */
template <typename Size>
void
spread(const std::uint8_t* from,
       std::size_t count,
       Size size,
       std::size_t step,
       std::uint8_t* to)
{
  for (std::size_t i = 0; i < count; ++i, from += size, to += step)
    std::memcpy(to, from, size);
}

} // namespace

bool
unpackPoints(const std::uint8_t* packed, std::size_t size, PCLPointCloud2& cloud)
{
  const auto count = static_cast<std::size_t>(cloud.width) * cloud.height;
  if (cloud.data.size() < count * cloud.point_step)
    return false;
  LzfReader reader(packed, size, cloud.point_step);
  cloud.is_dense = true;
  for (const auto& field : cloud.fields) {
    const std::size_t bytes = byteCount(field);
    if (bytes == 0 || field.offset + bytes > cloud.point_step)
      return false;
    for (std::size_t first = 0; first < count;) {
      const std::size_t some = std::min(reader.available(bytes) / bytes, count - first);
      if (some == 0)
        return false;
      const auto* from = reader.take(some * bytes);
      cloud.is_dense = cloud.is_dense && isDense(field, from, some * bytes);
      auto* to = &cloud.data[first * cloud.point_step + field.offset];
      if (bytes == 4)
        spread(
            from, some, std::integral_constant<std::size_t, 4>(), cloud.point_step, to);
      else
        spread(from, some, bytes, cloud.point_step, to);
      first += some;
    }
  }
  return reader.isAtEnd();
}

} // namespace pcl::indoor::tool
