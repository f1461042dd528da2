/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "thesis/objects/shape_supervoxels.h"

#include "objects/graph/average_columns.h"
#include "objects/structure/scene_making.h" // for gridPoints
#include "thesis/objects/edge_partition.h"

#include <pcl/features/fpfh.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cmath>

namespace {

using namespace pcl::indoor;

constexpr double shape_radius = 2;   // of FPFH, voxels
constexpr float histogram_sum = 300; // PCL's FPFH: three histograms in per cent
constexpr Eigen::Index shape_size = 33;

/** The FPFH of each voxel's centroid among all points. */
Eigen::MatrixXf
shapesOf(const SurfaceVoxels& voxels,
         const std::vector<Eigen::Vector3f>& points,
         const std::vector<Eigen::Vector3f>& normals,
         double voxel_size)
{
  using Cloud = pcl::PointCloud<pcl::PointXYZ>;
  const auto cloudOf = [](const std::vector<Eigen::Vector3f>& places) {
    const auto cloud = pcl::make_shared<Cloud>();
    for (const auto& place : places)
      cloud->push_back({place.x(), place.y(), place.z()});
    return cloud;
  };
  const auto normal_cloud = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  for (const auto& normal : normals)
    normal_cloud->push_back({normal.x(), normal.y(), normal.z()});
  pcl::FPFHEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(cloudOf(voxels.centroids));
  estimation.setSearchSurface(cloudOf(points));
  estimation.setInputNormals(normal_cloud);
  estimation.setRadiusSearch(shape_radius * voxel_size);
  pcl::PointCloud<pcl::FPFHSignature33> output;
  estimation.compute(output);
  Eigen::MatrixXf shapes(shape_size, static_cast<Eigen::Index>(output.size()));
  for (std::size_t v = 0; v < output.size(); ++v)
    shapes.col(static_cast<Eigen::Index>(v)) =
        Eigen::Map<const Eigen::VectorXf>(output[v].histogram, shape_size) /
        histogram_sum;
  return shapes.unaryExpr([](float x) { return std::isfinite(x) ? x : 0.0f; });
}

/** The mean colour of the points of each voxel. */
Eigen::Matrix3Xf
meanColors(const SurfaceVoxels& voxels,
           const Eigen::Matrix3Xf& colors,
           const std::vector<std::size_t>& point_of_kept)
{
  Eigen::Matrix3Xf kept(3, static_cast<Eigen::Index>(point_of_kept.size()));
  for (std::size_t k = 0; k < point_of_kept.size(); ++k)
    kept.col(static_cast<Eigen::Index>(k)) =
        colors.col(static_cast<Eigen::Index>(point_of_kept[k]));
  return averageColumns(kept, voxels.cells.cell_of_point, voxels.size());
}

} // namespace

namespace pcl::indoor {

PointPartition
partitionByShapes(const SurfaceVoxels& surface,
                  const std::vector<std::uint8_t>& left_out,
                  const std::optional<Eigen::Vector3f>& camera,
                  const thesis::ObjectOptions& options)
{
  const auto& shared = options.shared;
  PointPartition result;
  auto& supervoxels = result.supervoxels;
  ObjectSegmentationInput kept;
  if (camera) {
    kept.capture = Capture::TableView;
    kept.viewpoint.push_back(*camera);
  }
  std::vector<std::size_t> point_of_kept;
  for (std::size_t i = 0; i < surface.size(); ++i)
    if (!left_out[i]) {
      point_of_kept.push_back(i);
      kept.points.push_back(surface.centroids[i]);
      kept.normals.push_back(surface.normals[i]);
    }
  std::vector<std::uint32_t> label_of_point(surface.size(), Supervoxels::none);
  if (!kept.points.empty()) {
    auto voxels = surfaceVoxels(kept.points, gridPoints(kept), shared.voxel_size);
    averageNormals(kept.normals, voxels);
    voxels.appearance.shapes =
        shapesOf(voxels, kept.points, kept.normals, shared.voxel_size);
    if (surface.appearance.colors.cols() > 0)
      voxels.appearance.colors =
          meanColors(voxels, surface.appearance.colors, point_of_kept);
    supervoxels = growSupervoxels(voxels,
                                  std::vector<std::uint8_t>(voxels.size(), 0),
                                  shared.seed_size / shared.voxel_size,
                                  distanceOf(options),
                                  shared.threads);
    result.edges = surfaceEdges(voxels, supervoxels);
    result.segment_of_supervoxel = joinOverEdges(supervoxels, result.edges, options);
    for (std::size_t k = 0; k < point_of_kept.size(); ++k)
      label_of_point[point_of_kept[k]] =
          supervoxels.label_of_voxel[voxels.cells.cell_of_point[k]];
  }
  supervoxels.label_of_voxel = std::move(label_of_point);
  return result;
}

} // namespace pcl::indoor
