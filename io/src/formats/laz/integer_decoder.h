/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/laz/arithmetic_decoder.h"

#include <cstdint>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Models of the same number of symbols, each made when it is first needed. */
class SymbolModels {
public:
  SymbolModels(std::size_t count, unsigned symbols)
  : models_(count)
  , symbols_(symbols)
  {}

  SymbolModel&
  operator[](std::size_t index)
  {
    if (models_[index].isEmpty())
      models_[index] = SymbolModel(symbols_);
    return models_[index];
  }

private:
  std::vector<SymbolModel> models_;
  unsigned symbols_;
};

/** \brief Decodes numbers by how far they are from predicted ones: first in how many
 * bits the difference fits, then these, of which the upper 8 are modelled. */
class IntegerDecoder {
public:
  /** \param[in] bits of the numbers: 8, 16 or 32; those of less than 32 have no sign
   * \param[in] contexts in which numbers of bits are counted apart */
  IntegerDecoder(unsigned bits, unsigned contexts)
  : bits_(bits)
  , lengths_(contexts, bits + 1)
  , correctors_(bits + 1)
  {}

  std::int32_t
  next(ArithmeticDecoder& decoder, std::int32_t predicted, unsigned context = 0)
  {
    const auto number = static_cast<std::uint32_t>(predicted) +
                        static_cast<std::uint32_t>(difference(decoder, context));
    return static_cast<std::int32_t>(bits_ < 32 ? number & ((1u << bits_) - 1)
                                                : number);
  }

  /** \brief In how many bits the last difference fitted. */
  unsigned
  length() const
  {
    return length_;
  }

private:
  std::int32_t
  difference(ArithmeticDecoder& decoder, unsigned context)
  {
    length_ = decoder.symbol(lengths_[context]);
    if (length_ == 0)
      return static_cast<std::int32_t>(decoder.bit(bit_));
    if (length_ == 32)
      return INT32_MIN;
    constexpr unsigned modelled = 8;
    auto& model = correctors_[length_];
    if (model.isEmpty())
      model = SymbolModel(1u << std::min(length_, modelled));
    std::uint32_t number = decoder.symbol(model);
    if (length_ > modelled)
      number = number << (length_ - modelled) | decoder.bits(length_ - modelled);
    // the lower half are negative numbers, and 0 and 1 are told by no bits at all
    const std::uint32_t half = 1u << (length_ - 1);
    return static_cast<std::int32_t>(number >= half ? number + 1
                                                    : number + 1 - 2 * half);
  }

  unsigned bits_, length_ = 0;
  SymbolModels lengths_;
  BitModel bit_;
  std::vector<SymbolModel> correctors_;
};

} // namespace pcl::indoor::tool
