/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Facts of the format: ASTM E2807-11, section 7.
#include "formats/e57/e57_pages.h"

#include "files/tool_error.h"
#include "internal/cpu_target.h"

#include <boost/crc.hpp>

#include <algorithm>
#include <cstring>
#include <filesystem>

#if PCL_INDOOR_HAS_TARGETS
#include <nmmintrin.h>
#endif

namespace pcl::indoor::tool {
namespace {

#if PCL_INDOOR_HAS_TARGETS

PCL_INDOOR_TARGET("sse4.2")
std::uint32_t
crcByInstruction(const char* bytes, std::size_t count)
{
  std::uint64_t crc = 0xffffffff;
  for (; count >= sizeof(crc); count -= sizeof(crc), bytes += sizeof(crc)) {
    std::uint64_t eight;
    std::memcpy(&eight, bytes, sizeof(eight));
    crc = _mm_crc32_u64(crc, eight);
  }
  auto rest = static_cast<std::uint32_t>(crc);
  for (; count > 0; --count)
    rest = _mm_crc32_u8(rest, static_cast<unsigned char>(*bytes++));
  return ~rest;
}

#else

std::uint32_t
crcByInstruction(const char*, std::size_t)
{
  return 0;
}

#endif

} // namespace

std::uint32_t
crc32c(const char* bytes, std::size_t count)
{
  static const bool has_instruction = PCL_INDOOR_CPU_HAS("sse4.2");
  if (has_instruction)
    return crcByInstruction(bytes, count);
  boost::crc_optimal<32, 0x1edc6f41, 0xffffffff, 0xffffffff, true, true> crc;
  crc.process_bytes(bytes, count);
  return crc.checksum();
}

E57Pages::E57Pages(const std::string& path)
: path_(path)
, stream_(path, std::ios::binary)
{
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  if (!stream_ || error)
    throw ToolError(path + ": the file cannot be read");
  pages_ = size / page_size;
}

std::uint64_t
E57Pages::logicalPlace(std::uint64_t physical, const std::string& what) const
{
  const auto page = physical / page_size, within = physical % page_size;
  if (page >= pages_)
    throw ToolError(path_ + ": the file is truncated, " + what +
                    " would stand at byte " + std::to_string(physical) +
                    ", behind its end");
  if (within >= content_size)
    throw ToolError(path_ + ": the file is damaged, the place of " + what + ", byte " +
                    std::to_string(physical) + ", is within a checksum");
  return page * content_size + within;
}

/** Load some pages from this one on, and check them. */
void
E57Pages::load(std::uint64_t page)
{
  constexpr std::uint64_t at_once = 64; // as much as the largest packet
  const auto count = std::min(at_once, pages_ - page);
  loaded_.resize(count * page_size);
  first_ = page;
  loaded_pages_ = 0; // none, should reading fail
  stream_.clear();
  stream_.seekg(static_cast<std::streamoff>(page * page_size));
  if (!stream_.read(loaded_.data(), static_cast<std::streamsize>(loaded_.size())))
    throw ToolError(path_ + ": the file can no longer be read");
  for (std::uint64_t i = 0; i < count; ++i) {
    const char* const bytes = &loaded_[i * page_size];
    std::uint32_t stored = 0; // most significant byte first, unlike all other numbers
    for (std::uint64_t k = content_size; k < page_size; ++k)
      stored = stored << 8 | static_cast<unsigned char>(bytes[k]);
    if (stored != crc32c(bytes, content_size))
      throw ToolError(path_ + ": the file is damaged, the checksum of its page " +
                      std::to_string(page + i + 1) + " of " + std::to_string(pages_) +
                      " is wrong");
  }
  loaded_pages_ = count;
}

void
E57Pages::read(std::uint64_t place, void* target, std::size_t count)
{
  if (place > size() || count > size() - place)
    throw ToolError(path_ + ": the file is truncated or damaged, bytes behind its end "
                            "are asked for");
  auto* to = static_cast<char*>(target);
  while (count > 0) {
    const auto page = place / content_size, within = place % content_size;
    if (page < first_ || page - first_ >= loaded_pages_)
      load(page);
    const auto taken = std::min<std::uint64_t>(count, content_size - within);
    std::memcpy(to, &loaded_[(page - first_) * page_size + within], taken);
    to += taken;
    place += taken;
    count -= taken;
  }
}

} // namespace pcl::indoor::tool
