/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

/* The thesis's presets against Sec. 4.2 by its definitions, between upstream's
 * supervoxels, which both call: no cells, every point against every other. */

#include "support/labelled_points.h"

#include "objects/object_steps.h"

#include <pcl/segmentation/lccp_segmentation.h>
#include <pcl/segmentation/supervoxel_clustering.h>
#include <pcl/segmentation/thesis.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <pthread.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

using namespace pcl::indoor;

namespace {

using Points = std::vector<Eigen::Vector3f>;
using PointT = pcl::PointXYZRGBA;

const Eigen::Vector3f sensor(0.3f, -2.0f, 2.0f);
constexpr std::uint32_t none = Supervoxels::none;

/** A box and a cylinder's half on a table top, with noise. */
Points
tableScene(unsigned seed)
{
  std::mt19937 rng(seed);
  test::LabelledPoints scene;
  scene.addRectangle(
      {0, 0, 0}, {1, 0, 0}, {0, 0.8f, 0}, {0, 0, 1}, 1, 0.025f, 0.003f, rng);
  scene.addBox({0.2f, 0.2f, 0}, {0.25f, 0.3f, 0.25f}, 2, 0.025f, 0.003f, rng);
  scene.addBox({0.45f, 0.25f, 0}, {0.3f, 0.2f, 0.15f}, 3, 0.025f, 0.003f, rng);
  return scene.points;
}

ObjectSegmentationInput
inputOf(const Points& points)
{
  ObjectSegmentationInput input;
  input.points = points;
  input.viewpoint = {sensor};
  return input;
}

/** Sec. 4.2 by its definitions. */
class DenseObjects {
public:
  DenseObjects(Points points, const thesis::ObjectOptions& options, double radius)
  : points_(std::move(points))
  , options_(options)
  , radius_(radius)
  {
    for (std::size_t i = 0; i < points_.size(); ++i)
      addSurface(i);
    for (std::size_t i = 0; i < points_.size(); ++i)
      removed.push_back(isRemoved(i));
    makeSupervoxels();
    if (options.edges.partition == thesis::EdgePartition::Lccp)
      joinByLccp();
    else
      joinByGraph();
    for (std::size_t i = 0; i < points_.size(); ++i)
      labels.push_back(supervoxel_[i] == 0 ? 0 : segment_.at(supervoxel_[i]));
    recover();
  }

