/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "thesis/objects/upstream_supervoxels.h"

#include "thesis/objects/edge_partition.h"

#include <pcl/features/unit_normals.h>
#include <pcl/indoor/flood_fill.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/lccp_segmentation.h>
#include <pcl/segmentation/supervoxel_clustering.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace {

using PointT = pcl::PointXYZRGBA; // what PCL has compiled these classes for
using Upstream = pcl::SupervoxelClustering<PointT>;
using Clusters = std::map<std::uint32_t, pcl::Supervoxel<PointT>::Ptr>;
using Adjacencies = std::multimap<std::uint32_t, std::uint32_t>;
using pcl::indoor::Supervoxels;
using pcl::indoor::SurfaceEdge;
using pcl::indoor::thesis::ObjectOptions;

constexpr float zero_hue = 128;     // of a and b as bytes: those of sRGB are -108 to 98
constexpr float color_unit = 2.55f; // PCL's colours are from 0 to 1, D_c is per 100

void
putColor(const Eigen::Vector3f& lab, PointT& point)
{
  const auto byte = [](float value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 255.0f)));
  };
  point.r = byte(lab[0]);
  point.g = byte(lab[1] + zero_hue);
  point.b = byte(lab[2] + zero_hue);
}

Eigen::Vector3f
colorOf(const PointT& point)
{
  return {static_cast<float>(point.r),
          static_cast<float>(point.g) - zero_hue,
          static_cast<float>(point.b) - zero_hue};
}

/** Upstream's, but for the search of connected supervoxels: upstream's calls itself
 * once for each of them, and the stack of a thread is small. */
class FlatLccp : public pcl::LCCPSegmentation<PointT> {
public:
  void
  segment()
  {
    calculateConvexConnections(sv_adjacency_list_);
    groupOverValidEdges();
    grouping_data_valid_ = true;
    mergeSmallSegments();
  }

private:
  void
  groupOverValidEdges()
  {
    const auto& graph = sv_adjacency_list_;
    const auto visit_joined = [&graph](VertexID vertex, const auto& visit) {
      const auto [begin, end] = boost::out_edges(vertex, graph);
      for (auto edge = begin; edge != end; ++edge)
        if (graph[*edge].is_valid)
          visit(boost::target(*edge, graph));
    };
    std::uint32_t last = 0; // 0 is none
    std::vector<VertexID> members;
    sv_label_to_seg_label_map_.clear();
    seg_label_to_sv_list_map_.clear();
    const auto enter = [&](VertexID vertex, VertexID /*from*/) {
      return sv_label_to_seg_label_map_.emplace(graph[vertex], last).second;
    };
    const auto [first, end] = boost::vertices(graph);
    for (auto vertex = first; vertex != end; ++vertex) {
      if (sv_label_to_seg_label_map_.count(graph[*vertex]) > 0)
        continue;
      sv_label_to_seg_label_map_[graph[*vertex]] = ++last;
      members.assign(1, *vertex);
      pcl::indoor::floodFill(members, visit_joined, enter);
      for (const auto member : members)
        seg_label_to_sv_list_map_[last].insert(graph[member]);
    }
  }
};

/** The segment of each supervoxel by LCCP; its sanity criterion has 60 degrees. */
std::vector<std::uint32_t>
lccpSegments(const Clusters& clusters,
             const Adjacencies& adjacency,
             const ObjectOptions& options)
{
  const auto& shared = options.shared;
  FlatLccp lccp;
  lccp.setConcavityToleranceThreshold(options.edges.concavity_tolerance_degrees);
  lccp.setSanityCheck(true);
  lccp.setSmoothnessCheck(false,
                          static_cast<float>(shared.voxel_size),
                          static_cast<float>(shared.seed_size),
                          0.1f);
  lccp.setKFactor(0);
  lccp.setInputSupervoxels(clusters, adjacency);
  lccp.setMinSegmentSize(pcl::indoor::largest_small_segment);
  lccp.segment();
  pcl::PointCloud<pcl::PointXYZL> names;
  for (const auto& cluster : clusters) {
    names.push_back({});
    names.back().label = cluster.first;
  }
  lccp.relabelCloud(names);
  std::vector<std::uint32_t> segments;
  for (const auto& point : names)
    segments.push_back(point.label == 0 ? Supervoxels::none : point.label - 1);
  return segments;
}

