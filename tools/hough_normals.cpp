/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "command_line/options.h"
#include "files/cloud_file.h"
#include "normals/normal_settings.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace pcl::indoor::tool;

namespace {

void
appendNormals(const pcl::PointCloud<pcl::Normal>& normals, pcl::PCLPointCloud2& cloud)
{
  const auto append = [&](const std::string& name, const auto& value) {
    std::vector<float> values;
    for (const auto& normal : normals)
      values.push_back(value(normal));
    appendRealField(cloud, name, values);
  };
  append("normal_x", [](const auto& normal) { return normal.normal_x; });
  append("normal_y", [](const auto& normal) { return normal.normal_y; });
  append("normal_z", [](const auto& normal) { return normal.normal_z; });
  append("curvature", [](const auto& normal) { return normal.curvature; });
}

} // namespace

int
main(int argc, char** argv)
{
  NormalSettings settings;
  auto parser = normalParser(settings);
  return parser.run(argc, argv, [&](Progress& progress) {
    requireFitting(settings);
    requireWritableCloud(settings.output);
    progress.start("Loading " + settings.input);
    CloudFile file = loadCloud(settings.input, settings.columns);
    choose(settings.stations, file);
    printNotes(file);
    progress.done(std::to_string(file.points->size()) + " points");

    progress.start("Estimating normals");
    const auto normals = estimatedNormals(settings, file);
    const auto found =
        std::count_if(normals.begin(), normals.end(), [](const auto& normal) {
          return std::isfinite(normal.normal_x);
        });
    progress.done(std::to_string(found) + " normals");

    appendNormals(normals, file.cloud);
    settings.coordinates.apply(file, settings.output);
    progress.start("Saving " + settings.output);
    saveCloud(settings.output, file.cloud, file.pose);
    Progress::conclude([&] {
      progress.done();
      progress.summary(settings.output + ": " + std::to_string(found) + " normals");
    });
  });
}
