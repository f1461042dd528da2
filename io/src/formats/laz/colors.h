/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/laz/integer_decoder.h"

#include <array>
#include <cstdint>

namespace pcl::indoor::tool {

using Color = std::array<std::uint16_t, 3>; ///< red, green, blue

/** \brief Decodes colours by their differences to the last ones, byte by byte; green
 * and blue are predicted by what red did. */
class Colors {
public:
  Color
  next(ArithmeticDecoder& decoder, const Color& last);

private:
  SymbolModel used_{128}; ///< bytes that changed, and whether there is more than grey
  SymbolModels bytes_{6, 256};
};

/** \brief The same of version 1: each byte for itself. */
class OldColors {
public:
  Color
  next(ArithmeticDecoder& decoder, const Color& last);

private:
  SymbolModel used_{64};
  IntegerDecoder bytes_{8, 6};
};

/** \brief Decodes one channel by its differences to the last value. */
class InfraredValues {
public:
  std::uint16_t
  next(ArithmeticDecoder& decoder, std::uint16_t last);

private:
  SymbolModel used_{4};
  SymbolModels bytes_{2, 256};
};

} // namespace pcl::indoor::tool
