/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// What changes of the cloud do to descriptors of pairs, over random boxes: of all
// outputs of EPPFEstimation and SurfletPairEstimation.
#include "support/cloud_changes.h"

#include <pcl/features/eppf.h>
#include <pcl/features/surflet_pair.h>
#include <pcl/point_types.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <set>

#include "features/oriented_shapes.h"

using namespace pcl::indoor;
using namespace pcl::indoor::test;

namespace {

constexpr unsigned random_objects = 4;
using Objects = pcl::PointCloud<pcl::PointNormal>;
using OrientedPoints = std::vector<OrientedPoint>;

template <typename Estimation, typename SignatureT>
struct Kind {
  using Estimator = Estimation;
  using Signature = SignatureT;
};

template <typename SignatureT>
using Eppf = Kind<pcl::EPPFEstimation<pcl::PointNormal, pcl::PointNormal, SignatureT>,
                  SignatureT>;
template <typename SignatureT>
using Surflet =
    Kind<pcl::SurfletPairEstimation<pcl::PointNormal, pcl::PointNormal, SignatureT>,
         SignatureT>;

template <typename KindT>
class PairFeatureProperties : public testing::Test {
protected:
  using Estimator = typename KindT::Estimator;
  using Signature = typename KindT::Signature;

  static std::vector<float>
  described(Estimator& estimation, const OrientedPoints& points)
  {
    const auto cloud = pcl::make_shared<Objects>();
    for (const auto& point : points) {
      cloud->emplace_back();
      cloud->back().getVector3fMap() = point.position;
      cloud->back().getNormalVector3fMap() = point.normal;
    }
    cloud->is_dense = false;
    estimation.setInputCloud(cloud);
    estimation.setInputNormals(cloud);
    pcl::PointCloud<Signature> output;
    estimation.compute(output);
    EXPECT_EQ(output.size(), 1u);
    return output.empty() ? std::vector<float>()
                          : std::vector<float>(std::begin(output[0].histogram),
                                               std::end(output[0].histogram));
  }

  static std::vector<float>
  described(const OrientedPoints& points)
  {
    Estimator estimation;
    return described(estimation, points);
  }

  /** Of two descriptors, 0 for equal ones to 2. */
  static double
  difference(const std::vector<float>& a, const std::vector<float>& b)
  {
    double sum = 0;
    for (std::size_t bin = 0; bin < a.size(); ++bin)
      sum += std::abs(a[bin] - b[bin]);
    return sum;
  }
};

OrientedPoints
randomObject(unsigned seed)
{
  std::mt19937 rng(seed);
  return boxSurface(
      {drawn(0.4f, 1.0f, rng), drawn(0.3f, 0.7f, rng), drawn(0.2f, 0.5f, rng)},
      1500,
      seed);
}

OrientedPoints
turned(OrientedPoints points, float radians)
{
  const Eigen::Matrix3f turn =
      Eigen::AngleAxisf(radians, Eigen::Vector3f::UnitZ()).toRotationMatrix();
  for (auto& point : points) {
    point.position = turn * point.position;
    point.normal = turn * point.normal;
  }
  return points;
}

using Kinds = testing::Types<Eppf<pcl::EPPFSignature1200>,
                             Eppf<pcl::EPPFSignature540>,
                             Eppf<pcl::PairHarmonicsSignature1200>,
                             Surflet<pcl::SurfletPairSignature625>,
                             Surflet<pcl::SurfletPairSignature1296>>;

} // namespace

TYPED_TEST_SUITE(PairFeatureProperties, Kinds);

TYPED_TEST(PairFeatureProperties, AnyNumberOfThreadsGivesTheSameBits)
{
  for (unsigned seed = 0; seed < random_objects; ++seed) {
    typename TestFixture::Estimator estimation;
    estimation.setNumberOfThreads(1);
    const auto one = this->described(estimation, randomObject(seed));
    for (const unsigned threads : {2u, 7u}) {
      estimation.setNumberOfThreads(threads);
      EXPECT_EQ(this->described(estimation, randomObject(seed)), one) << threads;
    }
  }
}

