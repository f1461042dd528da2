/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/features/eppf.h>
#include <pcl/features/impl/oriented_points.hpp>
#include <pcl/io/pcd_io.h>
#include <pcl/kdtree/impl/kdtree_flann.hpp>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include "features/oriented_shapes.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>
#include <vector>

namespace {

template <typename SignatureT>
using EstimationOf =
    pcl::EPPFEstimation<pcl::PointNormal, pcl::PointNormal, SignatureT>;

// What holds for any output is tested with the one that has all parts.
using Signature = pcl::PairHarmonicsSignature1200;
using Estimation = EstimationOf<Signature>;
using Descriptors = pcl::PointCloud<Signature>;

pcl::PointCloud<pcl::PointNormal>::Ptr
boxCloud(std::size_t count, std::uint32_t seed)
{
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  for (const auto& point : pcl::indoor::boxSurface({1.0f, 0.6f, 0.3f}, count, seed)) {
    pcl::PointNormal both;
    both.getVector3fMap() = point.position;
    both.getNormalVector3fMap() = point.normal;
    cloud->push_back(both);
  }
  return cloud;
}

Descriptors
describe(const pcl::PointCloud<pcl::PointNormal>::ConstPtr& cloud)
{
  Estimation estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(cloud);
  Descriptors output;
  estimation.compute(output);
  return output;
}

bool
isSame(const Signature& a, const Signature& b)
{
  return std::equal(a.histogram, a.histogram + 1200, b.histogram);
}

double
difference(const Signature& a, const Signature& b)
{
  double sum = 0.0;
  for (int bin = 0; bin < 1200; ++bin)
    sum += std::abs(a.histogram[bin] - b.histogram[bin]);
  return sum;
}

TEST(EPPFEstimation, PointsTooFarToComputeWithAreSkipped)
{
  auto cloud = boxCloud(500, 3);
  const auto expected = describe(cloud);
  for (const float far : {1e10f, 1e20f, 3e38f}) {
    auto damaged = *cloud;
    damaged.push_back(damaged.front());
    damaged.back().x = far;
    const auto output = describe(damaged.makeShared());
    ASSERT_EQ(output.size(), 1u);
    EXPECT_TRUE(isSame(output[0], expected[0])) << far;
    for (auto& point : damaged)
      point.getVector3fMap() *= far;
    if (far > 1e15f) { // else a few points near the axes stay
      EXPECT_FALSE(describe(damaged.makeShared()).is_dense) << far;
    }
  }
}

TEST(EPPFEstimation, TinyObjectsTakeNoLongerThanOthers)
{
  for (const float size : {1e-18f, 1e-20f, 1e-22f, 1e-40f}) {
    auto cloud = boxCloud(500, 3); // squares of such lengths are denormal or 0
    for (auto& point : *cloud)
      point.getVector3fMap() *= size;
    EXPECT_EQ(describe(cloud).size(), 1u);
  }
}

TEST(EPPFEstimation, OneObjectGivesOneDescriptor)
{
  const auto cloud = boxCloud(2000, 1);
  cloud->header.frame_id = "room";
  const auto output = describe(cloud);
  ASSERT_EQ(output.size(), 1u);
  EXPECT_EQ(output.width, 1u);
  EXPECT_EQ(output.height, 1u);
  EXPECT_TRUE(output.is_dense);
  EXPECT_EQ(output.header.frame_id, "room");
  EXPECT_NEAR(
      std::accumulate(output[0].histogram, output[0].histogram + 1200, 0.0), 1.0, 1e-6);
}

TEST(EPPFEstimation, CallThroughTheBaseGivesTheSame)
{
  const auto cloud = boxCloud(500, 2);
  Estimation estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(cloud);
  Descriptors own, base;
  estimation.compute(own);
  static_cast<pcl::Feature<pcl::PointNormal, Signature>&>(estimation).compute(base);
  ASSERT_EQ(own.size(), 1u);
  ASSERT_EQ(base.size(), 1u);
  EXPECT_TRUE(isSame(own[0], base[0]));
  estimation.compute(own); // a second run on the same object
  ASSERT_EQ(own.size(), 1u);
  EXPECT_TRUE(isSame(own[0], base[0]));
}

/** \brief The descriptor of a cloud by an output type's defaults. */
template <typename SignatureT>
std::vector<float>
defaultHistogram(const pcl::PointCloud<pcl::PointNormal>::ConstPtr& cloud)
{
  EstimationOf<SignatureT> estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(cloud);
  pcl::PointCloud<SignatureT> output;
  estimation.compute(output);
  EXPECT_EQ(output.size(), 1u);
  return {std::begin(output[0].histogram), std::end(output[0].histogram)};
}

TEST(EPPFEstimation, OutputTypeSaysWhatIsComputed)
{
  using namespace pcl::indoor;
  const auto cloud = boxCloud(500, 3);
  pcl::Indices indices(cloud->size());
  std::iota(indices.begin(), indices.end(), 0);
  const auto points = orientedPoints(*cloud, *cloud, indices);
  EXPECT_EQ(defaultHistogram<pcl::EPPFSignature1200>(cloud),
            eppfHistogram(points, thesisEPPFOptions()));
  EXPECT_EQ(defaultHistogram<pcl::EPPFSignature540>(cloud),
            eppfHistogram(points, shortEPPFOptions()));
  EXPECT_EQ(defaultHistogram<Signature>(cloud),
            eppfHistogram(points, pairHarmonicsOptions()));
  const pcl::EPPFEstimation<pcl::PointNormal, pcl::PointNormal> thesis;
  EXPECT_EQ(thesis.getBins().distance, 20);
  EXPECT_EQ(thesis.getBins().surface_angle, 4);
  EXPECT_EQ(thesis.getBins().normal_angle, 5);
  EXPECT_EQ(thesis.getBins().occupancy, 3);
  EXPECT_EQ(thesis.getBins().harmonics.size(), 0u);
}

TEST(EPPFEstimation, EPPFSignaturesHoldNoHarmonics)
{
  const auto cloud = boxCloud(500, 3);
  EstimationOf<pcl::EPPFSignature1200> estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(cloud);
  estimation.setOptions(pcl::indoor::pairHarmonicsOptions()); // 1,200 bins, too
  pcl::PointCloud<pcl::EPPFSignature1200> output;
  estimation.compute(output);
  EXPECT_TRUE(output.empty());
  estimation.setBins({8, 15, 5, 2, {}});
  estimation.compute(output);
  EXPECT_EQ(output.size(), 1u);
}

TEST(EPPFEstimation, EachOutputHasAFieldOfItsOwn)
{
  const auto field = [](auto signature) {
    return pcl::getFieldsList(pcl::PointCloud<decltype(signature)>());
  };
  EXPECT_EQ(field(pcl::EPPFSignature1200()), "eppf");
  EXPECT_EQ(field(pcl::EPPFSignature540()), "eppf_short");
  EXPECT_EQ(field(Signature()), "pair_harmonics");
}

TEST(EPPFEstimation, SeparateNormalsOfAnyLengthWillDo)
{
  const auto cloud = boxCloud(500, 4);
  auto points = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  for (const auto& point : *cloud) {
    points->push_back({point.x, point.y, point.z});
    normals->push_back({4 * point.normal_x, 4 * point.normal_y, 4 * point.normal_z});
  }
  pcl::EPPFEstimation<pcl::PointXYZ, pcl::Normal, Signature> estimation;
  estimation.setInputCloud(points);
  estimation.setInputNormals(normals);
  Descriptors output;
  estimation.compute(output);
  ASSERT_EQ(output.size(), 1u);
  EXPECT_TRUE(isSame(output[0], describe(cloud)[0]));
}

TEST(EPPFEstimation, OnlyTheIndicesAreRead)
{
  const auto cloud = boxCloud(400, 5);
  auto more = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>(*cloud);
  *more += *boxCloud(300, 6);
  auto indices = pcl::make_shared<pcl::Indices>(400);
  std::iota(indices->begin(), indices->end(), 0);
  Estimation estimation;
  estimation.setInputCloud(more);
  estimation.setInputNormals(more);
  estimation.setIndices(indices);
  Descriptors output;
  estimation.compute(output);
  ASSERT_EQ(output.size(), 1u);
  EXPECT_TRUE(isSame(output[0], describe(cloud)[0]));
}

TEST(EPPFEstimation, SkipsPointsThatAreNotFinite)
{
  const auto cloud = boxCloud(400, 7);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  auto broken = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  for (std::size_t k = 0; k < cloud->size(); ++k) {
    auto bad = (*cloud)[k];
    if (k % 3 == 0)
      bad.y = nan;
    else if (k % 3 == 1)
      bad.normal_z = std::numeric_limits<float>::infinity();
    else
      bad.normal_x = bad.normal_y = bad.normal_z = 0.0f;
    broken->push_back(bad);
    broken->push_back((*cloud)[k]);
  }
  broken->is_dense = false;
  EXPECT_TRUE(isSame(describe(broken)[0], describe(cloud)[0]));
}

TEST(EPPFEstimation, NoPairGivesNaN)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const std::size_t count : {1u, 2u, 50u}) {
    auto cloud = boxCloud(count, 8);
    if (count > 1)
      for (auto& point : *cloud)
        point.x = nan;
    const auto output = describe(cloud);
    ASSERT_EQ(output.size(), 1u);
    EXPECT_FALSE(output.is_dense);
    for (const float value : output[0].histogram)
      EXPECT_TRUE(std::isnan(value));
  }
}

