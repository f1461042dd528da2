/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Facts of the format: M. Isenburg, LASzip: lossless compression of LiDAR data, PE&RS
// 2013; LAZ Specification 1.4, R1.
#include "formats/laz/point_items.h"

#include "formats/laz/colors.h"
#include "formats/laz/gps_times.h"
#include "formats/laz/predictions.h"
#include "formats/laz/wave_packets.h"

#include <array>
#include <cstring>

namespace pcl::indoor::tool {
namespace {

constexpr std::size_t core_size = 20;
// places in the core of a point
constexpr std::size_t intensity_at = 12, returns_at = 14, class_at = 15, angle_at = 16,
                      user_at = 17, source_at = 18;

/** A byte that is predicted by what followed after its value before. */
class ByteAfterByte {
public:
  void
  next(ArithmeticDecoder& decoder, char& byte)
  {
    byte = static_cast<char>(decoder.symbol(models_[static_cast<unsigned char>(byte)]));
  }

private:
  SymbolModels models_{256, 256};
};

/** What all points have, of version 2. */
class CoreItem : public PointItem {
public:
  explicit CoreItem(const char* first)
  {
    std::memcpy(last_.data(), first, core_size);
    putNumber<std::uint16_t>(&last_[intensity_at], 0);
  }

  void
  next(ArithmeticDecoder& decoder, char* item) override;

private:
  /** Classification, angle, user data and source, as far as they changed. */
  void
  readAttributes(ArithmeticDecoder& decoder, unsigned changed);

  void
  readPlace(ArithmeticDecoder& decoder, unsigned returns, unsigned number);

  std::array<char, core_size> last_{};
  std::array<std::uint16_t, 16> intensities_{};
  std::array<RunningMedian, 16> x_steps_, y_steps_;
  std::array<std::int32_t, 8> heights_{};
  SymbolModel changed_{64};
  ByteAfterByte returns_, classes_, users_;
  SymbolModels angles_{2, 256};
  IntegerDecoder intensity_{16, 4}, source_{16, 1}, x_{32, 2}, y_{32, 22}, z_{32, 20};
};

void
CoreItem::next(ArithmeticDecoder& decoder, char* item)
{
  const unsigned changed = decoder.symbol(changed_);
  if ((changed & 32) != 0)
    returns_.next(decoder, last_[returns_at]);
  const auto bits = static_cast<unsigned char>(last_[returns_at]);
  const unsigned number = bits & 7, returns = bits >> 3 & 7;
  auto& intensity = intensities_[returnGroup(returns, number)];
  if ((changed & 16) != 0)
    intensity = static_cast<std::uint16_t>(intensity_.next(
        decoder, intensity, std::min(returnGroup(returns, number), 3u)));
  putNumber(&last_[intensity_at], intensity);
  readAttributes(decoder, changed);
  readPlace(decoder, returns, number);
  std::memcpy(item, last_.data(), core_size);
}

void
CoreItem::readAttributes(ArithmeticDecoder& decoder, unsigned changed)
{
  if ((changed & 8) != 0)
    classes_.next(decoder, last_[class_at]);
  if ((changed & 4) != 0) {
    const unsigned direction = static_cast<unsigned char>(last_[returns_at]) >> 6 & 1;
    last_[angle_at] = static_cast<char>(static_cast<unsigned char>(last_[angle_at]) +
                                        decoder.symbol(angles_[direction]));
  }
  if ((changed & 2) != 0)
    users_.next(decoder, last_[user_at]);
  if ((changed & 1) != 0)
    putNumber(&last_[source_at],
              static_cast<std::uint16_t>(
                  source_.next(decoder, numberAt<std::uint16_t>(&last_[source_at]))));
}

void
CoreItem::readPlace(ArithmeticDecoder& decoder, unsigned returns, unsigned number)
{
  const unsigned group = returnGroup(returns, number);
  const auto x_step = x_.next(decoder, x_steps_[group].value(), returns == 1);
  x_steps_[group].add(x_step);
  const auto y_step = y_.next(
      decoder, y_steps_[group].value(), lengthContext(returns, x_.length(), 20));
  y_steps_[group].add(y_step);
  auto& height = heights_[returnLevel(returns, number)];
  height = z_.next(
      decoder, height, lengthContext(returns, (x_.length() + y_.length()) / 2, 18));
  putNumber(&last_[0], wrappedSum(numberAt<std::int32_t>(&last_[0]), x_step));
  putNumber(&last_[4], wrappedSum(numberAt<std::int32_t>(&last_[4]), y_step));
  putNumber(&last_[8], height);
}

/** The median of three numbers. */
std::int32_t
middleOf(const std::array<std::int32_t, 3>& n)
{
  return std::max(std::min(n[0], n[1]), std::min(std::max(n[0], n[1]), n[2]));
}

/** What all points have, of version 1. */
class OldCoreItem : public PointItem {
public:
  explicit OldCoreItem(const char* first)
  {
    std::memcpy(last_.data(), first, core_size);
  }

  void
  next(ArithmeticDecoder& decoder, char* item) override;

private:
  void
  readAttributes(ArithmeticDecoder& decoder);

