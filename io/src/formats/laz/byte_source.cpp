/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/laz/byte_source.h"

#include <algorithm>

namespace pcl::indoor::tool {

ByteSource::ByteSource(const std::string& path, std::uint64_t begin, std::uint64_t end)
: stream_(std::make_unique<std::ifstream>(path, std::ios::binary))
, left_(end - begin)
{
  stream_->seekg(static_cast<std::streamoff>(begin));
}

void
ByteSource::take(char* target, std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i)
    target[i] = static_cast<char>(next(1));
}

std::uint32_t
ByteSource::nextOfFew(unsigned count)
{
  std::uint32_t number = 0;
  for (; count > 0; --count) {
    if (at_ == end_)
      refill();
    number = number << 8 | *at_++;
  }
  return number;
}

void
ByteSource::refill()
{
  constexpr std::uint64_t bytes_at_once = 1 << 16;
  const auto count = static_cast<std::size_t>(std::min(bytes_at_once, left_));
  buffer_.resize(count);
  if (count == 0 || !stream_->read(reinterpret_cast<char*>(buffer_.data()),
                                   static_cast<std::streamsize>(count)))
    throw DamagedChunk("its bytes end before its points");
  left_ -= count;
  at_ = buffer_.data();
  end_ = at_ + count;
}

} // namespace pcl::indoor::tool
