/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <string>

namespace pcl::indoor::tool {

/** \brief Ask for memory in pages of 2 MiB in place of 4 KiB: a program that works on
 * millions of points takes a quarter less time then.
 *
 * Only the C library's setting glibc.malloc.hugetlb does so for all allocations, and it
 * is read when a program starts: so the program is started again, with that setting in
 * the environment. Nothing is done if no argument names a file of 8 MB or a folder with
 * as much, if GLIBC_TUNABLES is set, or if the system gives such pages to all or none.
 * To be called first in main(), with its parameters.
 */
void
useHugePages(int argc, char** argv);

/** \brief Whether the system gives huge pages to those who ask, and to no others.
 * \param[in] choice the content of /sys/kernel/mm/transparent_hugepage/enabled
 */
bool
areHugePagesOnRequest(const std::string& choice);

/** \brief The size of a file, or of the files in a folder, bytes; 0 if it is neither.
 */
double
sizeOfInput(const std::string& path);

} // namespace pcl::indoor::tool
