/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "datasets/depth_image.h"

#include "datasets/png_file.h"
#include "formats/table/table_words.h" // for readNumber

#include <pcl/common/io.h>          // for copyPointCloud
#include <pcl/common/point_tests.h> // for isFinite
#include <pcl/conversions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>

namespace pcl::indoor::tool {
namespace {

namespace fs = std::filesystem;

struct Camera {
  double fx = 0, fy = 0, cx = 0, cy = 0; ///< pixels
};

Camera
readIntrinsics(const std::string& path)
{
  std::ifstream stream(path);
  if (!stream)
    throw ToolError(path + ": cannot be opened");
  std::vector<double> k;
  for (std::string word; stream >> word;) {
    double value = 0;
    if (!readNumber(word, value) || !std::isfinite(value))
      throw ToolError(path + ": '" + word + "' is not a number");
    k.push_back(value);
  }
  if (k.size() != 9)
    throw ToolError(path + ": " + std::to_string(k.size()) +
                    " numbers, a camera matrix has 9");
  const bool is_matrix = k[0] > 0 && k[4] > 0 && k[1] == 0 && k[3] == 0 && k[6] == 0 &&
                         k[7] == 0 && k[8] == 1;
  if (!is_matrix)
    throw ToolError(path + ": not a camera matrix, fx 0 cx 0 fy cy 0 0 1");
  return {k[0], k[4], k[2], k[5]};
}

/** \throws ToolError if an image is not as large as another one */
void
requireSize(const PngImage& image,
            const std::string& path,
            std::uint32_t width,
            std::uint32_t height,
            const std::string& other)
{
  const auto text = [](std::uint32_t w, std::uint32_t h) {
    return std::to_string(w) + " x " + std::to_string(h);
  };
  if (image.width != width || image.height != height)
    throw ToolError(path + ": " + text(image.width, image.height) + " pixels, " +
                    other + " has " + text(width, height));
}

/** The numbers of an image as large as the depth image. */
std::vector<std::uint16_t>
numbersLike(const PngImage& depth,
            const std::string& path,
            const DepthImageFiles& files)
{
  auto image = readNumberPng(path);
  requireSize(image, path, depth.width, depth.height, files.depth);
  return std::move(image.values);
}

PngImage
readDepths(const DepthImageFiles& files)
{
  auto depth = readNumberPng(files.depth);
  if (depth.bits != 16)
    throw ToolError(files.depth + ": " + std::to_string(depth.bits) +
                    " bits per pixel, a depth image has 16");
  if (files.is_rotated)
    for (auto& value : depth.values)
      value = static_cast<std::uint16_t>(value >> 3 | value << 13);
  if (std::all_of(depth.values.begin(), depth.values.end(), [](auto value) {
        return value == 0;
      }))
    throw ToolError(files.depth + ": no pixel has a depth");
  return depth;
}

PointCloud<PointXYZ>
pointsOf(const PngImage& depth, const Camera& camera, double unit)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  PointCloud<PointXYZ> points(depth.width, depth.height, PointXYZ(nan, nan, nan));
  points.is_dense = false;
  for (std::uint32_t v = 0; v < depth.height; ++v)
    for (std::uint32_t u = 0; u < depth.width; ++u) {
      const double z = unit * depth.values[std::size_t{v} * depth.width + u];
      if (z > 0)
        points(u, v).getVector3fMap() = Eigen::Vector3d((u - camera.cx) * z / camera.fx,
                                                        (v - camera.cy) * z / camera.fy,
                                                        z)
                                            .cast<float>();
    }
  return points;
}

PCLPointCloud2
cloudOf(const PointCloud<PointXYZ>& points, const PngImage* color)
{
  PCLPointCloud2 cloud;
  if (color) {
    PointCloud<PointXYZRGB> colored;
    copyPointCloud(points, colored);
    const auto* value = color->values.data();
    for (auto& point : colored) {
      point.r = static_cast<std::uint8_t>(*value++);
      point.g = static_cast<std::uint8_t>(*value++);
      point.b = static_cast<std::uint8_t>(*value++);
    }
    toPCLPointCloud2(colored, cloud);
  }
  else
    toPCLPointCloud2(points, cloud);
  return cloud;
}

/** The names of the labels; numbers where there is no file. */
std::vector<std::string>
labelNames(const DepthImageFiles& files, std::uint16_t highest)
{
  std::vector<std::string> names = {"none"};
  if (files.label_names.empty()) {
    for (std::uint32_t label = 1; label <= highest; ++label)
      names.push_back(std::to_string(label));
    return names;
  }
  std::ifstream stream(files.label_names);
  if (!stream)
    throw ToolError(files.label_names + ": cannot be opened");
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty() && line.back() == '\r')
      line.pop_back();
    names.push_back(line);
  }
  if (highest >= names.size())
    throw ToolError(files.labels + ": the label " + std::to_string(highest) +
                    " has no name, " + files.label_names + " has " +
                    std::to_string(names.size() - 1));
  return names;
}

