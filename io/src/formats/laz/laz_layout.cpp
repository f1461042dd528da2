/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Facts of the format: LAZ Specification 1.4, R1.
#include "formats/laz/laz_layout.h"

#include "files/tool_error.h"

namespace pcl::indoor::tool {
namespace {

constexpr std::uint16_t layout_record = 22204;
constexpr std::size_t layout_size = 34; // before its items, of 6 bytes each

/** The bytes of an item in a point; 0: any number of them. */
std::size_t
sizeOf(LazItem::Type type)
{
  using Type = LazItem::Type;
  switch (type) {
  case Type::Core:
    return 20;
  case Type::Time:
  case Type::LayeredColorInfrared:
    return 8;
  case Type::Color:
  case Type::LayeredColor:
    return 6;
  case Type::Wave:
  case Type::LayeredWave:
    return 29;
  case Type::LayeredCore:
    return 30;
  default:
    return 0;
  }
}

/** Do the items make up the points of the header, in their order? */
bool
fit(const LazLayout& layout, const LasHeader& header)
{
  std::size_t step = 0;
  for (const auto& item : layout.items) {
    const auto size = sizeOf(item.type);
    const bool is_core =
        item.type == LazItem::Type::Core || item.type == LazItem::Type::LayeredCore;
    if (item.size == 0 || (size > 0 && item.size != size) || is_core != (step == 0))
      return false;
    step += item.size;
  }
  return step == header.step && header.isLong() == layout.isLayered();
}

} // namespace

LazLayout
readLazLayout(const std::string& bytes,
              const LasHeader& header,
              const std::string& path)
{
  const auto record = lasRecord(bytes, header, "laszip encoded", layout_record);
  if (record.size() < layout_size)
    throw ToolError(path + ": this LAZ file does not tell how it is compressed");
  LazLayout layout;
  const auto compressor = numberAt<std::uint16_t>(&record[0]);
  const auto coder = numberAt<std::uint16_t>(&record[2]);
  const std::size_t items = numberAt<std::uint16_t>(&record[32]);
  if (compressor < 1 || compressor > 3 || coder != 0)
    throw ToolError(path +
                    ": this LAZ file is compressed in a way that is not known "
                    "(compressor " +
                    std::to_string(compressor) + ", coder " + std::to_string(coder) +
                    ")");
  layout.compressor = static_cast<LazLayout::Compressor>(compressor);
  if (const auto size = numberAt<std::uint32_t>(&record[12]); size > 0)
    layout.chunk_size = size;
  if (items * 6 > record.size() - layout_size)
    throw ToolError(path + ": the record of this LAZ file that tells how it is "
                           "compressed is damaged");
  for (std::size_t i = 0; i < items; ++i) {
    const char* const item = &record[layout_size + 6 * i];
    layout.items.push_back({static_cast<LazItem::Type>(numberAt<std::uint16_t>(item)),
                            numberAt<std::uint16_t>(item + 2),
                            numberAt<std::uint16_t>(item + 4)});
  }
  if (!fit(layout, header))
    throw ToolError(path + ": the points of this LAZ file are not compressed as those "
                           "of its point format");
  return layout;
}

} // namespace pcl::indoor::tool
