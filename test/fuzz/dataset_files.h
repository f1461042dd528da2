/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Files of data sets: images, and the files that are read with others of their folder,
// which are whole.
#pragma once

#include "datasets/depth_image.h"
#include "datasets/png_file.h"
#include "datasets/scannet.h"
#include "support/folder_test.h" // for bytesOf
#include "support/png_bytes.h"

#include <boost/crc.hpp>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace pcl::indoor::fuzz {

constexpr const char* scan_points =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float "
    "y\nproperty float z\nend_header\n0 0 0\n1 0 0\n0 1 0\n";
constexpr const char* scan_segments = R"({"sceneId":"s","segIndices":[3,7,3]})";
constexpr const char* scan_groups =
    R"({"segGroups":[{"id":0,"label":"chair","segments":[3]},{"id":1,"label":"wall","segments":[7]}]})";
constexpr const char* camera_matrix = "500 0 1.5\n0 500 1\n0 0 1\n";

/** \brief Of 8 and of 16 bits, with a palette, coloured. */
inline std::vector<std::string>
wholePngs()
{
  const std::vector<std::uint16_t> values = {0, 1, 2, 3, 2, 1};
  return {test::pngBytes(3, 2, 8, values),
          test::pngBytes(3, 2, 16, values),
          test::pngBytes(3, 2, test::palette_bits, values),
          test::pngBytes(2, 1, 24, values)};
}

/** \brief Checksums that fit: after 8 bytes follow parts of a length, a kind, the
 * content and its checksum. */
inline void
repairPng(std::string& file)
{
  const auto number = [&file](std::size_t at) {
    std::size_t value = 0;
    for (std::size_t k = 0; k < 4; ++k)
      value = value << 8 | static_cast<unsigned char>(file[at + k]);
    return value;
  };
  for (std::size_t at = 8; at + 12 <= file.size();) {
    const auto length = number(at);
    if (length > file.size() - at - 12)
      return;
    boost::crc_32_type crc;
    crc.process_bytes(&file[at + 4], length + 4);
    for (std::size_t k = 0; k < 4; ++k)
      file[at + 8 + length + k] = static_cast<char>(crc.checksum() >> (24 - 8 * k));
    at += length + 12;
  }
}

/** \brief A scene of ScanNet with these segments and groups. */
inline void
readScene(const std::string& segments, const std::string& groups)
{
  const std::string scene = "fuzz_scene/s";
  std::filesystem::create_directory("fuzz_scene");
  std::ofstream(scene + "_vh_clean_2.ply") << scan_points;
  std::ofstream(scene + "_vh_clean_2.0.010000.segs.json") << segments;
  std::ofstream(scene + ".aggregation.json") << groups;
  static_cast<void>(tool::readScanNet("fuzz_scene"));
}

inline void
readSegments(const std::string& path)
{
  readScene(test::bytesOf(path), scan_groups);
}

inline void
readGroups(const std::string& path)
{
  readScene(scan_segments, test::bytesOf(path));
}

/** \brief A folder of SUN RGB-D with this depth image; colours, labels and their names
 * are whole. */
inline void
readDepths(const std::string& path)
{
  std::filesystem::create_directories("fuzz_sun/depth");
  std::ofstream("fuzz_sun/depth/d.png", std::ios::binary) << test::bytesOf(path);
  std::ofstream("fuzz_sun/intrinsics.txt") << camera_matrix;
  std::ofstream("fuzz_labels.png", std::ios::binary) << wholePngs()[0];
  std::ofstream("fuzz_color.png", std::ios::binary)
      << test::pngBytes(3, 2, 24, std::vector<std::uint16_t>(18, 7));
  std::ofstream("fuzz_names.txt") << "wall\r\nfloor\nchair\n";
  tool::DepthImageFiles files;
  if (!tool::isSunRgbd("fuzz_sun"))
    return;
  tool::findSunRgbd("fuzz_sun", files);
  files.labels = files.instances = "fuzz_labels.png";
  files.color = "fuzz_color.png";
  files.label_names = "fuzz_names.txt";
  static_cast<void>(tool::readDepthImage(files));
}

/** \brief A depth image with this camera. */
inline void
readCamera(const std::string& path)
{
  std::ofstream("fuzz_depth.png", std::ios::binary) << wholePngs()[1];
  tool::DepthImageFiles files;
  files.depth = files.labels = "fuzz_depth.png";
  files.intrinsics = path;
  static_cast<void>(tool::readDepthImage(files));
}

} // namespace pcl::indoor::fuzz
