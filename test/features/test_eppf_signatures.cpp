/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "features/eppf_clouds.h"

#include <pcl/features/impl/oriented_points.hpp>
#include <pcl/io/pcd_io.h>
#include <pcl/kdtree/impl/kdtree_flann.hpp>

#include <gtest/gtest.h>

#include <cstdio>
#include <numeric>
#include <vector>

using namespace pcl::indoor::test;

namespace {

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

} // namespace
