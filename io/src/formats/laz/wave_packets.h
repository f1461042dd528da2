/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/laz/integer_decoder.h"

#include <cstdint>

namespace pcl::indoor::tool {

constexpr std::size_t wave_packet_size = 29; ///< bytes in a point

/** \brief Decodes where the waveforms of points are. */
class WavePackets {
public:
  /** \param[in,out] packet the last one, then the next one, wave_packet_size bytes */
  void
  next(ArithmeticDecoder& decoder, char* packet);

private:
  SymbolModel descriptors_{256};
  SymbolModels offset_codes_{4, 4};
  IntegerDecoder offsets_{32, 1}, sizes_{32, 1}, places_{32, 1}, directions_{32, 3};
  std::int32_t last_step_ = 0;
  unsigned last_code_ = 0;
};

} // namespace pcl::indoor::tool
