/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/laz/arithmetic_decoder.h"

namespace pcl::indoor::tool {
namespace {

constexpr std::uint32_t whole = 1u << 31; // of which shares are computed

/** Two places of the table for each symbol: few are then searched for. */
unsigned
tableBits(unsigned symbols)
{
  unsigned bits = 2;
  while ((1u << bits) < 2 * symbols)
    ++bits;
  return bits;
}

/** Entries of the table: a place is the value by the 2^15th part of the length, which
 * is rounded down, by at most one of 2^9. */
unsigned
tableSize(unsigned symbols, unsigned share_bits)
{
  const unsigned most = (1u << share_bits) + (1u << share_bits >> 9);
  return (most >> (share_bits - tableBits(symbols))) + 1;
}

} // namespace

SymbolModel::SymbolModel(unsigned symbols)
: symbols_(symbols)
, table_shift_(share_bits - tableBits(symbols))
, cycle_(symbols)
, memory_(new std::uint16_t[2 * symbols + 2 + tableSize(symbols, share_bits)])
, begins_(memory_.get())
, counts_(begins_ + symbols + 2)
, table_(counts_ + symbols)
{
  std::fill(counts_, table_, std::uint16_t(1));
  std::fill(table_,
            table_ + tableSize(symbols, share_bits),
            static_cast<std::uint16_t>(symbols - 1));
  begins_[0] = 0;
  begins_[symbols] = begins_[symbols + 1] = 0xffff;
  update();
  cycle_ = until_update_ = (symbols + 6) / 2;
}

void
SymbolModel::update()
{
  constexpr std::uint32_t most = 1u << share_bits;
  total_ += cycle_;
  if (total_ > most) {
    total_ = 0;
    for (unsigned k = 0; k < symbols_; ++k)
      total_ += counts_[k] = static_cast<std::uint16_t>((counts_[k] + 1) / 2);
  }
  const std::uint32_t scale = whole / total_;
  const std::uint32_t last_of_place = (1u << table_shift_) - 1;
  unsigned place = 0;
  for (unsigned k = 0, sum = 0; k + 1 < symbols_; ++k) {
    sum += counts_[k];
    begins_[k + 1] = static_cast<std::uint16_t>(scale * sum >> (31 - share_bits));
    const unsigned end = (begins_[k + 1] + last_of_place) >> table_shift_;
    for (; place < end; ++place)
      table_[place] = static_cast<std::uint16_t>(k);
  }
  std::fill(table_ + place,
            table_ + (1u << (share_bits - table_shift_)),
            static_cast<std::uint16_t>(symbols_ - 1));
  cycle_ = until_update_ = std::min(5 * cycle_ / 4, 8 * (symbols_ + 6));
}

void
BitModel::update()
{
  constexpr std::uint32_t most = 1u << share_bits, longest_cycle = 64;
  total_ += cycle_;
  if (total_ > most) {
    total_ = (total_ + 1) / 2;
    zeros_ = (zeros_ + 1) / 2;
    total_ += zeros_ == total_;
  }
  zero_share_ = zeros_ * (whole / total_) >> (31 - share_bits);
  cycle_ = until_update_ = std::min(5 * cycle_ / 4, longest_cycle);
}

} // namespace pcl::indoor::tool