TEST(EPPFEstimation, LargeCoordinatesChangeLittle)
{
  // At 2^22 m (UTM) a float has steps of 0.5 m: positions that are whole metres lose
  // nothing, so that any difference would be the estimator's own loss.
  auto cloud = boxCloud(1000, 9);
  for (auto& point : *cloud)
    for (int axis = 0; axis < 3; ++axis)
      point.data[axis] = std::round(1000.0f * point.data[axis]);
  auto far = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>(*cloud);
  for (auto& point : *far) {
    point.x += 4194304.0f;
    point.y += 4194304.0f;
  }
  EXPECT_TRUE(isSame(describe(far)[0], describe(cloud)[0]));
}

TEST(EPPFEstimation, TurnedObjectLooksLikeItselfAndUnlikeOthers)
{
  const auto cloud = boxCloud(2000, 10);
  auto turned = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf(0.7f, Eigen::Vector3f(1.0f, -1.0f, 0.5f).normalized())
          .toRotationMatrix();
  for (auto point : *cloud) {
    point.getVector3fMap() = turn * point.getVector3fMap();
    point.getNormalVector3fMap() = turn * point.getNormalVector3fMap();
    turned->push_back(point);
  }
  const auto original = describe(cloud)[0];
  auto cube = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  for (const auto& point : pcl::indoor::boxSurface({1.0f, 1.0f, 1.0f}, 2000, 10)) {
    cube->emplace_back();
    cube->back().getVector3fMap() = point.position;
    cube->back().getNormalVector3fMap() = point.normal;
  }
  // Sampling error is about sqrt(2 * bins / pairs) = 0.2 with the 500 bins a box fills,
  // and the voxel grid turns with the axes; another shape changes several times as
  // much.
  EXPECT_LT(2 * difference(describe(turned)[0], original),
            difference(describe(cube)[0], original));
}

