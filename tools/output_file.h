/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <functional>
#include <string>

namespace pcl::indoor::tool {

/** \brief Find out, before the long work, that a file cannot be written there.
 * \throws ToolError naming the folder that is missing or not writable
 */
void
requireWritable(const std::string& path);

/** \brief Find out, before the long work, that a folder cannot be used or made for
 * results.
 * \throws ToolError naming it and the reason
 */
void
requireFolder(const std::string& folder);

/** \brief Make a folder, and those above it, unless it is there. */
void
makeFolder(const std::string& folder);

/** \brief Write a text file: first beside its place, then renamed, so none is left
 * half-written.
 * \throws ToolError if it cannot be written
 */
void
saveText(const std::string& path, const std::string& text);

/** \brief The way of both: \a write makes the file of the name it is given, which then
 * takes the place of \a path.
 * \throws ToolError if write returns false or the file cannot be put in place
 */
void
saveAtomically(const std::string& path,
               const std::function<bool(const std::string& temporary)>& write);

} // namespace pcl::indoor::tool
