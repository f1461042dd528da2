/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Facts of the format: M. Isenburg, LASzip: lossless compression of LiDAR data, PE&RS
// 2013; its arithmetic coding is that of A. Said, HP Labs HPL-2004-76.
#pragma once

#include "formats/laz/byte_source.h"

#include <algorithm>
#include <cstdint>
#include <memory>

namespace pcl::indoor::tool {

/** \brief How often each of some symbols was seen, from which their shares follow. */
class SymbolModel {
public:
  SymbolModel() = default;

  /** \param[in] symbols 2 to 1024, equally likely at first */
  explicit SymbolModel(unsigned symbols);

  bool
  isEmpty() const
  {
    return symbols_ == 0;
  }

private:
  friend class ArithmeticDecoder;

  static constexpr unsigned share_bits = 15; ///< the shares of all sum up to 2^15

  void
  update();

  unsigned symbols_ = 0, table_shift_ = 0;
  std::uint32_t total_ = 0, cycle_ = 0, until_update_ = 0;
  std::unique_ptr<std::uint16_t[]> memory_;
  std::uint16_t* begins_ =
      nullptr; ///< of the share of each symbol; two more, never reached
  std::uint16_t* counts_ = nullptr;
  std::uint16_t* table_ = nullptr; ///< for each of some places the symbol there
};

/** \brief The same for two symbols. */
class BitModel {
private:
  friend class ArithmeticDecoder;

  static constexpr unsigned share_bits = 13;

  void
  update();

  std::uint32_t zeros_ = 1, total_ = 2, zero_share_ = 1 << (share_bits - 1);
  std::uint32_t cycle_ = 4, until_update_ = 4;
};

/** \brief Decodes symbols that were coded by an adaptive arithmetic coder.
 *
 * Functions throw DamagedChunk where the bytes end too early. */
class ArithmeticDecoder {
public:
  /** \brief Take over the bytes; start() must be called before symbols are read. */
  explicit ArithmeticDecoder(ByteSource source)
  : source_(std::move(source))
  {}

  ByteSource&
  source()
  {
    return source_;
  }

  void
  start()
  {
    length_ = 0xffffffffu;
    value_ = source_.next(4);
    if (value_ == length_) // it is less, also after each symbol
      throw DamagedChunk("its bytes are none of symbols");
  }

  unsigned
  symbol(SymbolModel& model)
  {
    const std::uint32_t unit = length_ >> SymbolModel::share_bits;
    const std::uint32_t place = value_ / unit;
    const std::uint16_t* const begins = model.begins_;
    unsigned symbol = model.table_[place >> model.table_shift_];
    // mostly it is that symbol or the next one: chosen without a branch
    const bool is_next = begins[symbol + 1] <= place;
    std::uint32_t begin = is_next ? begins[symbol + 1] : begins[symbol];
    std::uint32_t end = is_next ? begins[symbol + 2] : begins[symbol + 1];
    symbol += is_next;
    for (; end <= place; end = begins[symbol + 1]) {
      begin = end;
      ++symbol;
    }
    begin *= unit;
    end = symbol + 1 == model.symbols_ ? length_ : end * unit;
    narrow(begin, end);
    ++model.counts_[symbol];
    if (--model.until_update_ == 0)
      model.update();
    return symbol;
  }

  unsigned
  bit(BitModel& model)
  {
    const std::uint32_t middle = model.zero_share_ * (length_ >> BitModel::share_bits);
    const bool is_one = value_ >= middle;
    narrow(is_one ? middle : 0, is_one ? length_ : middle);
    model.zeros_ += !is_one;
    if (--model.until_update_ == 0)
      model.update();
    return is_one;
  }

  /** \brief A number of 1 to 32 bits that was not modelled. */
  std::uint32_t
  bits(unsigned count)
  {
    constexpr unsigned most = 19; // that 32 bits of the decoder have room for
    if (count <= most)
      return fewBits(count);
    const auto low = fewBits(16);
    return fewBits(count - 16) << 16 | low;
  }

  bool
  isAtEnd() const
  {
    return source_.isAtEnd();
  }

private:
  /** Take a part of the range for the whole. */
  void
  narrow(std::uint32_t begin, std::uint32_t end)
  {
    value_ -= begin;
    length_ = end - begin;
    // whole bytes, none as a rule: it costs less than to ask whether there are any
    const auto bytes = static_cast<unsigned>(__builtin_clz(length_)) / 8;
    value_ = value_ << 8 * bytes | source_.next(bytes);
    length_ <<= 8 * bytes;
  }

  std::uint32_t
  fewBits(unsigned count)
  {
    const std::uint32_t unit = length_ >> count;
    const std::uint32_t number = value_ / unit;
    if (number >> count != 0)
      throw DamagedChunk("its bytes are none of numbers");
    narrow(number * unit, (number + 1) * unit);
    return number;
  }

  ByteSource source_;
  std::uint32_t value_ = 0, length_ = 0;
};

} // namespace pcl::indoor::tool
