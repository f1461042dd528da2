/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "formats/laz/integer_decoder.h"

#include <array>
#include <cstdint>

namespace pcl::indoor::tool {

/** \brief Decodes times as bits of doubles: up to four sequences of pulses, each going
 * on by multiples of its last step. */
class GpsTimes {
public:
  /** \param[in] first the time of the first point
   * \param[in] is_layered of formats that are not asked for times that stay the same */
  GpsTimes(std::uint64_t first, bool is_layered);

  std::uint64_t
  next(ArithmeticDecoder& decoder);

private:
  /** Decode a code of what follows.
   * \return whether that was another sequence, in which the time is */
  bool
  readFirstStep(ArithmeticDecoder& decoder);

  bool
  readStep(ArithmeticDecoder& decoder);

  /** A step that is no multiple of the last one, or an extreme one: taken for the
   * sequence's own when four came one after the other. */
  void
  addUnusualStep(std::int32_t step);

  void
  beginSequence(ArithmeticDecoder& decoder);

  void
  add(std::int32_t step)
  {
    times_[now_] += static_cast<std::uint64_t>(static_cast<std::int64_t>(step));
  }

  SymbolModel multiples_, first_steps_;
  IntegerDecoder numbers_;
  bool is_layered_;
  unsigned now_ = 0, newest_ = 0;
  std::array<std::uint64_t, 4> times_{};
  std::array<std::int32_t, 4> steps_{};
  std::array<unsigned, 4> unusual_{};
};

/** \brief The same of version 1: one sequence. */
class OldGpsTimes {
public:
  explicit OldGpsTimes(std::uint64_t first)
  : time_(first)
  {}

  std::uint64_t
  next(ArithmeticDecoder& decoder);

private:
  std::int32_t
  readStep(ArithmeticDecoder& decoder, std::int32_t multiple);

  SymbolModel multiples_{512}, first_steps_{3};
  IntegerDecoder numbers_{32, 6};
  std::uint64_t time_;
  std::int32_t step_ = 0;
  unsigned unusual_ = 0;
};

} // namespace pcl::indoor::tool
