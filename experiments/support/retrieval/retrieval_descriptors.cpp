/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "retrieval/retrieval_descriptors.h"

#include "objects/object_files.h"

#include <pcl/features/eppf.h>
#include <pcl/features/esf.h>
#include <pcl/features/gasd.h>
#include <pcl/features/grsd.h>
#include <pcl/features/our_cvfh.h>
#include <pcl/features/shot.h>
#include <pcl/features/surflet_pair.h>
#include <pcl/features/vfh.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cmath>

namespace pcl::indoor::tool {
namespace {

/** \brief The histogram of the first signature; empty if there is none. */
template <typename SignatureT, typename Estimation>
std::vector<float>
firstHistogram(Estimation& estimation)
{
  PointCloud<SignatureT> signatures;
  estimation.compute(signatures);
  if (signatures.empty())
    return {};
  const auto& histogram = signatures[0].histogram;
  return {std::begin(histogram), std::end(histogram)};
}

template <typename Estimation>
void
setOrientedInput(Estimation& estimation, const RetrievalObject& object)
{
  estimation.setInputCloud(object.points);
  estimation.setInputNormals(object.normals);
  estimation.setSearchMethod(pcl::make_shared<search::KdTree<PointXYZ>>());
}

/** \brief Distances below this join two points of a surface sampled with that many. */
float
sampleSpacing(const RetrievalObject& object)
{
  // A unit object has a surface of about 3, so n samples are about sqrt(3 / n) apart.
  OrientedPoint point;
  std::vector<OrientedPoint> points;
  for (const auto& p : *object.points) {
    point.position = p.getVector3fMap();
    points.push_back(point);
  }
  return objectExtent(points) * std::sqrt(3.0f / static_cast<float>(points.size()));
}

std::vector<float>
describeByESF(const RetrievalObject& object, std::uint32_t)
{
  ESFEstimation<PointXYZ, ESFSignature640> estimation; // seeds itself from the clock
  estimation.setInputCloud(object.points);
  return firstHistogram<ESFSignature640>(estimation);
}

std::vector<float>
describeByVFH(const RetrievalObject& object, std::uint32_t)
{
  VFHEstimation<PointXYZ, Normal, VFHSignature308> estimation;
  setOrientedInput(estimation, object);
  return firstHistogram<VFHSignature308>(estimation);
}

std::vector<float>
describeByOURCVFH(const RetrievalObject& object, std::uint32_t)
{
  // Its defaults are lengths of table-top scenes in metres; these follow the object.
  const float spacing = sampleSpacing(object);
  OURCVFHEstimation<PointXYZ, Normal, VFHSignature308> estimation;
  setOrientedInput(estimation, object);
  estimation.setRadiusNormals(3 * spacing);
  estimation.setClusterTolerance(3 * spacing);
  return firstHistogram<VFHSignature308>(estimation);
}

std::vector<float>
describeByGASD(const RetrievalObject& object, std::uint32_t)
{
  GASDEstimation<PointXYZ, GASDSignature512> estimation;
  estimation.setInputCloud(object.points);
  return firstHistogram<GASDSignature512>(estimation);
}

std::vector<float>
describeByGRSD(const RetrievalObject& object, std::uint32_t)
{
  GRSDEstimation<PointXYZ, Normal, GRSDSignature21> estimation;
  setOrientedInput(estimation, object);
  estimation.setRadiusSearch(3 * sampleSpacing(object)); // its voxels, not smaller
  return firstHistogram<GRSDSignature21>(estimation);
}

/** SHOT of the whole object: at its centroid, with a radius that holds it. */
std::vector<float>
describeBySHOT(const RetrievalObject& object, std::uint32_t)
{
  if (object.points->empty())
    return {};
  Eigen::Vector3f centroid = Eigen::Vector3f::Zero();
  for (const auto& point : *object.points)
    centroid += point.getVector3fMap() / static_cast<float>(object.points->size());
  float radius = 0;
  for (const auto& point : *object.points)
    radius = std::max(radius, (point.getVector3fMap() - centroid).norm());
  const auto middle = pcl::make_shared<PointCloud<PointXYZ>>();
  middle->push_back({centroid.x(), centroid.y(), centroid.z()});
  SHOTEstimation<PointXYZ, Normal, SHOT352> estimation;
  estimation.setInputCloud(middle);
  estimation.setSearchSurface(object.points);
  estimation.setInputNormals(object.normals);
  estimation.setSearchMethod(pcl::make_shared<search::KdTree<PointXYZ>>());
  estimation.setRadiusSearch(1.01 * radius);
  PointCloud<SHOT352> output;
  estimation.compute(output);
  if (output.empty())
    return {};
  return {std::begin(output[0].descriptor), std::end(output[0].descriptor)};
}

} // namespace

RetrievalObject
makeRetrievalObject(const PointCloud<PointNormal>& surface, int neighbor_count)
{
  RetrievalObject object{pcl::make_shared<PointCloud<PointNormal>>(),
                         pcl::make_shared<PointCloud<PointXYZ>>(),
                         pcl::make_shared<PointCloud<Normal>>()};
  for (const auto& point : surface)
    if (point.getVector3fMap().allFinite() && point.getNormalVector3fMap().allFinite())
      object.surface->push_back(point);
  const auto& kept = *object.surface;
  const bool has_curvature =
      std::any_of(kept.begin(), kept.end(), [](const auto& point) {
        return point.curvature > 0.0f;
      });
  auto curved = kept;
  if (!has_curvature && !kept.empty())
    estimateNormals(curved, neighbor_count);
  for (std::size_t k = 0; k < kept.size(); ++k) {
    object.points->push_back({kept[k].x, kept[k].y, kept[k].z});
    object.normals->push_back(
        {kept[k].normal_x, kept[k].normal_y, kept[k].normal_z, curved[k].curvature});
  }
  return object;
}

RetrievalDescriptor
eppfDescriptor(const std::string& name, const EPPFOptions& options)
{
  const auto describe = [options](const RetrievalObject& object, std::uint32_t seed) {
    auto seeded = options;
    seeded.seed += seed;
    return eppfHistogram(classifierPoints(*object.surface), seeded);
  };
  return {name, true, false, describe};
}

RetrievalDescriptor
surfletPairDescriptor(int bin_count)
{
  const auto describe = [bin_count](const RetrievalObject& object, std::uint32_t seed) {
    SurfletPairOptions options;
    options.bin_count = bin_count;
    options.seed += seed;
    return surfletPairHistogram(classifierPoints(*object.surface), options);
  };
  return {bin_count == 5 ? "wahl" : "wahl_" + std::to_string(bin_count),
          true,
          false,
          describe};
}

std::vector<RetrievalDescriptor>
peerDescriptors()
{
  return {{"esf", true, false, describeByESF},
          {"vfh", false, false, describeByVFH},
          {"our_cvfh", false, true, describeByOURCVFH},
          {"gasd", false, false, describeByGASD},
          {"grsd", false, true, describeByGRSD},
          {"shot", false, true, describeBySHOT}};
}

} // namespace pcl::indoor::tool
