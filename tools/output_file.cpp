/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "output_file.h"

#include "options.h" // for ToolError

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <unistd.h> // for access, getpid

namespace pcl::indoor::tool {
namespace {

std::string
folderOf(const std::string& path)
{
  const auto folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

} // namespace

void
requireWritable(const std::string& path)
{
  std::error_code error;
  const auto folder = folderOf(path);
  if (!std::filesystem::is_directory(folder, error))
    throw ToolError(path + ": cannot be written, there is no folder " + folder);
  if (std::filesystem::is_directory(path, error))
    throw ToolError(path + ": cannot be written, it is a folder");
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    throw ToolError(path + ": cannot be written, " + std::strerror(errno));
}

void
requireFolder(const std::string& folder)
{
  std::error_code error;
  auto nearest = std::filesystem::absolute(folder, error);
  while (!std::filesystem::exists(nearest, error) && nearest.has_relative_path())
    nearest = nearest.parent_path();
  if (!std::filesystem::is_directory(nearest, error))
    throw ToolError(folder + ": cannot be used as a folder, " + nearest.string() +
                    " is none");
  if (access(nearest.c_str(), W_OK | X_OK) != 0)
    throw ToolError(folder + ": cannot be written, " + std::strerror(errno));
}

void
makeFolder(const std::string& folder)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw ToolError(folder + ": cannot be made, " + error.message());
}

void
saveAtomically(const std::string& path,
               const std::function<bool(const std::string& temporary)>& write)
{
  requireWritable(path);
  const auto temporary = path + ".part" + std::to_string(getpid());
  std::error_code error;
  bool good = false;
  try {
    good = write(temporary);
  } catch (...) {
    std::filesystem::remove(temporary, error);
    throw;
  }
  if (good)
    std::filesystem::rename(temporary, path, error);
  if (!good || error) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw ToolError(path + ": cannot be written" +
                    (error ? ", " + error.message() : std::string()));
  }
}

void
saveText(const std::string& path, const std::string& text)
{
  saveAtomically(path, [&text](const std::string& temporary) {
    std::ofstream stream(temporary, std::ios::binary);
    stream << text;
    stream.close();
    return stream.good();
  });
}

} // namespace pcl::indoor::tool