  std::vector<Eigen::Vector3f> normals;
  std::vector<float> curvatures;
  std::vector<std::uint8_t> removed;
  std::vector<std::uint32_t> labels; // 0 = none

private:
  /** Eq. (2.3) to (2.6) and (2.8). */
  void
  addSurface(std::size_t i)
  {
    std::vector<Eigen::Vector3d> around;
    for (const auto& point : points_)
      if ((point - points_[i]).norm() <= radius_)
        around.push_back(point.cast<double>());
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const auto& point : around)
      mean += point / static_cast<double>(around.size());
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const auto& point : around)
      scatter += (point - mean) * (point - mean).transpose();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(scatter, Eigen::ComputeFullU);
    Eigen::Vector3f normal = svd.matrixU().col(2).cast<float>();
    if (normal.dot(sensor - points_[i]) < 0)
      normal = -normal;
    normals.push_back(normal);
    const Eigen::Vector3d values = svd.singularValues();
    curvatures.push_back(static_cast<float>(values[2] / values.sum()));
  }

  /** Eq. (4.2). */
  bool
  isRemoved(std::size_t i) const
  {
    double positive = 0, negative = 0;
    for (const auto& point : points_) {
      if ((point - points_[i]).norm() > radius_)
        continue;
      const float height = normals[i].dot(point - points_[i]);
      positive += height > 0;
      negative += height < 0;
    }
    return curvatures[i] > options_.shared.curvature_threshold &&
           positive >= options_.shared.ratio_threshold * negative;
  }

  void
  makeSupervoxels()
  {
    const auto cloud = pcl::make_shared<pcl::PointCloud<PointT>>();
    const auto cloud_normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (removed[i])
        continue;
      kept.push_back(i);
      PointT point;
      point.getVector3fMap() = points_[i];
      cloud->push_back(point);
      cloud_normals->push_back({normals[i].x(), normals[i].y(), normals[i].z()});
    }
    pcl::SupervoxelClustering<PointT> upstream(
        static_cast<float>(options_.shared.voxel_size),
        static_cast<float>(options_.shared.seed_size));
    upstream.setUseSingleCameraTransform(false);
    upstream.setInputCloud(cloud);
    upstream.setNormalCloud(cloud_normals);
    upstream.setColorImportance(0);
    upstream.setSpatialImportance(0.2f);
    upstream.setNormalImportance(0.5f);
    upstream.extract(clusters_);
    upstream.getSupervoxelAdjacency(adjacency_);
    supervoxel_.assign(points_.size(), 0);
    for (std::size_t k = 0; k < kept.size(); ++k)
      supervoxel_[kept[k]] = (*upstream.getLabeledCloud())[k].label;
  }

  /** Eq. (4.4). */
  float
  distance(const Eigen::Vector3f& x1,
           const Eigen::Vector3f& n1,
           const Eigen::Vector3f& x2,
           const Eigen::Vector3f& n2) const
  {
    return (x1 - x2).norm() * (0.2f / static_cast<float>(options_.shared.seed_size)) +
           (1 - std::abs(n1.dot(n2))) * 0.5f;
  }

  /** Eq. (4.3), (2.14) to (2.17); components are sets that are merged by hand. */
  void
  joinByGraph()
  {
    std::vector<std::tuple<float, std::uint32_t, std::uint32_t>> edges;
    std::map<std::uint32_t, std::uint32_t> component;
    std::map<std::uint32_t, std::set<std::uint32_t>> members;
    std::map<std::uint32_t, float> internal;
    for (const auto& entry : clusters_) {
      component[entry.first] = entry.first;
      members[entry.first] = {entry.first};
      internal[entry.first] = 0;
    }
    for (const auto& [a, b] : adjacency_)
      if (a < b) {
        const Eigen::Vector3f x1 = clusters_.at(a)->centroid_.getVector3fMap(),
                              x2 = clusters_.at(b)->centroid_.getVector3fMap(),
                              n1 = clusters_.at(a)->normal_.getNormalVector3fMap(),
                              n2 = clusters_.at(b)->normal_.getNormalVector3fMap();
        const float d = distance(x1, n1, x2, n2);
        const float between = std::acos(std::min(1.0f, std::max(-1.0f, n1.dot(n2))));
        const bool convex =
            (n1 - n2).dot(x1 - x2) > 0 ||
            between * 180 / M_PI < options_.edges.concavity_tolerance_degrees;
        edges.emplace_back(convex ? options_.edges.concavity_weight * d * d : d, a, b);
      }
    std::sort(edges.begin(), edges.end());
    const auto merge = [&](std::uint32_t a, std::uint32_t b, float weight) {
      for (const auto member : members.at(b)) {
        component[member] = a;
        members.at(a).insert(member);
      }
      members.erase(b);
      internal[a] = weight; // edges come in ascending order
    };
    for (const auto& [weight, source, target] : edges) {
      const auto a = component.at(source), b = component.at(target);
      const auto threshold = [&](std::uint32_t c) {
        return internal.at(c) +
               options_.edges.graph_scale / static_cast<float>(members.at(c).size());
      };
      if (a != b && weight <= std::min(threshold(a), threshold(b)))
        merge(a, b, weight);
    }
    for (const auto& [weight, source, target] : edges) { // C
      const auto a = component.at(source), b = component.at(target);
      if (a != b && std::min(members.at(a).size(), members.at(b).size()) <
                        options_.shared.min_segment_size)
        merge(a, b, weight);
    }
    for (const auto& [name, root] : component)
      segment_[name] = root;
  }

  void
  joinByLccp()
  {
    pcl::LCCPSegmentation<PointT> lccp;
    lccp.setConcavityToleranceThreshold(10);
    lccp.setSanityCheck(true);
    lccp.setSmoothnessCheck(false, 0.03f, 0.12f, 0.1f);
    lccp.setKFactor(0);
    lccp.setMinSegmentSize(3);
    lccp.setInputSupervoxels(clusters_, adjacency_);
    lccp.segment();
    std::map<std::uint32_t, std::set<std::uint32_t>> members;
    lccp.getSegmentToSupervoxelMap(members);
    for (const auto& [segment, names] : members)
      for (const auto name : names)
        segment_[name] = segment;
  }

  /** Algorithm 1, with the sort outside of the loop over points. */
  void
  recover()
  {
    for (int s = 0; s < 20; ++s) {
      std::vector<std::tuple<float, std::size_t, std::uint32_t>> w;
      for (std::size_t i = 0; i < points_.size(); ++i) {
        if (labels[i] != 0)
          continue;
        std::tuple<float, std::size_t, std::uint32_t> nearest{1e9f, i, 0};
        for (std::size_t j = 0; j < points_.size(); ++j) {
          if (labels[j] == 0 ||
              (points_[j] - points_[i]).norm() > options_.shared.voxel_size)
            continue;
          const float d = distance(points_[i], normals[i], points_[j], normals[j]);
          if (d < std::get<0>(nearest))
            nearest = {d, i, labels[j]};
        }
        if (std::get<2>(nearest) != 0)
          w.push_back(nearest);
      }
      std::sort(w.begin(), w.end());
      auto preserved = w.size();
      if (s != 19)
        preserved = static_cast<std::size_t>(
            std::max(1l, std::lround(0.8 * static_cast<double>(w.size()))));
      for (std::size_t i = 0; i < std::min(preserved, w.size()); ++i)
        labels[std::get<1>(w[i])] = std::get<2>(w[i]);
    }
  }

  Points points_;
  const thesis::ObjectOptions& options_;
  double radius_;
  std::map<std::uint32_t, pcl::Supervoxel<PointT>::Ptr> clusters_;
  std::multimap<std::uint32_t, std::uint32_t> adjacency_;
  std::vector<std::uint32_t> supervoxel_;
  std::map<std::uint32_t, std::uint32_t> segment_;
};

