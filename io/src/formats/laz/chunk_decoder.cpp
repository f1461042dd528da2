/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Facts of the format: LAZ Specification 1.4, R1.
#include "formats/laz/chunk_decoder.h"

#include "formats/laz/layered_items.h"
#include "formats/laz/point_items.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <vector>

namespace pcl::indoor::tool {
namespace {

std::size_t
sizeOfPoint(const LazLayout& layout)
{
  std::size_t size = 0;
  for (const auto& item : layout.items)
    size += item.size;
  return size;
}

/** Points one after the other, each of its items one after the other. */
class PointWiseDecoder : public ChunkDecoder {
public:
  PointWiseDecoder(const LazLayout& layout, ByteSource source)
  : decoder_(std::move(source))
  , first_(sizeOfPoint(layout), '\0')
  {
    decoder_.source().take(first_.data(), first_.size());
    const char* item = first_.data();
    for (const auto& about : layout.items) {
      items_.push_back({makePointItem(about, item), about.size});
      item += about.size;
    }
    decoder_.start();
  }

  void
  next(char* record) override
  {
    if (is_first_) {
      std::memcpy(record, first_.data(), first_.size());
      is_first_ = false;
      return;
    }
    for (const auto& item : items_) {
      item.decoder->next(decoder_, record);
      record += item.size;
    }
  }

  bool
  isAtEnd() const override
  {
    return decoder_.isAtEnd();
  }

private:
  struct Item {
    std::unique_ptr<PointItem> decoder;
    std::size_t size;
  };

  ArithmeticDecoder decoder_;
  std::string first_;
  bool is_first_ = true;
  std::vector<Item> items_;
};

/** Points whose parts are in layers, all behind the sizes of all. */
class LayeredDecoder : public ChunkDecoder {
public:
  /** \param[in] bytes of the chunk */
  LayeredDecoder(const LazLayout& layout, std::string bytes);

  void
  next(char* record) override;

  bool
  isAtEnd() const override
  {
    return left_ == 0 && rest_.empty() &&
           std::all_of(items_.begin(), items_.end(), [](const auto& item) {
             return item.decoder->isAtEnd();
           });
  }

private:
  struct Item {
    std::unique_ptr<LayeredItem> decoder;
    std::size_t size;
  };

  /** Take so many bytes from the front of the rest. */
  std::string_view
  take(std::size_t size);

  std::string bytes_;
  std::string_view rest_, first_;
  bool is_first_ = true;
  unsigned channel_ = 0;
  std::uint32_t left_ = 0; ///< points
  std::vector<Item> items_;
};

LayeredDecoder::LayeredDecoder(const LazLayout& layout, std::string bytes)
: bytes_(std::move(bytes))
, rest_(bytes_)
, first_(take(sizeOfPoint(layout)))
, channel_(scannerChannel(first_.data()))
, left_(numberAt<std::uint32_t>(take(4).data()))
{
  std::size_t count = 0;
  for (const auto& item : layout.items)
    count += layerCount(item);
  const auto sizes = take(4 * count);
  std::vector<Layer> layers(count);
  for (std::size_t i = 0; i < count; ++i)
    if (const auto size = numberAt<std::uint32_t>(&sizes[4 * i]); size > 0) {
      layers[i].emplace(ByteSource(take(size)));
      layers[i]->start();
    }
  const char* first = first_.data();
  auto layer = layers.begin();
  for (const auto& item : layout.items) {
    const auto end = layer + static_cast<std::ptrdiff_t>(layerCount(item));
    items_.push_back({makeLayeredItem(item,
                                      first,
                                      channel_,
                                      {std::make_move_iterator(layer),
                                       std::make_move_iterator(end)}),
                      item.size});
    layer = end;
    first += item.size;
  }
}

std::string_view
LayeredDecoder::take(std::size_t size)
{
  if (size > rest_.size())
    throw DamagedChunk("its bytes end before its points");
  const auto taken = rest_.substr(0, size);
  rest_.remove_prefix(size);
  return taken;
}

void
LayeredDecoder::next(char* record)
{
  if (left_ == 0)
    throw DamagedChunk("it has fewer points than the file's table says");
  --left_;
  if (is_first_) {
    std::memcpy(record, first_.data(), first_.size());
    is_first_ = false;
    return;
  }
  for (const auto& item : items_) {
    item.decoder->next(channel_, record);
    record += item.size;
  }
}

std::string
bytesOf(const std::string& path, std::uint64_t begin, std::uint64_t end)
{
  std::ifstream stream(path, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(begin));
  std::string bytes(end - begin, '\0');
  if (!stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
    throw DamagedChunk("its bytes end before its points");
  return bytes;
}

} // namespace

std::unique_ptr<ChunkDecoder>
ChunkDecoder::open(const std::string& path,
                   const LazLayout& layout,
                   std::uint64_t begin,
                   std::uint64_t end)
{
  if (layout.isLayered())
    return std::make_unique<LayeredDecoder>(layout, bytesOf(path, begin, end));
  return std::make_unique<PointWiseDecoder>(layout, ByteSource(path, begin, end));
}

bool
isKnown(const LazLayout& layout)
{
  const std::string zeros(sizeOfPoint(layout), '\0');
  return std::all_of(
      layout.items.begin(), layout.items.end(), [&](const LazItem& item) {
        return layout.isLayered() ? layerCount(item) > 0
                                  : makePointItem(item, zeros.data()) != nullptr;
      });
}

} // namespace pcl::indoor::tool