void
expectRefused(Estimation& estimation)
{
  Descriptors output;
  output.resize(3);
  estimation.compute(output);
  EXPECT_TRUE(output.empty());
}

TEST(EPPFEstimation, RefusesUnusableInput)
{
  const auto cloud = boxCloud(10, 11);
  Estimation estimation;
  expectRefused(estimation); // no cloud
  estimation.setInputCloud(cloud);
  expectRefused(estimation); // no normals
  estimation.setInputNormals(boxCloud(9, 11));
  expectRefused(estimation); // another number of them
  estimation.setInputNormals(cloud);
  estimation.setIndices(pcl::make_shared<pcl::Indices>(pcl::Indices{0, 10}));
  expectRefused(estimation); // outside the cloud
  estimation.setIndices(pcl::make_shared<pcl::Indices>(pcl::Indices{-1}));
  expectRefused(estimation);
  estimation.setIndices(pcl::make_shared<pcl::Indices>());
  expectRefused(estimation); // none
  estimation.setIndices(pcl::make_shared<pcl::Indices>(pcl::Indices{0, 9}));
  Descriptors output;
  estimation.compute(output);
  EXPECT_EQ(output.size(), 1u);
  const auto empty = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  Estimation fresh;
  fresh.setInputCloud(empty);
  fresh.setInputNormals(empty);
  expectRefused(fresh);
}