  std::array<char, core_size> last_{};
  std::array<std::int32_t, 3> x_steps_{}, y_steps_{};
  unsigned oldest_ = 0; ///< of the steps
  SymbolModel changed_{64};
  ByteAfterByte returns_, classes_, users_;
  IntegerDecoder x_{32, 1}, y_{32, 20}, z_{32, 20}, intensity_{16, 1}, angle_{8, 2},
      source_{16, 1};
};

void
OldCoreItem::next(ArithmeticDecoder& decoder, char* item)
{
  constexpr unsigned last_context = 19;
  const auto x_step = x_.next(decoder, middleOf(x_steps_));
  const auto y_step =
      y_.next(decoder, middleOf(y_steps_), std::min(x_.length(), last_context));
  const auto z = z_.next(decoder,
                         numberAt<std::int32_t>(&last_[8]),
                         std::min((x_.length() + y_.length()) / 2, last_context));
  putNumber(&last_[0], wrappedSum(numberAt<std::int32_t>(&last_[0]), x_step));
  putNumber(&last_[4], wrappedSum(numberAt<std::int32_t>(&last_[4]), y_step));
  putNumber(&last_[8], z);
  readAttributes(decoder);
  x_steps_[oldest_] = x_step;
  y_steps_[oldest_] = y_step;
  oldest_ = (oldest_ + 1) % 3;
  std::memcpy(item, last_.data(), core_size);
}

void
OldCoreItem::readAttributes(ArithmeticDecoder& decoder)
{
  const unsigned changed = decoder.symbol(changed_);
  const auto read = [&](IntegerDecoder& numbers, std::size_t at) {
    const auto last = numberAt<std::uint16_t>(&last_[at]);
    putNumber(&last_[at], static_cast<std::uint16_t>(numbers.next(decoder, last)));
  };
  if ((changed & 32) != 0)
    read(intensity_, intensity_at);
  if ((changed & 16) != 0)
    returns_.next(decoder, last_[returns_at]);
  if ((changed & 8) != 0)
    classes_.next(decoder, last_[class_at]);
  if ((changed & 4) != 0)
    last_[angle_at] =
        static_cast<char>(angle_.next(decoder,
                                      static_cast<unsigned char>(last_[angle_at]),
                                      (x_.length() + y_.length()) / 2 < 3));
  if ((changed & 2) != 0)
    users_.next(decoder, last_[user_at]);
  if ((changed & 1) != 0)
    read(source_, source_at);
}

template <typename Times>
class TimeItem : public PointItem {
public:
  explicit TimeItem(Times times)
  : times_(std::move(times))
  {}

  void
  next(ArithmeticDecoder& decoder, char* item) override
  {
    putNumber(item, times_.next(decoder));
  }

private:
  Times times_;
};

template <typename Decoder>
class ColorItem : public PointItem {
public:
  explicit ColorItem(const char* first)
  : last_(numberAt<Color>(first))
  {}

  void
  next(ArithmeticDecoder& decoder, char* item) override
  {
    last_ = colors_.next(decoder, last_);
    putNumber(item, last_);
  }

private:
  Decoder colors_;
  Color last_;
};

class WaveItem : public PointItem {
public:
  explicit WaveItem(const char* first)
  {
    std::memcpy(last_.data(), first, last_.size());
  }

  void
  next(ArithmeticDecoder& decoder, char* item) override
  {
    packets_.next(decoder, last_.data());
    std::memcpy(item, last_.data(), last_.size());
  }

private:
  WavePackets packets_;
  std::array<char, wave_packet_size> last_{};
};

class BytesItem : public PointItem {
public:
  BytesItem(const char* first, std::size_t count)
  : last_(first, count)
  , models_(count, 256)
  {}

  void
  next(ArithmeticDecoder& decoder, char* item) override
  {
    for (std::size_t i = 0; i < last_.size(); ++i)
      last_[i] = static_cast<char>(static_cast<unsigned char>(last_[i]) +
                                   decoder.symbol(models_[i]));
    std::memcpy(item, last_.data(), last_.size());
  }

private:
  std::string last_;
  SymbolModels models_;
};

class OldBytesItem : public PointItem {
public:
  OldBytesItem(const char* first, std::size_t count)
  : last_(first, count)
  , numbers_(8, static_cast<unsigned>(count))
  {}

  void
  next(ArithmeticDecoder& decoder, char* item) override
  {
    for (std::size_t i = 0; i < last_.size(); ++i)
      last_[i] = static_cast<char>(numbers_.next(
          decoder, static_cast<unsigned char>(last_[i]), static_cast<unsigned>(i)));
    std::memcpy(item, last_.data(), last_.size());
  }

private:
  std::string last_;
  IntegerDecoder numbers_;
};

/** \tparam Old, New of versions 1 and 2 */
template <typename Old, typename New, typename... Arguments>
std::unique_ptr<PointItem>
ofVersion(unsigned version, const Arguments&... arguments)
{
  if (version == 1)
    return std::make_unique<Old>(arguments...);
  if (version == 2)
    return std::make_unique<New>(arguments...);
  return nullptr;
}

std::unique_ptr<PointItem>
timeItem(unsigned version, std::uint64_t first)
{
  if (version == 1)
    return std::make_unique<TimeItem<OldGpsTimes>>(OldGpsTimes(first));
  if (version == 2)
    return std::make_unique<TimeItem<GpsTimes>>(GpsTimes(first, false));
  return nullptr;
}

} // namespace

std::unique_ptr<PointItem>
makePointItem(const LazItem& item, const char* first)
{
  switch (item.type) {
  case LazItem::Type::Core:
    return ofVersion<OldCoreItem, CoreItem>(item.version, first);
  case LazItem::Type::Time:
    return timeItem(item.version, numberAt<std::uint64_t>(first));
  case LazItem::Type::Color:
    return ofVersion<ColorItem<OldColors>, ColorItem<Colors>>(item.version, first);
  case LazItem::Type::Wave:
    return item.version == 1 ? std::make_unique<WaveItem>(first) : nullptr;
  case LazItem::Type::Bytes:
    return ofVersion<OldBytesItem, BytesItem>(item.version, first, item.size);
  default:
    return nullptr;
  }
}

} // namespace pcl::indoor::tool
