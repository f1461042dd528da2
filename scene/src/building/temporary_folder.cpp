/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "building/temporary_folder.h"

#include "files/tool_error.h"

#include <cerrno>
#include <cstdlib> // for mkdtemp
#include <cstring>
#include <filesystem>
#include <system_error>

namespace pcl::indoor::tool {

TemporaryFolder::TemporaryFolder(const std::string& parent)
{
  namespace fs = std::filesystem;
  const fs::path folder = parent.empty() ? fs::temp_directory_path() : fs::path(parent);
  path_ = (folder / "pcl_indoor_XXXXXX").string();
  if (mkdtemp(path_.data()) == nullptr)
    throw ToolError(folder.string() + ": no folder can be made there, " +
                    std::strerror(errno));
  folder_.emplace(path_, 0);
}

TemporaryFolder::~TemporaryFolder()
{
  folder_.reset();
  std::error_code error;
  std::filesystem::remove_all(path_, error);
}

} // namespace pcl::indoor::tool