TEST(EPPFEstimation, RefusesParametersOutOfRange)
{
  const auto cloud = boxCloud(10, 12);
  const auto refuses = [&](auto change) {
    Estimation estimation;
    estimation.setInputCloud(cloud);
    estimation.setInputNormals(cloud);
    change(estimation);
    expectRefused(estimation);
  };
  refuses([](auto& e) { e.setPairCount(0); });
  refuses([](auto& e) { e.setScale(-1.0); });
  refuses([](auto& e) { e.setScale(std::nan("")); });
  refuses([](auto& e) { e.setWeightingConstant(1.0); });
  refuses([](auto& e) { e.setGridSize(65); });
  refuses([](auto& e) { e.setBins({20, 10, 6, 2}); }); // 2,400 bins
}

TEST(EPPFEstimation, SettersAreKept)
{
  Estimation estimation;
  estimation.setPairCount(17);
  estimation.setBins({10, 6, 5, 4});
  estimation.setScale(2.5);
  estimation.setSeed(4);
  estimation.setNumberOfThreads(3);
  estimation.setWeightingConstant(1.5);
  estimation.setSurfaceAngleRule(pcl::indoor::SurfaceAngleRule::Mean);
  estimation.setNormalSides(pcl::indoor::NormalSides::Given);
  estimation.setPairSampling(pcl::indoor::PairSampling::Uniform);
  estimation.setFeatures({true, false, true, false});
  estimation.setGridSize(32);
  EXPECT_EQ(estimation.getPairCount(), 17u);
  EXPECT_EQ(estimation.getBins().surface_angle, 6);
  EXPECT_EQ(estimation.getScale(), 2.5);
  EXPECT_EQ(estimation.getSeed(), 4u);
  EXPECT_EQ(estimation.getNumberOfThreads(), 3u);
  EXPECT_EQ(estimation.getWeightingConstant(), 1.5);
  EXPECT_EQ(estimation.getSurfaceAngleRule(), pcl::indoor::SurfaceAngleRule::Mean);
  EXPECT_EQ(estimation.getNormalSides(), pcl::indoor::NormalSides::Given);
  EXPECT_EQ(estimation.getPairSampling(), pcl::indoor::PairSampling::Uniform);
  EXPECT_FALSE(estimation.getFeatures().surface_angle);
  EXPECT_EQ(estimation.getGridSize(), 32);
  const auto options = estimation.getOptions();
  Estimation other;
  other.setOptions(options);
  EXPECT_EQ(other.getScale(), 2.5);
}

TEST(PairHarmonicsSignature1200, SurvivesAPCDFile)
{
  Descriptors written = describe(boxCloud(500, 13));
  written.push_back(describe(boxCloud(500, 14))[0]);
  const std::string path = testing::TempDir() + "pair_harmonics.pcd";
  for (const bool binary : {false, true}) {
    ASSERT_EQ(pcl::io::savePCDFile(path, written, binary), 0);
    Descriptors read;
    ASSERT_EQ(pcl::io::loadPCDFile(path, read), 0);
    ASSERT_EQ(read.size(), 2u);
    for (int bin = 0; bin < 1200; ++bin) // text keeps 8 digits
      EXPECT_NEAR(
          read[1].histogram[bin], written[1].histogram[bin], binary ? 0.0 : 1e-8);
  }
  std::remove(path.c_str());
}

TEST(PairHarmonicsSignature1200, KdTreeSeesAllBins)
{
  auto cloud = pcl::make_shared<Descriptors>();
  for (int k = 0; k < 50; ++k) {
    cloud->emplace_back();
    cloud->back().histogram[1199 - k] = 1.0f; // the first three bins are all alike
  }
  pcl::KdTreeFLANN<Signature> tree;
  tree.setInputCloud(cloud);
  for (int k = 0; k < 50; ++k) {
    auto query = (*cloud)[k];
    query.histogram[0] = 0.25f;
    pcl::Indices indices(1);
    std::vector<float> distances(1);
    ASSERT_EQ(tree.nearestKSearch(query, 1, indices, distances), 1);
    EXPECT_EQ(indices[0], k);
    EXPECT_FLOAT_EQ(distances[0], 0.0625f);
  }
}

} // namespace
