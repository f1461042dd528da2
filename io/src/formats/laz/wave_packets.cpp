/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/laz/wave_packets.h"

#include "formats/laz/predictions.h"

namespace pcl::indoor::tool {

void
WavePackets::next(ArithmeticDecoder& decoder, char* packet)
{
  constexpr std::size_t offset_at = 1, size_at = 9, place_at = 13, direction_at = 17;
  const auto read = [&](IntegerDecoder& numbers, std::size_t at, unsigned context) {
    const auto last = numberAt<std::int32_t>(packet + at);
    putNumber(packet + at, numbers.next(decoder, last, context));
  };
  packet[0] = static_cast<char>(decoder.symbol(descriptors_));
  auto offset = numberAt<std::uint64_t>(packet + offset_at);
  last_code_ = decoder.symbol(offset_codes_[last_code_]);
  if (last_code_ == 1)
    offset += numberAt<std::uint32_t>(packet + size_at);
  else if (last_code_ == 2) {
    last_step_ = offsets_.next(decoder, last_step_);
    offset += static_cast<std::uint64_t>(static_cast<std::int64_t>(last_step_));
  }
  else if (last_code_ == 3) {
    const std::uint64_t low = decoder.bits(32);
    offset = static_cast<std::uint64_t>(decoder.bits(32)) << 32 | low;
  }
  putNumber(packet + offset_at, offset);
  read(sizes_, size_at, 0);
  read(places_, place_at, 0);
  for (unsigned axis = 0; axis < 3; ++axis)
    read(directions_, direction_at + 4 * axis, axis);
}

} // namespace pcl::indoor::tool
