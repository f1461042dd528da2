/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/exceptions.h>

namespace pcl::indoor {

/** Throw a BadArgumentException that names an option of a sensor, unless it is legal.
 * \param[in] range what it must be */
inline void
requireOption(bool legal, const char* name, double value, const char* range)
{
  if (!legal)
    PCL_THROW_EXCEPTION(BadArgumentException,
                        name << " must be " << range << ", not " << value);
}

} // namespace pcl::indoor
