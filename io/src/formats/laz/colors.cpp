/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/laz/colors.h"

#include <algorithm>

namespace pcl::indoor::tool {
namespace {

/** \param[in] shift 0 for the lower byte, 8 for the upper one */
int
byteOf(std::uint16_t value, unsigned shift)
{
  return value >> shift & 0xff;
}

std::uint16_t
asByte(int value, unsigned shift)
{
  return static_cast<std::uint16_t>((value & 0xff) << shift);
}

int
withinByte(int value)
{
  return std::min(std::max(value, 0), 255);
}

} // namespace

Color
Colors::next(ArithmeticDecoder& decoder, const Color& last)
{
  const unsigned used = decoder.symbol(used_);
  const auto read = [&](unsigned byte, int predicted) {
    return predicted + static_cast<int>(decoder.symbol(bytes_[byte]));
  };
  Color color{};
  for (const unsigned shift : {0u, 8u}) {
    const unsigned byte = shift / 8;
    const int before = byteOf(last[0], shift);
    color[0] |= asByte((used >> byte & 1) != 0 ? read(byte, before) : before, shift);
  }
  if ((used & 64) == 0)
    return {color[0], color[0], color[0]};
  for (const unsigned shift : {0u, 8u}) {
    const unsigned byte = shift / 8;
    int change = byteOf(color[0], shift) - byteOf(last[0], shift);
    const auto channel = [&](std::size_t which, unsigned of_byte) {
      const int before = byteOf(last[which], shift);
      color[which] |=
          asByte((used >> of_byte & 1) != 0 ? read(of_byte, withinByte(change + before))
                                            : before,
                 shift);
    };
    channel(1, 2 + byte);
    change = (change + byteOf(color[1], shift) - byteOf(last[1], shift)) / 2;
    channel(2, 4 + byte);
  }
  return color;
}

Color
OldColors::next(ArithmeticDecoder& decoder, const Color& last)
{
  const unsigned used = decoder.symbol(used_);
  Color color{};
  for (unsigned byte = 0; byte < 6; ++byte) {
    const unsigned channel = byte / 2, shift = byte % 2 * 8;
    const int before = byteOf(last[channel], shift);
    color[channel] |= asByte(
        (used >> byte & 1) != 0 ? bytes_.next(decoder, before, byte) : before, shift);
  }
  return color;
}

std::uint16_t
InfraredValues::next(ArithmeticDecoder& decoder, std::uint16_t last)
{
  const unsigned used = decoder.symbol(used_);
  std::uint16_t value = 0;
  for (const unsigned byte : {0u, 1u}) {
    int now = byteOf(last, 8 * byte);
    if ((used >> byte & 1) != 0)
      now += static_cast<int>(decoder.symbol(bytes_[byte]));
    value |= asByte(now, 8 * byte);
  }
  return value;
}

} // namespace pcl::indoor::tool