/** Objects numbered in the order of their labels, then of their instances. */
std::vector<std::uint32_t>
objectsOf(const std::vector<std::uint16_t>& labels,
          const std::vector<std::uint16_t>& instances)
{
  const auto keyOf = [&](std::size_t i) {
    return std::make_pair(labels[i], instances.empty() ? 0 : instances[i]);
  };
  std::map<std::pair<int, int>, std::uint32_t> number_of;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] != 0)
      number_of[keyOf(i)];
  std::uint32_t count = 0;
  for (auto& [key, number] : number_of)
    number = ++count;
  std::vector<std::uint32_t> objects(labels.size(), 0);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] != 0)
      objects[i] = number_of.at(keyOf(i));
  return objects;
}

} // namespace

bool
isSunRgbd(const std::string& folder)
{
  std::error_code error;
  return fs::is_directory(fs::path(folder) / "depth", error) &&
         fs::exists(fs::path(folder) / "intrinsics.txt", error);
}

void
findSunRgbd(const std::string& folder, DepthImageFiles& files)
{
  const auto images = fs::path(folder) / "depth";
  std::vector<std::string> found;
  std::error_code error;
  for (fs::directory_iterator entry(images, error), end; entry != end;
       entry.increment(error))
    if (entry->path().extension() == ".png")
      found.push_back(entry->path().string());
  if (found.size() != 1)
    throw ToolError(images.string() + ": " + std::to_string(found.size()) +
                    " PNG files, one is needed");
  files.depth = found[0];
  files.is_rotated = true;
  if (files.intrinsics.empty())
    files.intrinsics = (fs::path(folder) / "intrinsics.txt").string();
}

LabelledScan
readDepthImage(const DepthImageFiles& files)
{
  const auto camera = readIntrinsics(files.intrinsics);
  const auto depth = readDepths(files);
  auto labels = numbersLike(depth, files.labels, files);
  std::vector<std::uint16_t> instances;
  if (!files.instances.empty())
    instances = numbersLike(depth, files.instances, files);
  PngImage color;
  if (!files.color.empty()) {
    color = readColorPng(files.color);
    requireSize(color, files.color, depth.width, depth.height, files.depth);
  }
  LabelledScan scan;
  scan.category_names =
      labelNames(files, *std::max_element(labels.begin(), labels.end()));
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (depth.values[i] == 0)
      labels[i] = 0;
  scan.objects = objectsOf(labels, instances);
  scan.categories.assign(labels.begin(), labels.end());
  scan.file.cloud = cloudOf(pointsOf(depth, camera, files.depth_unit),
                            files.color.empty() ? nullptr : &color);
  return scan;
}

LabelledScan
readLabelledCloud(const std::string& cloud, const std::string& labels)
{
  auto file = loadCloud(cloud);
  LabelledScan scan;
  if (labels.empty())
    scan.objects = readLabels(file, "label");
  else {
    const auto image = readNumberPng(labels);
    requireSize(image, labels, file.points->width, file.points->height, cloud);
    scan.objects.assign(image.values.begin(), image.values.end());
  }
  for (std::size_t i = 0; i < scan.objects.size(); ++i)
    if (!isFinite((*file.points)[i]))
      scan.objects[i] = 0;
  scan.file = std::move(file);
  return scan;
}

} // namespace pcl::indoor::tool
