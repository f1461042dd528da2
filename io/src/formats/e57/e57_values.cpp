/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Facts of the format: ASTM E2807-11, section 9.
#include "formats/e57/e57_values.h"

#include <cstring>

namespace pcl::indoor::tool {
namespace {

template <typename Real>
void
copyReals(const char* bytes, std::size_t count, double* values)
{
  for (std::size_t i = 0; i < count; ++i) {
    Real value;
    std::memcpy(&value, bytes + i * sizeof(Real), sizeof(Real));
    values[i] = static_cast<double>(value);
  }
}

std::uint64_t
eightBytes(const char* bytes)
{
  std::uint64_t value;
  std::memcpy(&value, bytes, sizeof(value));
  return value;
}

} // namespace

void
unpackE57Values(const E57Field& field,
                const char* bytes,
                std::size_t first_bit,
                std::size_t count,
                double* values)
{
  bytes += first_bit / 8;
  if (field.kind == E57Field::Kind::Single)
    return copyReals<float>(bytes, count, values);
  if (field.kind == E57Field::Kind::Double)
    return copyReals<double>(bytes, count, values);
  const unsigned bits = field.bits;
  const std::uint64_t mask = bits == 0 ? 0 : ~std::uint64_t{0} >> (64 - bits);
  const auto minimum = static_cast<std::uint64_t>(field.minimum);
  std::size_t bit = first_bit % 8;
  for (std::size_t i = 0; i < count; ++i, bit += bits) {
    const auto shift = bit % 8;
    auto stored = eightBytes(bytes + bit / 8) >> shift;
    if (shift + bits > 64) // it reaches into the ninth byte
      stored |=
          static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[bit / 8 + 8]))
          << (64 - shift);
    const auto whole = static_cast<std::int64_t>(minimum + (stored & mask));
    values[i] = static_cast<double>(whole) * field.scale + field.offset;
  }
}

} // namespace pcl::indoor::tool
