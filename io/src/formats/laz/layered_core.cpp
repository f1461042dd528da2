/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Facts of the format: M. Isenburg, LAZ 1.4 compression; LAZ Specification 1.4, R1.
#include "formats/laz/layered_core.h"

#include "formats/laz/gps_times.h"
#include "formats/laz/predictions.h"

#include <array>
#include <cstring>

namespace pcl::indoor::tool {
namespace {

// places in a point
constexpr std::size_t layered_intensity = 12, layered_returns = 14, layered_flags = 15,
                      layered_class = 16, layered_user = 17, layered_angle = 18,
                      layered_source = 20, layered_time = 22;

using Core = std::array<char, layered_core_size>;

/** What is known of the points of a channel of the scanner. */
struct Channel {
  explicit Channel(const Core& first)
  : last(first)
  , times(numberAt<std::uint64_t>(&first[layered_time]), true)
  {
    heights.fill(numberAt<std::int32_t>(&first[8]));
    intensities.fill(numberAt<std::uint16_t>(&first[layered_intensity]));
  }

  Core last;
  bool time_changed = false; ///< with the last point
  // in the layer of channels, returns, x and y
  SymbolModels changed{8, 128}, returns{16, 16}, numbers{16, 16};
  SymbolModel other_channel{3}, number_of_same_pulse{13};
  std::array<RunningMedian, 12> x_steps, y_steps;
  IntegerDecoder x{32, 2}, y{32, 22};
  // in a layer each
  std::array<std::int32_t, 8> heights{};
  IntegerDecoder z{32, 20};
  SymbolModels classes{64, 256}, flags{64, 64}, users{64, 256};
  std::array<std::uint16_t, 8> intensities{};
  IntegerDecoder intensity{16, 4}, angle{16, 2}, source{16, 1};
  GpsTimes times;
};

/** What a point has new, by the layer of channels, returns, x and y. */
struct Changes {
  bool source, time, angle;
};

class LayeredCore : public LayeredItem {
public:
  LayeredCore(unsigned version, const char* first, std::vector<Layer> layers);

  void
  next(unsigned& channel, char* item) override;

  bool
  isAtEnd() const override;

private:
  enum LayerOf { Place, Z, Class, Flags, Intensity, Angle, User, Source, Time };

  /** Switches to the scanner channel that the data names; one seen for the first time
   * starts from the last point of the previous channel.
   * \return its number */
  unsigned
  changeChannel();

  void
  readReturns(Channel& channel, unsigned changed, bool time_changed);

  void
  readPlace(Channel& channel, bool time_changed);

  void
  readAttributes(Channel& channel, const Changes& changes);

  void
  readNumbers(Channel& channel, const Changes& changes);