TYPED_TEST(PairFeatureProperties, BadPointsChangeNoBit)
{
  for (unsigned seed = 0; seed < random_objects; ++seed) {
    const auto points = randomObject(seed);
    std::mt19937 rng(seed);
    const float bad[] = {NAN, INFINITY, -INFINITY, 1e20f};
    OrientedPoints with_bad;
    for (const auto& point : points) {
      if (rng() % 4 == 0) {
        with_bad.push_back(point);
        with_bad.back().position[static_cast<int>(rng() % 3)] = bad[rng() % 4];
      }
      with_bad.push_back(point);
    }
    EXPECT_EQ(this->described(with_bad), this->described(points)) << seed;
  }
}

TYPED_TEST(PairFeatureProperties, IndicesAreTheirPointsAlone)
{
  for (unsigned seed = 0; seed < random_objects; ++seed) {
    const auto points = randomObject(seed);
    std::mt19937 rng(seed);
    const auto subset = randomSubset(points.size(), rng);
    typename TestFixture::Estimator estimation;
    estimation.setIndices(pcl::make_shared<pcl::Indices>(subset.begin(), subset.end()));
    EXPECT_EQ(this->described(estimation, points),
              this->described(inOrder(points, subset)))
        << seed;
  }
}

TYPED_TEST(PairFeatureProperties, ShiftsThatFloatsHoldChangeNoBit)
{
  for (unsigned seed = 0; seed < random_objects; ++seed) {
    auto points = randomObject(seed);
    for (auto& point : points)
      point.position = (256 * point.position.array()).round() / 256;
    auto far = points;
    for (auto& point : far)
      point.position += Eigen::Vector3f(16384, -8192, 512);
    EXPECT_EQ(this->described(far), this->described(points)) << seed;
  }
}

TYPED_TEST(PairFeatureProperties, UtmCoordinatesAsFloatsAreTheirPointsNearTheOrigin)
{
  for (unsigned seed = 0; seed < random_objects; ++seed) {
    auto near = randomObject(seed);
    std::vector<Eigen::Vector3f> positions;
    for (const auto& point : near)
      positions.push_back(10 * point.position); // several of the steps of UTM
    const UtmPoints utm(positions);
    auto far = near;
    for (std::size_t i = 0; i < near.size(); ++i) {
      near[i].position = utm.near[i];
      far[i].position = utm.far[i];
    }
    const auto bits = this->described(near);
    EXPECT_GT(std::set<float>(bits.begin(), bits.end()).size(), 10u) << seed;
    EXPECT_EQ(this->described(far), bits) << seed;
  }
}

TYPED_TEST(PairFeatureProperties, OrderCopiesAndTurnsChangeLittleBesideOtherShapes)
{
  for (unsigned seed = 0; seed < random_objects; ++seed) {
    const auto points = randomObject(seed);
    const auto original = this->described(points);
    // Other pairs are drawn, and voxels of the occupancy do not turn with the object.
    const double other_shape =
        this->difference(original, this->described(boxSurface({1, 1, 1}, 1500, seed)));
    std::mt19937 rng(seed);
    const auto order = shuffledOrder(points.size(), rng);
    const auto copies = withCopies(points.size());
    EXPECT_LT(2 * this->difference(original, this->described(inOrder(points, order))),
              other_shape)
        << seed << ", order";
    EXPECT_LT(2 * this->difference(original, this->described(inOrder(points, copies))),
              other_shape)
        << seed << ", copies";
    for (const float radians : {0.3f, 1.5707963f, 4.0f})
      EXPECT_LT(
          2 * this->difference(original, this->described(turned(points, radians))),
          other_shape)
          << seed << ", turned by " << radians;
  }
}
