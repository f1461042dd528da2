/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstdint>
#include <cstring>
#include <string>

namespace pcl::indoor::test {

/** \brief Makes the records of points of a LAS file: of a scanner that turns, with some
 * returns to a pulse, times that jump, colours and channels that change. */
class LazPoints {
public:
  LazPoints(int format, int extra_bytes)
  : format_(format)
  , extra_bytes_(extra_bytes)
  {}

  std::string
  records(int count)
  {
    std::string bytes;
    for (index_ = 0; index_ < count; ++index_) {
      changePulse();
      addCore(bytes);
      if (hasTime())
        add<double>(bytes, time_);
      addColor(bytes);
      addWave(bytes);
      for (int i = 0; i < extra_bytes_; ++i)
        add<std::uint8_t>(bytes, static_cast<std::uint8_t>((index_ >> i) + below(2)));
    }
    return bytes;
  }

private:
  template <typename T>
  static void
  add(std::string& bytes, T value)
  {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  }

  int
  below(int end)
  {
    state_ = state_ * 1664525u + 1013904223u; // Numerical Recipes
    return static_cast<int>((state_ >> 8) % static_cast<std::uint32_t>(end));
  }

  bool
  isLong() const
  {
    return format_ >= 6;
  }

  bool
  hasTime() const
  {
    return format_ != 0 && format_ != 2;
  }

  void
  changePulse()
  {
    if (++number_ <= returns_)
      return;
    number_ = 1;
    returns_ = below(3) == 0 ? 1 + below(isLong() ? 12 : 5) : 1;
    time_ += below(15) == 0 ? 1.25 : 0.0000152587890625;
    if (below(40) == 0)
      time_ += 1e9;
    if (below(6) == 0)
      channel_ = below(4);
  }

  void
  addCore(std::string& bytes)
  {
    const int leap = below(50) == 0 ? 1 << 30 : 0;
    add<std::int32_t>(bytes, index_ * 137 + below(9) + leap);
    add<std::int32_t>(bytes, (index_ % 20 - 10) * 150 + below(9) - leap);
    add<std::int32_t>(bytes, 2500 - number_ * 90 + below(9));
    add<std::uint16_t>(bytes,
                       static_cast<std::uint16_t>(900 + 100 * number_ + below(60)));
    const auto turn =
        static_cast<std::uint8_t>((index_ / 20 % 2) << 6 | (index_ % 20 == 0) << 7);
    const auto some_class = static_cast<std::uint8_t>(below(9) == 0 ? below(256) : 2);
    const auto user = static_cast<std::uint8_t>(below(9) == 0 ? below(256) : 7);
    const int angle = index_ % 20 - 10;
    if (isLong()) {
      add<std::uint8_t>(bytes, static_cast<std::uint8_t>(number_ | returns_ << 4));
      add<std::uint8_t>(bytes,
                        static_cast<std::uint8_t>(turn | channel_ << 4 |
                                                  (below(30) == 0 ? below(16) : 0)));
      add<std::uint8_t>(bytes, some_class);
      add<std::uint8_t>(bytes, user);
      add<std::int16_t>(bytes, static_cast<std::int16_t>(angle * 1000));
    }
    else {
      add<std::uint8_t>(bytes,
                        static_cast<std::uint8_t>(number_ | returns_ << 3 | turn));
      add<std::uint8_t>(bytes, some_class);
      add<std::int8_t>(bytes, static_cast<std::int8_t>(angle));
      add<std::uint8_t>(bytes, user);
    }
    add<std::uint16_t>(bytes, static_cast<std::uint16_t>(index_ / 60));
  }

  void
  addColor(std::string& bytes)
  {
    const bool has_colors = format_ == 2 || format_ == 3 || format_ == 5 ||
                            format_ == 7 || format_ == 8 || format_ == 10;
    const int channels = !has_colors ? 0 : format_ == 8 || format_ == 10 ? 4 : 3;
    const int change = below(3) == 0 ? below(1000) - 500 : 0;
    const bool is_grey = below(4) == 0;
    for (int c = 0; c < channels; ++c) {
      colors_[c] = static_cast<std::uint16_t>(
          is_grey && c < 3 && c > 0 ? colors_[0] : colors_[c] + change + below(2) * c);
      add<std::uint16_t>(bytes, colors_[c]);
    }
  }

  void
  addWave(std::string& bytes)
  {
    if (format_ != 4 && format_ != 5 && format_ != 9 && format_ != 10)
      return;
    const std::uint32_t size = below(5) == 0 ? 256 : 128;
    add<std::uint8_t>(bytes, static_cast<std::uint8_t>(1 + below(2)));
    add<std::uint64_t>(bytes, wave_);
    add<std::uint32_t>(bytes, size);
    for (int c = 0; c < 4; ++c)
      add<float>(bytes, 0.25f * static_cast<float>(below(100)));
    wave_ += below(20) == 0 ? std::uint64_t(1) << 40 : below(3) == 0 ? 0 : size;
  }

  int format_, extra_bytes_, index_ = 0;
  int number_ = 1, returns_ = 1, channel_ = 1;
  double time_ = 300000.5;
  std::uint16_t colors_[4] = {30000, 20000, 10000, 5000};
  std::uint64_t wave_ = 60;
  std::uint32_t state_ = 1;
};

} // namespace pcl::indoor::test
