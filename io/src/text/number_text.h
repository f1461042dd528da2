/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <charconv>
#include <cmath>
#include <string>
#include <type_traits>

namespace pcl::indoor::tool {

/** \brief The shortest text that gives the number back, without an exponent but for
 * those that are very small or large. */
template <typename T>
std::string
numberText(T value)
{
  if constexpr (std::is_integral_v<T>) {
    return std::to_string(value);
  }
  else {
    const T size = std::abs(value);
    const bool is_plain = size == T(0) || (size >= T(1e-4) && size < T(1e15));
    char buffer[64];
    const auto end = std::to_chars(buffer,
                                   buffer + sizeof(buffer),
                                   value,
                                   is_plain ? std::chars_format::fixed
                                            : std::chars_format::scientific);
    return {buffer, end.ptr};
  }
}

} // namespace pcl::indoor::tool
