/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "comparison/upstream_baselines.h"
#include "support/labelled_points.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <set>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;

namespace {

/** Two boxes apart: the label is twice the box, plus 1 on its top. */
struct Boxes {
  pcl::PointCloud<pcl::PointXYZ> cloud;
  std::vector<int> box, top;

  Boxes()
  {
    std::mt19937 rng(3);
    test::LabelledPoints points;
    points.addBox({0, 0, 0}, {0.8f, 0.6f, 0.5f}, 1, 0.02f, 0.001f, rng);
    points.addBox({1.6f, 0, 0}, {0.7f, 0.7f, 0.6f}, 2, 0.02f, 0.001f, rng);
    for (std::size_t i = 0; i < points.points.size(); ++i) {
      const auto& p = points.points[i];
      cloud.push_back({p.x(), p.y(), p.z()});
      box.push_back(static_cast<int>(points.objects[i]));
      top.push_back(points.normals[i].z() > 0.9f ? 1 : 0);
    }
    cloud.push_back({std::numeric_limits<float>::quiet_NaN(), 0, 0});
  }
};

std::vector<std::uint32_t>
segmented(const Boxes& boxes, Baseline baseline)
{
  BaselineOptions options;
  options.baseline = baseline;
  auto labels = segmentBaseline(boxes.cloud, options);
  EXPECT_EQ(labels.size(), boxes.cloud.size());
  EXPECT_EQ(labels.back(), 0u); // not finite
  // no segment reaches over the gap
  std::map<std::uint32_t, std::set<int>> boxes_of;
  std::size_t labelled = 0;
  for (std::size_t i = 0; i < boxes.box.size(); ++i)
    if (labels[i] != 0) {
      boxes_of[labels[i]].insert(boxes.box[i]);
      ++labelled;
    }
  for (const auto& entry : boxes_of)
    EXPECT_EQ(entry.second.size(), 1u);
  EXPECT_GT(labelled, boxes.box.size() / 2);
  return labels;
}

/** The label that most points of a box's top or of its other sides have. */
std::uint32_t
mostOf(const Boxes& boxes, const std::vector<std::uint32_t>& labels, int box, int top)
{
  std::map<std::uint32_t, int> counts;
  for (std::size_t i = 0; i < boxes.box.size(); ++i)
    if (boxes.box[i] == box && boxes.top[i] == top)
      ++counts[labels[i]];
  std::uint32_t best = 0;
  for (const auto& [label, count] : counts)
    if (label != 0 && count > counts[best])
      best = label;
  return best;
}

} // namespace

TEST(UpstreamBaselines, EuclideanClustersAreTheBoxes)
{
  const Boxes boxes;
  const auto labels = segmented(boxes, Baseline::EuclideanClusters);
  EXPECT_EQ(std::set<std::uint32_t>(labels.begin(), labels.end() - 1).size(), 2u);
}

TEST(UpstreamBaselines, GrowingByNormalsPartsTheFacesOfABox)
{
  const Boxes boxes;
  const auto labels = segmented(boxes, Baseline::SmoothGrowing);
  for (const int box : {1, 2})
    EXPECT_NE(mostOf(boxes, labels, box, 0), mostOf(boxes, labels, box, 1));
}

TEST(UpstreamBaselines, GraphOfNormalsPartsBoxes)
{
  const Boxes boxes;
  const auto labels = segmented(boxes, Baseline::NormalGraph);
  EXPECT_NE(mostOf(boxes, labels, 1, 1), mostOf(boxes, labels, 2, 1));
  EXPECT_NE(mostOf(boxes, labels, 1, 1), 0u);
}

TEST(UpstreamBaselines, GrowingByFeaturesKeepsFaces)
{
  const Boxes boxes;
  const auto labels = segmented(boxes, Baseline::FeatureGrowing);
  EXPECT_NE(mostOf(boxes, labels, 1, 1), mostOf(boxes, labels, 2, 1));
}

TEST(UpstreamBaselines, OneThreadOrMany)
{
  const Boxes boxes;
  BaselineOptions options;
  options.baseline = Baseline::FeatureGrowing;
  options.threads = 1;
  const auto one = segmentBaseline(boxes.cloud, options);
  options.threads = 4;
  EXPECT_EQ(segmentBaseline(boxes.cloud, options), one);
}
