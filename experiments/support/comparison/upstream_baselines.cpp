/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "comparison/upstream_baselines.h"

#include "thesis/objects/graph_segmentation.h"

#include <pcl/indoor/point_cells.h>
#include <pcl/indoor/usable_point.h>

#include <pcl/common/common.h>
#include <pcl/features/fpfh_omp.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/conditional_euclidean_clustering.h>
#include <pcl/segmentation/extract_clusters.h>
#include <pcl/segmentation/impl/conditional_euclidean_clustering.hpp>
#include <pcl/segmentation/region_growing.h>

#include <algorithm>
#include <cmath>

namespace {

using pcl::indoor::Adjacency;
using pcl::indoor::PointCells;
using pcl::indoor::tool::Baseline;
using pcl::indoor::tool::BaselineOptions;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;
using Labels = std::vector<std::uint32_t>;

constexpr int normal_neighbors = 30; // of RegionGrowing's example
constexpr int smallest_region = 10;  // voxels
constexpr float smoothness = 3.0f / 180 * static_cast<float>(M_PI); // the same example
constexpr float fpfh_reach = 5;                                     // radius in voxels
constexpr float like = 60;                // of 600: L1 distance of two FPFH
constexpr float graph_scale = 0.01f;      // kThresh of ScanNet's segmentator
constexpr std::uint32_t graph_least = 20; // its segMinVerts

Normals::Ptr
normalsOf(const Cloud::Ptr& places, const BaselineOptions& options)
{
  pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> estimation(options.threads);
  estimation.setInputCloud(places);
  estimation.setKSearch(normal_neighbors);
  if (!options.single_camera) {
    pcl::PointXYZ lower, upper;
    pcl::getMinMax3D(*places, lower, upper);
    estimation.setViewPoint(
        (lower.x + upper.x) / 2, (lower.y + upper.y) / 2, (lower.z + upper.z) / 2);
  }
  const auto normals = pcl::make_shared<Normals>();
  estimation.compute(*normals);
  return normals;
}

template <typename Clusters>
Labels
labelsOf(const Clusters& clusters, std::size_t count)
{
  Labels labels(count, 0);
  std::uint32_t label = 0;
  for (const auto& cluster : clusters) {
    ++label;
    for (const auto i : cluster.indices)
      labels[i] = label;
  }
  return labels;
}

Labels
growSmoothly(const Cloud::Ptr& places, const BaselineOptions& options)
{
  pcl::RegionGrowing<pcl::PointXYZ, pcl::Normal> growing;
  growing.setMinClusterSize(smallest_region);
  growing.setMaxClusterSize(static_cast<int>(places->size()));
  growing.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  growing.setNumberOfNeighbours(normal_neighbors);
  growing.setInputCloud(places);
  growing.setInputNormals(normalsOf(places, options));
  growing.setSmoothnessThreshold(smoothness);
  growing.setCurvatureThreshold(1.0f);
  std::vector<pcl::PointIndices> clusters;
  growing.extract(clusters);
  return labelsOf(clusters, places->size());
}

Labels
growByFeatures(const Cloud::Ptr& places, const BaselineOptions& options)
{
  const auto voxel = static_cast<float>(options.voxel_size);
  pcl::FPFHEstimationOMP<pcl::PointXYZ, pcl::Normal, pcl::FPFHSignature33> estimation(
      options.threads);
  estimation.setInputCloud(places);
  estimation.setInputNormals(normalsOf(places, options));
  estimation.setRadiusSearch(fpfh_reach * voxel);
  pcl::PointCloud<pcl::FPFHSignature33> features;
  estimation.compute(features);
  const auto numbered = pcl::make_shared<pcl::PointCloud<pcl::PointXYZL>>();
  for (const auto& place : *places) {
    pcl::PointXYZL point;
    point.getVector3fMap() = place.getVector3fMap();
    point.label = static_cast<std::uint32_t>(numbered->size());
    numbered->push_back(point);
  }
  pcl::ConditionalEuclideanClustering<pcl::PointXYZL> clustering;
  clustering.setInputCloud(numbered);
  clustering.setClusterTolerance(2 * voxel);
  clustering.setMinClusterSize(smallest_region);
  clustering.setMaxClusterSize(static_cast<int>(places->size()));
  clustering.setConditionFunction(
      [&features](const pcl::PointXYZL& a, const pcl::PointXYZL& b, float) {
        float difference = 0;
        for (int bin = 0; bin < 33; ++bin)
          difference += std::abs(features[a.label].histogram[bin] -
                                 features[b.label].histogram[bin]);
        return difference < like;
      });
  pcl::IndicesClusters clusters;
  clustering.segment(clusters);
  return labelsOf(clusters, places->size());
}

Labels
clusterByDistance(const Cloud::Ptr& places, const BaselineOptions& options)
{
  pcl::EuclideanClusterExtraction<pcl::PointXYZ> extraction;
  extraction.setInputCloud(places);
  extraction.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  extraction.setClusterTolerance(2 * options.voxel_size);
  extraction.setMinClusterSize(smallest_region);
  extraction.setMaxClusterSize(static_cast<pcl::uindex_t>(places->size()));
  std::vector<pcl::PointIndices> clusters;
  extraction.extract(clusters);
  return labelsOf(clusters, places->size());
}

/** Weights as of the segmentator: 1 - n1.n2, squared where the surface is convex. */
Labels
segmentNormalGraph(const Cloud::Ptr& places,
                   const Adjacency& around,
                   const BaselineOptions& options)
{
  const auto normals = normalsOf(places, options);
  std::vector<pcl::indoor::WeightedEdge> edges;
  for (std::uint32_t a = 0; a < places->size(); ++a)
    for (const auto b : around.of(a)) {
      if (b < a)
        continue;
      const Eigen::Vector3f n1 = (*normals)[a].getNormalVector3fMap(),
                            n2 = (*normals)[b].getNormalVector3fMap();
      float weight = std::max(0.0f, 1 - n1.dot(n2));
      const Eigen::Vector3f step =
          (*places)[b].getVector3fMap() - (*places)[a].getVector3fMap();
      if (n2.dot(step) > 0)
        weight *= weight;
      edges.push_back({a, b, std::isfinite(weight) ? weight : 1.0f});
    }
  auto labels = pcl::indoor::segmentGraph(
      places->size(), std::move(edges), graph_scale, graph_least);
  for (auto& label : labels)
    ++label;
  return labels;
}

} // namespace

