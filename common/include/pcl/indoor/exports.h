/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

/** \brief Marks what a shared library shows to programs and to other libraries.
 *
 * The libraries are compiled with hidden symbols, so what is defined in a source file
 * and not marked can be used within its library only. Static libraries, with
 * PCL_INDOOR_STATIC, show nothing of themselves: what they are linked into decides.
 */
#if defined(PCL_INDOOR_STATIC) || !defined(__GNUC__)
#define PCL_INDOOR_EXPORTS
#else
#define PCL_INDOOR_EXPORTS __attribute__((visibility("default")))
#endif
