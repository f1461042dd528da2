/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

/** \brief Whether functions can be compiled for instructions that not every processor
 * has. */
#if defined(__GNUC__) && defined(__x86_64__)
#define PCL_INDOOR_HAS_TARGETS 1
/** \brief Compiles a function for a processor with a feature, such as "avx2". */
#define PCL_INDOOR_TARGET(feature) __attribute__((target(feature)))
/** \brief Whether the processor has it; may be asked before main() begins. */
#define PCL_INDOOR_CPU_HAS(feature)                                                    \
  (__builtin_cpu_init(), __builtin_cpu_supports(feature) != 0)
#else
#define PCL_INDOOR_HAS_TARGETS 0
#define PCL_INDOOR_TARGET(feature)
#define PCL_INDOOR_CPU_HAS(feature) false
#endif
