/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <string>

namespace pcl::indoor::tool {

/** \brief From now on, the signals INT, TERM and HUP remove the files of the list
 * before they end the program, unless the program treats them otherwise; writing to a
 * closed pipe or beyond the largest file size fails and no longer ends the program. */
void
prepareForWriting();

/** \brief Put a file on the list.
 * \return false if it is there already
 */
bool
addUnfinished(const std::string& path);

/** \brief Take a file out of the list. */
void
removeUnfinished(const std::string& path);

/** \brief While it lives, the signals INT, TERM and HUP wait. */
class SignalPause {
public:
  SignalPause();
  ~SignalPause();
  SignalPause(const SignalPause&) = delete;
  SignalPause&
  operator=(const SignalPause&) = delete;
};

} // namespace pcl::indoor::tool