namespace pcl::indoor::tool {

std::vector<std::uint32_t>
segmentBaseline(const PointCloud<PointXYZ>& cloud, const BaselineOptions& options)
{
  std::vector<Eigen::Vector3f> points;
  std::vector<std::size_t> usable;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (isUsablePoint(cloud[i])) {
      points.push_back(cloud[i].getVector3fMap());
      usable.push_back(i);
    }
  const auto cells = groupByCell(points, options.voxel_size);
  const auto places = pcl::make_shared<Cloud>();
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (const auto point : cells.pointsOf(cell))
      sum += points[point];
    const Eigen::Vector3f mean =
        sum / static_cast<float>(cells.offsets[cell + 1] - cells.offsets[cell]);
    places->push_back({mean.x(), mean.y(), mean.z()});
  }
  Labels of_place;
  switch (options.baseline) {
  case Baseline::SmoothGrowing:
    of_place = growSmoothly(places, options);
    break;
  case Baseline::FeatureGrowing:
    of_place = growByFeatures(places, options);
    break;
  case Baseline::EuclideanClusters:
    of_place = clusterByDistance(places, options);
    break;
  case Baseline::NormalGraph:
    of_place = segmentNormalGraph(places, cellAdjacency(cells.keys), options);
    break;
  }
  Labels labels(cloud.size(), 0);
  for (std::size_t i = 0; i < usable.size(); ++i)
    labels[usable[i]] = of_place[cells.cell_of_point[i]];
  return labels;
}

} // namespace pcl::indoor::tool
