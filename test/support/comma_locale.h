/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <clocale>
#include <string>

namespace pcl::indoor::test {

/** While it lives, printf() writes numbers with a comma, if such a locale is installed.
 */
class CommaLocale {
public:
  CommaLocale()
  {
    for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "it_IT.UTF-8", "de_DE"})
      if (setlocale(LC_NUMERIC, name) != nullptr && hasComma())
        return;
    setlocale(LC_NUMERIC, before_.c_str());
  }

  CommaLocale(const CommaLocale&) = delete;
  CommaLocale&
  operator=(const CommaLocale&) = delete;

  ~CommaLocale() { setlocale(LC_NUMERIC, before_.c_str()); }

  static bool
  hasComma()
  {
    return std::string(localeconv()->decimal_point) == ",";
  }

private:
  std::string before_ = setlocale(LC_NUMERIC, nullptr);
};

} // namespace pcl::indoor::test
