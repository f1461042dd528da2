/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// fuzz_classes AMOUNT [SEED]: gives the classes random clouds and random values of
// their setters; the amount is of seconds for all, or of clouds for each ("500x"). They
// may refuse them, but not throw or crash. What was tried last stands in fuzz_class.txt
#include "amount.h"
#include "mutation.h" // for Random

#include <pcl/console/print.h>
#include <pcl/features/eppf.h>
#include <pcl/features/hough_normals.h>
#include <pcl/features/multi_scale_normals.h>
#include <pcl/filters/non_convex_points_removal.h>
#include <pcl/filters/scan_outlier_removal.h>
#include <pcl/segmentation/noise_resilient_lccp.h>
#include <pcl/segmentation/room_segmentation.h>

#include <unistd.h> // for alarm

#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>

using namespace pcl::indoor::fuzz;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;

namespace {

constexpr unsigned most_seconds = 60; // for one cloud; then the alarm ends the program

/** Between -1 and 1. */
float
symmetric(Random& random)
{
  return static_cast<float>(random()) / 2147483648.0f - 1.0f;
}

/** A number as it should be, mostly; else one that nobody expects. */
double
anyNumber(Random& random, double usual)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double odd[] = {
      0, -1, 1e-300, 1e-9, 0.02, 1, 10, 1e9, 1e300, infinity, -infinity, NAN};
  if (below(random, 3) > 0)
    return usual * (1 + 0.5 * static_cast<double>(symmetric(random)));
  return odd[below(random, std::size(odd))];
}

std::size_t
anyCount(Random& random, std::size_t usual)
{
  constexpr std::size_t odd[] = {0, 1, 2, 3, 64, 1000};
  return below(random, 3) > 0 ? usual : odd[below(random, std::size(odd))];
}

/** Points in a box, on a plane, line, sphere or at one place, of any size and anywhere,
 * some not finite or far away. */
Cloud::Ptr
randomCloud(Random& random)
{
  const auto cloud = pcl::make_shared<Cloud>();
  const std::size_t shape = below(random, 5), count = below(random, 300);
  constexpr float scales[] = {1e-42f, 1e-20f, 1e-6f, 0.1f, 1, 3, 10, 1e4f, 1e9f, 1e38f};
  constexpr float places[] = {0, 0, 0, 100, 5e6f, 1e9f, 1e20f};
  const bool usual = below(random, 2) > 0;
  const float scale = usual ? 3 : scales[below(random, std::size(scales))];
  const float place = usual ? 0 : places[below(random, std::size(places))];
  const bool damaged = below(random, 4) == 0;
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::Vector3f p(symmetric(random), symmetric(random), symmetric(random));
    if (shape > 0)
      p.z() = 0;
    if (shape > 1)
      p.y() = 0;
    if (shape > 2)
      p.setZero();
    if (shape == 4)
      p = Eigen::Vector3f(symmetric(random), symmetric(random), symmetric(random))
              .normalized();
    p = (scale * p).array() + place;
    constexpr float odd[] = {NAN, INFINITY, -3e38f, 1e20f, 1e-40f};
    if (damaged && below(random, 10) == 0)
      p[static_cast<int>(below(random, 3))] = odd[below(random, std::size(odd))];
    cloud->emplace_back(p.x(), p.y(), p.z());
  }
  cloud->is_dense = !damaged;
  if (count > 0 && count % 2 == 0 && below(random, 4) == 0) {
    cloud->height = 2;
    cloud->width = static_cast<std::uint32_t>(count / 2);
  }
  return cloud;
}

Normals::Ptr
randomNormals(Random& random, std::size_t count)
{
  const auto normals = pcl::make_shared<Normals>();
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3f n(symmetric(random), symmetric(random), symmetric(random));
    const bool odd = below(random, 20) == 0;
    const Eigen::Vector3f unit =
        odd ? Eigen::Vector3f(n * (below(random, 2) > 0 ? NAN : 0)) : n.normalized();
    normals->emplace_back(unit.x(), unit.y(), unit.z());
    normals->back().curvature = odd ? NAN : std::abs(symmetric(random)) / 3;
  }
  if (below(random, 20) == 0)
    normals->clear();
  return normals;
}

/** Sets the cloud, sometimes also indices, of which some may be outside of it. */
template <typename Class>
void
setInput(Class& object, const Cloud::ConstPtr& cloud, Random& random)
{
  if (below(random, 50) > 0)
    object.setInputCloud(cloud);
  if (below(random, 4) > 0)
    return;
  const auto indices = pcl::make_shared<pcl::Indices>();
  for (std::size_t i = below(random, 100); i > 0; --i)
    indices->push_back(static_cast<int>(below(random, cloud->size())));
  if (below(random, 10) == 0)
    indices->push_back(below(random, 2) > 0 ? -1 : 1000000);
  object.setIndices(indices);
}

void
tryRooms(const Cloud::Ptr& cloud, Random& random)
{
  pcl::RoomSegmentation<pcl::PointXYZ> rooms;
  setInput(rooms, cloud, random);
  rooms.setVoxelSize(anyNumber(random, 0.1));
  rooms.setMinRoomArea(anyNumber(random, 0.5));
  rooms.setMinRoomWidth(anyNumber(random, 0.5));
  rooms.setPersistence(anyNumber(random, 0.3));
  rooms.setMetresPerUnit(anyNumber(random, 1));
  rooms.setMethod(below(random, 2) > 0 ? pcl::indoor::RoomMethod::CeilingSlab
                                       : pcl::indoor::RoomMethod::PotentialField);
  std::vector<std::uint32_t> labels;
  rooms.segment(labels);
}

