/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cloud_writer.h"

#include "files/tool_error.h"
#include "formats/pcd/pcd_writer.h"
#include "formats/ply/ply_writer.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace pcl::indoor::tool {
namespace {

/** In small letters, with its dot. */
std::string
extensionOf(const std::string& path)
{
  auto extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  return extension;
}

} // namespace

void
requireWritableCloud(const std::string& path, bool pcd_only)
{
  requireWritable(path);
  const auto extension = extensionOf(path);
  if (extension.empty() || extension == ".pcd" || (extension == ".ply" && !pcd_only))
    return;
  throw ToolError(path + ": cannot be written, " +
                  std::filesystem::path(path).extension().string() +
                  (pcd_only ? " is not .pcd" : " is neither .pcd nor .ply"));
}

OutputFile
cloudBeside(const std::string& path,
            const PCLPointCloud2& cloud,
            const CloudPose& pose,
            int threads)
{
  OutputFile file(path);
  if (extensionOf(path) == ".ply")
    writePly(file, path, cloud, pose);
  else
    writePcd(file, cloud, pose, threads);
  file.close();
  return file;
}

void
saveCloud(const std::string& path, const PCLPointCloud2& cloud, const CloudPose& pose)
{
  cloudBeside(path, cloud, pose).commit();
}

} // namespace pcl::indoor::tool