void
expectAsDefined(const thesis::ObjectOptions& given, unsigned seed)
{
  const auto points = tableScene(seed);
  auto options = given;
  options.on_points->removal_radius = 0.06;
  options.on_points->ransac_share = 0; // the table is to stay
  const auto result = segmentObjects(inputOf(points), options);
  const DenseObjects dense(points, options, options.on_points->removal_radius);
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_NEAR(stepsOf(result).scene.voxels.curvatures[i], dense.curvatures[i], 1e-5);
    ASSERT_GT(stepsOf(result).scene.voxels.normals[i].dot(dense.normals[i]), 0.999f);
  }
  EXPECT_EQ(stepsOf(result).removed, dense.removed);
  EXPECT_GT(std::count(dense.removed.begin(), dense.removed.end(), 1), 20);
  std::map<std::uint32_t, std::uint32_t> name, back;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto segment = result.segment_of_point[i];
    ASSERT_EQ(segment == none, dense.labels[i] == 0) << i;
    if (segment == none)
      continue;
    ASSERT_EQ(name.emplace(dense.labels[i], segment).first->second, segment) << i;
    ASSERT_EQ(back.emplace(segment, dense.labels[i]).first->second, dense.labels[i]);
  }
  EXPECT_EQ(name.size(), result.segment_count);
  EXPECT_GT(name.size(), 1u);
}

} // namespace

TEST(ThesisObjects, GraphSegmentationAsDefined)
{
  auto options = thesisOptions();
  options.edges.graph_scale = 0.3f; // else so small a scene is one segment
  for (unsigned seed = 1; seed <= 4; ++seed)
    expectAsDefined(options, seed);
}

TEST(ThesisObjects, ProposedAndLccpAsDefined)
{
  auto options = thesisOptions();
  options.edges.partition = thesis::EdgePartition::Lccp;
  for (unsigned seed = 1; seed <= 4; ++seed)
    expectAsDefined(options, seed);
}

TEST(ThesisObjects, LccpOfAWideFloorNeedsNoDeepStack)
{
  std::mt19937 rng(5);
  test::LabelledPoints floor;
  floor.addRectangle(
      {0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 1}, 1, 0.025f, 0.001f, rng);
  auto options = thesisOptions();
  options.edges.partition = thesis::EdgePartition::Lccp;
  options.on_points->ransac_share = 0; // the floor is to stay
  options.shared.threads = 1;
  struct Work {
    ObjectSegmentationInput input;
    thesis::ObjectOptions options;
    ObjectSegmentation result;
  } work{inputOf(floor.points), options, {}};
  const auto segment = [](void* data) -> void* {
    auto& own = *static_cast<Work*>(data);
    own.result = segmentObjects(own.input, own.options);
    return nullptr;
  };
  pthread_attr_t attributes;
  pthread_t thread;
  ASSERT_EQ(pthread_attr_init(&attributes), 0);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, 1 << 18), 0); // 256 kB
  ASSERT_EQ(pthread_create(&thread, &attributes, segment, &work), 0);
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
  EXPECT_GT(stepsOf(work.result).supervoxels.size(), 2000u);
  std::map<std::uint32_t, std::size_t> sizes;
  std::size_t largest = 0;
  for (const auto one : work.result.segment_of_point)
    largest = std::max(largest, ++sizes[one]);
  EXPECT_GT(largest, 0.9 * floor.points.size());
}

TEST(ThesisObjects, KinectAsDefined)
{
  auto options = thesisKinectOptions();
  EXPECT_FLOAT_EQ(options.shared.curvature_threshold, 0.02f);
  EXPECT_FLOAT_EQ(options.edges.graph_scale, 5);
  EXPECT_DOUBLE_EQ(options.shared.seed_size, 0.16);
  EXPECT_DOUBLE_EQ(options.shared.voxel_size, 0.04);
  EXPECT_DOUBLE_EQ(options.on_points->removal_radius, 0);
  options.edges.graph_scale = 0.3f;
  expectAsDefined(options, 1);
}