void
tryObjects(const Cloud::Ptr& cloud, Random& random)
{
  pcl::NoiseResilientLCCP<pcl::PointXYZ> objects;
  setInput(objects, cloud, random);
  if (below(random, 3) == 0)
    objects.setInputNormals(randomNormals(random, cloud->size()));
  objects.setVoxelResolution(anyNumber(random, 0.03));
  objects.setSeedResolution(anyNumber(random, 0.12));
  objects.setGraphScale(static_cast<float>(anyNumber(random, 1)));
  objects.setJoiningLevel(static_cast<float>(anyNumber(random, 0.5)));
  objects.setViewPoint(anyNumber(random, 1), anyNumber(random, 1), 0);
  std::vector<std::uint32_t> labels;
  objects.segment(labels);
}

void
tryHough(const Cloud::Ptr& cloud, Random& random)
{
  pcl::HoughNormalEstimation<pcl::PointXYZ> hough;
  setInput(hough, cloud, random);
  if (below(random, 2) > 0)
    hough.setRadiusSearch(anyNumber(random, 0.5));
  else
    hough.setKSearch(static_cast<int>(anyCount(random, 10)));
  hough.setBinAngle(anyNumber(random, 12));
  hough.setNumberOfTriples(static_cast<unsigned>(anyCount(random, 100)));
  hough.setOrientation(static_cast<pcl::indoor::NormalOrientation>(below(random, 3)));
  Normals normals;
  hough.compute(normals);
}

void
tryMultiScale(const Cloud::Ptr& cloud, Random& random)
{
  pcl::indoor::MultiScaleNormalOptions options;
  options.radius = below(random, 2) > 0 ? 0 : anyNumber(random, 0.5);
  options.scales = static_cast<unsigned>(anyCount(random, 4));
  try {
    pcl::indoor::multiScaleNormals(*cloud, options);
  } catch (const pcl::BadArgumentException&) { // as it says
  }
}

template <typename Descriptor>
void
tryDescriptor(const Cloud::Ptr& cloud, Random& random)
{
  pcl::EPPFEstimation<pcl::PointXYZ, pcl::Normal, Descriptor> eppf;
  setInput(eppf, cloud, random);
  eppf.setInputNormals(randomNormals(random, cloud->size()));
  eppf.setPairCount(anyCount(random, 500));
  eppf.setScale(below(random, 2) > 0 ? 0 : anyNumber(random, 1));
  eppf.setDenoising(below(random, 2) > 0);
  eppf.setPairSampling(below(random, 2) > 0 ? pcl::indoor::PairSampling::Uniform
                                            : pcl::indoor::PairSampling::Stratified);
  pcl::PointCloud<Descriptor> descriptor;
  eppf.compute(descriptor);
}

void
tryNonConvex(const Cloud::Ptr& cloud, Random& random)
{
  pcl::NonConvexPointsRemoval<pcl::PointXYZ, pcl::Normal> removal(below(random, 2) > 0);
  setInput(removal, cloud, random);
  removal.setInputNormals(randomNormals(random, cloud->size()));
  removal.setRadius(anyNumber(random, 0.5));
  removal.setCurvatureThreshold(static_cast<float>(anyNumber(random, 0.03)));
  Cloud output;
  removal.filter(output);
}

void
tryOutliers(const Cloud::Ptr& cloud, Random& random)
{
  pcl::ScanOutlierRemoval<pcl::PointXYZ> removal(below(random, 2) > 0);
  setInput(removal, cloud, random);
  removal.setRadiusSearch(anyNumber(random, 0.5));
  removal.setMeanK(static_cast<int>(anyCount(random, 8)));
  removal.setMinNeighborsInRadius(static_cast<int>(anyCount(random, 2)));
  removal.setStddevMulThresh(anyNumber(random, 2));
  Cloud output;
  removal.filter(output);
}

struct Target {
  const char* name;
  std::function<void(const Cloud::Ptr&, Random&)> run;
};

void
fuzzOne(const Target& target, const Amount& amount, unsigned seed)
{
  const auto now = std::chrono::steady_clock::now;
  const auto begin = now();
  std::chrono::duration<double> passed(0);
  std::size_t count = 0;
  for (; amount.wantsMore(count, passed.count()); ++count, passed = now() - begin) {
    const auto own_seed = seed + static_cast<unsigned>(count);
    if (std::FILE* note = std::fopen("fuzz_class.txt", "w")) {
      std::fprintf(note, "fuzz_classes 1x %u %s\n", own_seed, target.name);
      std::fclose(note);
    }
    alarm(most_seconds);
    Random random(own_seed);
    const auto cloud = randomCloud(random);
    target.run(cloud, random);
  }
  alarm(0);
  std::remove("fuzz_class.txt");
  std::printf("%-10s %7zu clouds, %5.0f per second\n",
              target.name,
              count,
              static_cast<double>(count) / passed.count());
  std::fflush(stdout);
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc < 2) {
    std::printf("Syntax is: fuzz_classes AMOUNT [SEED [CLASS]]\n");
    return 1;
  }
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  const std::vector<Target> targets = {
      {"rooms", tryRooms},
      {"objects", tryObjects},
      {"hough", tryHough},
      {"multi_scale", tryMultiScale},
      {"eppf", tryDescriptor<pcl::EPPFSignature1200>},
      {"harmonics", tryDescriptor<pcl::PairHarmonicsSignature1200>},
      {"nonconvex", tryNonConvex},
      {"outliers", tryOutliers}};
  const auto amount = Amount::parse(argv[1], targets.size());
  for (const auto& target : targets)
    if (argc < 4 || target.name == std::string(argv[3]))
      fuzzOne(
          target, amount, argc > 2 ? static_cast<unsigned>(std::stoul(argv[2])) : 1u);
  return 0;
}
