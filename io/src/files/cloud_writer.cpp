/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/cloud_writer.h"

#include "files/tool_error.h"
#include "formats/file_ending.h"
#include "formats/pcd/pcd_writer.h"
#include "formats/ply/ply_writer.h"

#include <filesystem>

namespace pcl::indoor::tool {

void
requireWritableCloud(const std::string& path, bool pcd_only)
{
  requireWritable(path);
  const auto extension = fileEnding(path);
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
  if (fileEnding(path) == ".ply")
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