  unsigned version_, channel_;
  std::vector<Layer> layers_;
  std::array<std::unique_ptr<Channel>, 4> channels_;
};

unsigned
numberOf(const Core& core)
{
  return static_cast<unsigned char>(core[layered_returns]) & 15;
}

unsigned
returnsOf(const Core& core)
{
  return static_cast<unsigned char>(core[layered_returns]) >> 4;
}

/** Whether a point is the first (bit 1) and the last (bit 0) return of its pulse. */
unsigned
endsOf(const Core& core)
{
  const unsigned number = numberOf(core);
  return (number == 1 ? 2 : 0) + (number >= returnsOf(core) ? 1 : 0);
}

LayeredCore::LayeredCore(unsigned version, const char* first, std::vector<Layer> layers)
: version_(version)
, channel_(scannerChannel(first))
, layers_(std::move(layers))
{
  if (!layers_[Place])
    throw DamagedChunk("its layer of coordinates is empty");
  channels_[channel_] = std::make_unique<Channel>(numberAt<Core>(first));
}

bool
LayeredCore::isAtEnd() const
{
  return std::all_of(layers_.begin(), layers_.end(), [](const auto& layer) {
    return !layer || layer->isAtEnd();
  });
}

void
LayeredCore::next(unsigned& channel, char* item)
{
  constexpr unsigned last_version_without_channel = 3;
  auto* known = channels_[channel_].get();
  const unsigned ends = endsOf(known->last);
  const unsigned context =
      (ends >> 1) | (ends & 1) << 1 | (known->time_changed ? 4u : 0u);
  const unsigned changed = layers_[Place]->symbol(known->changed[context]);
  const bool channel_changed = (changed & 64) != 0;
  if (channel_changed)
    known = channels_[changeChannel()].get();
  // up to version 3 other items are told 0 by all points but the first of a channel
  channel = channel_changed || version_ > last_version_without_channel ? channel_ : 0;
  const Changes changes = {
      (changed & 32) != 0, (changed & 16) != 0, (changed & 8) != 0};
  readReturns(*known, changed, changes.time);
  readPlace(*known, changes.time);
  readAttributes(*known, changes);
  readNumbers(*known, changes);
  known->time_changed = changes.time;
  std::memcpy(item, known->last.data(), layered_core_size);
}

unsigned
LayeredCore::changeChannel()
{
  const auto& before = *channels_[channel_];
  channel_ =
      (channel_ + 1 + layers_[Place]->symbol(channels_[channel_]->other_channel)) % 4;
  auto& known = channels_[channel_];
  if (!known)
    known = std::make_unique<Channel>(before.last);
  const unsigned others =
      static_cast<unsigned char>(known->last[layered_flags]) & ~0x30u;
  known->last[layered_flags] = static_cast<char>(others | channel_ << 4);
  return channel_;
}

void
LayeredCore::readReturns(Channel& channel, unsigned changed, bool time_changed)
{
  auto& decoder = *layers_[Place];
  unsigned returns = returnsOf(channel.last), number = numberOf(channel.last);
  if ((changed & 4) != 0)
    returns = decoder.symbol(channel.returns[returns]);
  switch (changed & 3) {
  case 0:
    break;
  case 1:
    ++number;
    break;
  case 2:
    --number;
    break;
  default:
    if (time_changed)
      number = decoder.symbol(channel.numbers[number]);
    else
      number += 2 + decoder.symbol(channel.number_of_same_pulse);
  }
  channel.last[layered_returns] = static_cast<char>(returns << 4 | (number & 15));
}

void
LayeredCore::readPlace(Channel& channel, bool time_changed)
{
  auto& decoder = *layers_[Place];
  auto& last = channel.last;
  const unsigned returns = returnsOf(last), number = numberOf(last);
  const unsigned group = layeredReturnGroup(returns, number) << 1 | time_changed;
  const auto x_step =
      channel.x.next(decoder, channel.x_steps[group].value(), returns == 1);
  channel.x_steps[group].add(x_step);
  const auto y_step = channel.y.next(decoder,
                                     channel.y_steps[group].value(),
                                     lengthContext(returns, channel.x.length(), 20));
  channel.y_steps[group].add(y_step);
  putNumber(&last[0], wrappedSum(numberAt<std::int32_t>(&last[0]), x_step));
  putNumber(&last[4], wrappedSum(numberAt<std::int32_t>(&last[4]), y_step));
  if (!layers_[Z])
    return;
  auto& height = channel.heights[returnLevel(returns, number)];
  const unsigned length = (channel.x.length() + channel.y.length()) / 2;
  height = channel.z.next(*layers_[Z], height, lengthContext(returns, length, 18));
  putNumber(&last[8], height);
}

void
LayeredCore::readAttributes(Channel& channel, const Changes& changes)
{
  auto& last = channel.last;
  const unsigned ends = endsOf(last);
  if (auto& layer = layers_[Class]) {
    const unsigned before = static_cast<unsigned char>(last[layered_class]);
    last[layered_class] = static_cast<char>(
        layer->symbol(channel.classes[(before & 31) << 1 | (ends == 3)]));
  }
  if (auto& layer = layers_[Flags]) { // the four lowest bits, and the two highest
    const unsigned bits = static_cast<unsigned char>(last[layered_flags]);
    const unsigned now = layer->symbol(channel.flags[(bits >> 2 & 48) | (bits & 15)]);
    last[layered_flags] = static_cast<char>((now & 48) << 2 | (bits & 48) | (now & 15));
  }
  if (auto& layer = layers_[Intensity]) {
    auto& intensity = channel.intensities[ends << 1 | changes.time];
    intensity =
        static_cast<std::uint16_t>(channel.intensity.next(*layer, intensity, ends));
    putNumber(&last[layered_intensity], intensity);
  }
}

void
LayeredCore::readNumbers(Channel& channel, const Changes& changes)
{
  auto& last = channel.last;
  if (layers_[Angle] && changes.angle) {
    const auto before = numberAt<std::int16_t>(&last[layered_angle]);
    putNumber(&last[layered_angle],
              static_cast<std::int16_t>(
                  channel.angle.next(*layers_[Angle], before, changes.time)));
  }
  if (auto& layer = layers_[User]) {
    const unsigned before = static_cast<unsigned char>(last[layered_user]);
    last[layered_user] = static_cast<char>(layer->symbol(channel.users[before / 4]));
  }
  if (layers_[Source] && changes.source) {
    const auto before = numberAt<std::uint16_t>(&last[layered_source]);
    putNumber(
        &last[layered_source],
        static_cast<std::uint16_t>(channel.source.next(*layers_[Source], before)));
  }
  if (layers_[Time] && changes.time)
    putNumber(&last[layered_time], channel.times.next(*layers_[Time]));
}

} // namespace

std::unique_ptr<LayeredItem>
makeLayeredCore(unsigned version, const char* first, std::vector<Layer> layers)
{
  return std::make_unique<LayeredCore>(version, first, std::move(layers));
}

} // namespace pcl::indoor::tool
