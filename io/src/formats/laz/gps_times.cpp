/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/laz/gps_times.h"

#include "formats/laz/predictions.h"

namespace pcl::indoor::tool {
namespace {

// codes of a step, as the formats that are not layered have them
constexpr std::int32_t most_multiple = 500, least_multiple = -10;
constexpr std::int32_t is_unchanged = most_multiple - least_multiple + 1;
constexpr std::int32_t is_new_sequence = is_unchanged + 1; // behind it: another one
constexpr std::int32_t code_count = is_new_sequence + 4;

constexpr unsigned most_unusual = 3; // then the next one is the usual step

std::uint64_t
readWhole(ArithmeticDecoder& decoder)
{
  const std::uint64_t low = decoder.bits(32);
  return static_cast<std::uint64_t>(decoder.bits(32)) << 32 | low;
}

} // namespace

GpsTimes::GpsTimes(std::uint64_t first, bool is_layered)
: multiples_(code_count - is_layered)
, first_steps_(6u - is_layered)
, numbers_(32, 9)
, is_layered_(is_layered)
, times_{first, 0, 0, 0}
{}

std::uint64_t
GpsTimes::next(ArithmeticDecoder& decoder)
{
  constexpr int most_changes = 4; // of the sequence, of which a writer needs one
  for (int change = 0; change <= most_changes; ++change)
    if (!(steps_[now_] == 0 ? readFirstStep(decoder) : readStep(decoder)))
      return times_[now_];
  throw DamagedChunk("its times go from sequence to sequence");
}

bool
GpsTimes::readFirstStep(ArithmeticDecoder& decoder)
{
  const unsigned code = decoder.symbol(first_steps_) + is_layered_;
  if (code == 1) {
    steps_[now_] = numbers_.next(decoder, 0, 0);
    add(steps_[now_]);
    unusual_[now_] = 0;
  }
  else if (code == 2)
    beginSequence(decoder);
  else if (code > 2) {
    now_ = (now_ + code - 2) % 4;
    return true;
  }
  return false;
}

bool
GpsTimes::readStep(ArithmeticDecoder& decoder)
{
  auto code = static_cast<std::int32_t>(decoder.symbol(multiples_));
  code += is_layered_ && code >= is_unchanged;
  const auto step = steps_[now_];
  const auto read = [&](std::int32_t multiple, unsigned context) {
    return numbers_.next(decoder, wrappedProduct(multiple, step), context);
  };
  if (code == 1) {
    add(read(1, 1));
    unusual_[now_] = 0;
  }
  else if (code == 0)
    addUnusualStep(read(0, 7));
  else if (code < most_multiple)
    add(read(code, code < 10 ? 2 : 3));
  else if (code == most_multiple)
    addUnusualStep(read(code, 4));
  else if (code < most_multiple - least_multiple)
    add(read(most_multiple - code, 5));
  else if (code == most_multiple - least_multiple)
    addUnusualStep(read(least_multiple, 6));
  else if (code == is_new_sequence)
    beginSequence(decoder);
  else if (code > is_new_sequence) {
    now_ = (now_ + static_cast<unsigned>(code - is_new_sequence)) % 4;
    return true;
  }
  return false;
}

void
GpsTimes::addUnusualStep(std::int32_t step)
{
  add(step);
  if (++unusual_[now_] > most_unusual) {
    steps_[now_] = step;
    unusual_[now_] = 0;
  }
}

void
GpsTimes::beginSequence(ArithmeticDecoder& decoder)
{
  const auto high =
      numbers_.next(decoder, static_cast<std::int32_t>(times_[now_] >> 32), 8);
  now_ = newest_ = (newest_ + 1) % 4;
  times_[now_] = static_cast<std::uint64_t>(static_cast<std::uint32_t>(high)) << 32 |
                 decoder.bits(32);
  steps_[now_] = 0;
  unusual_[now_] = 0;
}

std::uint64_t
OldGpsTimes::next(ArithmeticDecoder& decoder)
{
  constexpr std::int32_t whole_time = 510; // behind it: the time is the same
  std::int32_t step = 0;
  if (step_ == 0) {
    const auto code = decoder.symbol(first_steps_);
    if (code == 1)
      step = step_ = numbers_.next(decoder, 0, 0);
    else if (code == 2)
      time_ = readWhole(decoder);
  }
  else {
    const auto multiple = static_cast<std::int32_t>(decoder.symbol(multiples_));
    if (multiple < whole_time)
      step = readStep(decoder, multiple);
    else if (multiple == whole_time)
      time_ = readWhole(decoder);
  }
  return time_ += static_cast<std::uint64_t>(static_cast<std::int64_t>(step));
}

std::int32_t
OldGpsTimes::readStep(ArithmeticDecoder& decoder, std::int32_t multiple)
{
  constexpr std::int32_t greatest = 509;
  if (multiple == 1) {
    unusual_ = 0;
    return step_ = numbers_.next(decoder, step_, 1);
  }
  const auto predicted = multiple == 0 ? step_ / 4 : wrappedProduct(multiple, step_);
  const unsigned context = multiple == 0   ? 2
                           : multiple < 10 ? 3
                           : multiple < 50 ? 4
                                           : 5;
  const auto step = numbers_.next(decoder, predicted, context);
  if ((multiple == 0 || multiple == greatest) && ++unusual_ > most_unusual) {
    step_ = step;
    unusual_ = 0;
  }
  return step;
}

} // namespace pcl::indoor::tool
