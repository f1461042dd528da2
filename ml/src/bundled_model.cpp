/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/ml/bundled_model.h>

#include <dlfcn.h> // for dladdr
#include <filesystem>
#include <system_error>

namespace pcl::indoor {

namespace {

namespace fs = std::filesystem;

/** \brief The file with this code in it: the shared library, or what a static one was
 * linked into; a program that was found by PATH is known by its name only. */
fs::path
ownFile()
{
  Dl_info info{};
  dladdr(reinterpret_cast<const void*>(&bundledModelFile), &info);
  std::error_code error;
  const auto file =
      fs::canonical(info.dli_fname != nullptr ? info.dli_fname : "", error);
  return error ? fs::canonical("/proc/self/exe", error) : file;
}

/** \brief Beside the library as it is installed, or built. */
std::string
dataFile(const char* name)
{
  std::error_code error;
  const auto folder = ownFile().parent_path();
  const auto installed = folder / PCL_INDOOR_DATA_FROM_LIBRARIES;
  const auto built = folder.parent_path() / "share" / "pcl_indoor";
  return ((fs::exists(installed, error) ? installed : built) / name)
      .lexically_normal()
      .string();
}

} // namespace

std::string
bundledModelFile()
{
  return dataFile("indoor_objects.model");
}

std::string
bundledNetworkFile()
{
  return dataFile("indoor_voxels.network");
}

} // namespace pcl::indoor
