/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "text/formatted.h"

#include <cstdarg>
#include <cstdio>
#include <locale.h> // for locale_t

namespace pcl::indoor::tool {
namespace {

/** While it lives, numbers of this thread have a point, whatever the locale. */
class NumbersWithPoint {
public:
  NumbersWithPoint()
  {
    static const auto classic = newlocale(LC_ALL_MASK, "C", nullptr);
    before_ = uselocale(classic);
  }

  ~NumbersWithPoint() { uselocale(before_); }

  NumbersWithPoint(const NumbersWithPoint&) = delete;
  NumbersWithPoint&
  operator=(const NumbersWithPoint&) = delete;

private:
  locale_t before_;
};

} // namespace

std::string
formatted(const char* format, ...)
{
  const NumbersWithPoint numbers;
  char text[500];
  std::va_list values;
  va_start(values, format);
  std::vsnprintf(text, sizeof(text), format, values);
  va_end(values);
  return text;
}

} // namespace pcl::indoor::tool
