/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Facts of the format: M. Isenburg, LAZ 1.4 compression; LAZ Specification 1.4, R1.
#include "formats/laz/layered_items.h"

#include "formats/laz/colors.h"
#include "formats/laz/layered_core.h"
#include "formats/laz/predictions.h"
#include "formats/laz/wave_packets.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace pcl::indoor::tool {
namespace {

/** An item that has models for each channel of the scanner.
 * \tparam Models are made of the item that was the last one, and have it: last */
template <typename Models>
class ChannelItem : public LayeredItem {
public:
  ChannelItem(const LazItem& item,
              const char* first,
              unsigned channel,
              std::vector<Layer> layers)
  : size_(item.size)
  , is_old_(item.version < 4)
  , channel_(channel)
  , layers_(std::move(layers))
  {
    channels_[channel] = std::make_unique<Models>(std::string(first, size_));
  }

  void
  next(unsigned& channel, char* item) override
  {
    auto* last = &channels_[channel_]->last;
    if (channel != channel_) {
      const bool is_new = !channels_[channel];
      if (is_new)
        channels_[channel] = std::make_unique<Models>(*last);
      channel_ = channel;
      if (is_new || !is_old_) // version 3 goes on from the last point of any channel
        last = &channels_[channel_]->last;
    }
    channels_[channel_]->next(layers_, *last);
    std::memcpy(item, last->data(), size_);
  }

  bool
  isAtEnd() const override
  {
    return std::all_of(layers_.begin(), layers_.end(), [](const auto& layer) {
      return !layer || layer->isAtEnd();
    });
  }

private:
  std::size_t size_;
  bool is_old_;
  unsigned channel_;
  std::vector<Layer> layers_;
  std::array<std::unique_ptr<Models>, 4> channels_;
};

struct ColorModels {
  explicit ColorModels(std::string first)
  : last(std::move(first))
  {}

  void
  next(std::vector<Layer>& layers, std::string& item)
  {
    if (layers[0])
      putNumber(item.data(), colors.next(*layers[0], numberAt<Color>(item.data())));
  }

  std::string last;
  Colors colors;
};

struct ColorInfraredModels : ColorModels {
  using ColorModels::ColorModels;

  void
  next(std::vector<Layer>& layers, std::string& item)
  {
    ColorModels::next(layers, item);
    char* const place = &item[sizeof(Color)];
    if (layers[1])
      putNumber(place, infrared.next(*layers[1], numberAt<std::uint16_t>(place)));
  }

  InfraredValues infrared;
};

struct WaveModels {
  explicit WaveModels(std::string first)
  : last(std::move(first))
  {}

  void
  next(std::vector<Layer>& layers, std::string& item)
  {
    if (layers[0])
      packets.next(*layers[0], item.data());
  }

  std::string last;
  WavePackets packets;
};

struct ByteModels {
  explicit ByteModels(std::string first)
  : last(std::move(first))
  , models(last.size(), 256)
  {}

  void
  next(std::vector<Layer>& layers, std::string& item)
  {
    for (std::size_t i = 0; i < layers.size(); ++i)
      if (layers[i])
        item[i] = static_cast<char>(static_cast<unsigned char>(item[i]) +
                                    layers[i]->symbol(models[i]));
  }

  std::string last;
  SymbolModels models;
};

} // namespace

std::size_t
layerCount(const LazItem& item)
{
  if (item.version < 2 || item.version > 4)
    return 0;
  switch (item.type) {
  case LazItem::Type::LayeredCore:
    return layered_core_layers;
  case LazItem::Type::LayeredColor:
  case LazItem::Type::LayeredWave:
    return 1;
  case LazItem::Type::LayeredColorInfrared:
    return 2;
  case LazItem::Type::LayeredBytes:
    return item.size;
  default:
    return 0;
  }
}

std::unique_ptr<LayeredItem>
makeLayeredItem(const LazItem& item,
                const char* first,
                unsigned channel,
                std::vector<Layer> layers)
{
  switch (item.type) {
  case LazItem::Type::LayeredCore:
    return makeLayeredCore(item.version, first, std::move(layers));
  case LazItem::Type::LayeredColor:
    return std::make_unique<ChannelItem<ColorModels>>(
        item, first, channel, std::move(layers));
  case LazItem::Type::LayeredColorInfrared:
    return std::make_unique<ChannelItem<ColorInfraredModels>>(
        item, first, channel, std::move(layers));
  case LazItem::Type::LayeredWave:
    return std::make_unique<ChannelItem<WaveModels>>(
        item, first, channel, std::move(layers));
  case LazItem::Type::LayeredBytes:
    return std::make_unique<ChannelItem<ByteModels>>(
        item, first, channel, std::move(layers));
  default:
    return nullptr;
  }
}

} // namespace pcl::indoor::tool