std::vector<SurfaceEdge>
edgesOf(const Adjacencies& adjacency,
        const std::map<std::uint32_t, std::uint32_t>& number)
{
  std::vector<SurfaceEdge> edges;
  for (const auto& [name, other] : adjacency) {
    const auto source = number.at(name), target = number.at(other);
    if (source < target)
      edges.push_back({source, target, 1});
  }
  return edges;
}

} // namespace

namespace pcl::indoor {

PointPartition
partitionWithUpstream(const SurfaceVoxels& surface,
                      const std::vector<std::uint8_t>& left_out,
                      const std::optional<Eigen::Vector3f>& camera,
                      const ObjectOptions& options)
{
  const auto& shared = options.shared;
  PointPartition result;
  auto& supervoxels = result.supervoxels;
  supervoxels.label_of_voxel.assign(surface.size(), Supervoxels::none);
  const auto cloud = pcl::make_shared<PointCloud<PointT>>();
  const auto normals = pcl::make_shared<PointCloud<Normal>>();
  const Eigen::Vector3f origin = camera.value_or(Eigen::Vector3f::Zero());
  const bool has_colors = surface.appearance.colors.cols() > 0;
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < surface.size(); ++i)
    if (!left_out[i]) {
      kept.push_back(i);
      PointT point;
      point.getVector3fMap() = surface.centroids[i] - origin;
      if (has_colors)
        putColor(surface.appearance.colors.col(static_cast<Eigen::Index>(i)), point);
      cloud->push_back(point);
      const auto& n = surface.normals[i];
      normals->push_back(Normal(n.x(), n.y(), n.z()));
    }
  if (kept.empty())
    return result;
  Upstream clustering(static_cast<float>(shared.voxel_size),
                      static_cast<float>(shared.seed_size));
  clustering.setUseSingleCameraTransform(camera.has_value());
  clustering.setInputCloud(cloud);
  clustering.setNormalCloud(normals);
  clustering.setColorImportance(options.on_points->color_weight * color_unit);
  clustering.setSpatialImportance(shared.spatial_weight);
  clustering.setNormalImportance(shared.normal_weight);
  Clusters clusters;
  clustering.extract(clusters);
  Adjacencies adjacency;
  clustering.getSupervoxelAdjacency(adjacency);

  std::map<std::uint32_t, std::uint32_t> number;
  if (has_colors)
    supervoxels.appearance.colors.resize(3, static_cast<Eigen::Index>(clusters.size()));
  for (const auto& [name, supervoxel] : clusters) {
    if (has_colors)
      supervoxels.appearance.colors.col(static_cast<Eigen::Index>(number.size())) =
          colorOf(supervoxel->centroid_);
    number.emplace(name, static_cast<std::uint32_t>(number.size()));
    supervoxels.centroids.push_back(supervoxel->centroid_.getVector3fMap() + origin);
    supervoxels.normals.push_back(
        finiteNormal(supervoxel->normal_.getNormalVector3fMap()));
  }
  const auto labelled = clustering.getLabeledCloud();
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const auto found = number.find((*labelled)[i].label);
    if (found != number.end())
      supervoxels.label_of_voxel[kept[i]] = found->second;
  }
  result.edges = edgesOf(adjacency, number);
  result.segment_of_supervoxel =
      options.edges.partition == thesis::EdgePartition::Lccp
          ? lccpSegments(clusters, adjacency, options)
          : joinOverEdges(supervoxels, result.edges, options);
  return result;
}

} // namespace pcl::indoor