TEST(ThesisObjects, ASingleCameraMayStandAnywhere)
{
  auto input = inputOf(tableScene(7));
  input.capture = Capture::TableView;
  for (auto& point : input.points) // in front of a camera that looks along z
    point = Eigen::Vector3f(point.x() - 0.5f, point.y() - 0.4f, 1.2f - point.z());
  input.viewpoint = {Eigen::Vector3f::Zero()};
  auto options = thesisKinectOptions();
  options.edges.graph_scale = 0.3f;
  options.on_points->removal_radius = 0.06;
  const auto here = segmentObjects(input, options);
  EXPECT_LT(stepsOf(here).supervoxels.size(), 300u);
  EXPECT_GT(here.segment_count, 1u);
  const Eigen::Vector3f moved(4, -2, 8); // whole numbers: nothing is rounded
  for (auto& point : input.points)
    point += moved;
  input.viewpoint = {moved};
  const auto there = segmentObjects(input, options);
  EXPECT_NEAR(there.segment_count, here.segment_count, 2);
  EXPECT_NEAR(static_cast<double>(stepsOf(there).supervoxels.size()),
              static_cast<double>(stepsOf(here).supervoxels.size()),
              0.1 * static_cast<double>(stepsOf(here).supervoxels.size()));
}

TEST(ThesisObjects, TheSameForAnyNumberOfThreads)
{
  auto options = thesisOptions();
  options.edges.graph_scale = 0.3f;
  options.on_points->ransac_share = 0;
  options.shared.threads = 1;
  const auto one = segmentObjects(inputOf(tableScene(5)), options);
  options.shared.threads = 8;
  EXPECT_EQ(segmentObjects(inputOf(tableScene(5)), options).segment_of_point,
            one.segment_of_point);
}

TEST(ThesisObjects, RansacTakesFloorAndWallsOff)
{
  std::mt19937 rng(6);
  test::LabelledPoints room;
  room.addRectangle({0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 1}, 1, 0.04f, 0.004f, rng);
  room.addRectangle(
      {0, 0, 0}, {3, 0, 0}, {0, 0, 2.5f}, {0, 1, 0}, 2, 0.04f, 0.004f, rng);
  room.addBox({1, 1, 0.03f}, {0.5f, 0.5f, 0.5f}, 3, 0.04f, 0.004f, rng);
  auto options = thesisOptions();
  options.on_points->ransac_share = 0.2;
  const auto result = segmentObjects(inputOf(room.points), options);
  ASSERT_EQ(stepsOf(result).scene.planes.size(), 2u);
  std::map<StructureKind, std::set<std::uint32_t>> segments;
  for (std::size_t i = 0; i < room.points.size(); ++i) {
    // every point within R_voxel of a plane is its, and no other
    const auto plane = stepsOf(result).scene.plane_of_voxel[i];
    double nearest = 9;
    for (const auto& candidate : stepsOf(result).scene.planes)
      nearest = std::min(nearest,
                         std::abs(candidate.heightOf(room.points[i].cast<double>())));
    ASSERT_EQ(plane != 0, nearest <= options.shared.voxel_size) << i;
    const auto segment = result.segment_of_point[i];
    if (segment != none)
      segments[result.structure_of_segment[segment]].insert(segment);
    if (plane != 0) {
      ASSERT_EQ(result.structure_of_segment[segment],
                std::abs(stepsOf(result).scene.planes[plane - 1].normal.z()) > 0.9
                    ? StructureKind::Floor
                    : StructureKind::Wall);
    }
  }
  EXPECT_EQ(segments[StructureKind::Floor].size(), 1u);
  EXPECT_EQ(segments[StructureKind::Wall].size(), 1u);
  EXPECT_GE(segments[StructureKind::None].size(), 1u);
  options.on_points->ransac_share = 0.9;
  EXPECT_TRUE(
      stepsOf(segmentObjects(inputOf(room.points), options)).scene.planes.empty());
}

TEST(ThesisObjects, BadOptionsAreRefusedAndFewPointsAreNone)
{
  auto options = thesisOptions();
  options.on_points->ransac_share = 1.5;
  EXPECT_NE(findProblem(options), "");
  options = thesisOptions();
  options.on_points->removal_radius = -1;
  EXPECT_NE(findProblem(options), "");
  EXPECT_EQ(findProblem(thesisKinectOptions()), "");
  const auto two = segmentObjects(inputOf({{0, 0, 0}, {0, 0, 0}}), thesisOptions());
  EXPECT_EQ(two.segment_of_point.size(), 2u);
}
