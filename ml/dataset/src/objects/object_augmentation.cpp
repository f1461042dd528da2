/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/object_augmentation.h"

#include "files/random_numbers.h"
#include "objects/object_files.h"

#include <pcl/common/io.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace pcl::indoor::tool {
namespace {

/** \brief How much of a change is made: 0 but for its share of the calls. */
double
amount(std::mt19937& rng, double share, double most)
{
  const bool is_made = uniform(rng) < share;
  const double part = uniform(rng); // drawn in any case, as all else follows from it
  return is_made ? part * most : 0.0;
}

/** \brief Turn about z and stretch along the turned axes; normals stay upright on the
 * surface. */
void
turnAndStretch(PointCloud<PointNormal>& cloud, double stretch, std::mt19937& rng)
{
  const double angle = 2.0 * M_PI * uniform(rng);
  Eigen::Vector3d factors;
  for (int axis = 0; axis < 3; ++axis)
    factors[axis] = 1.0 + stretch * (2.0 * uniform(rng) - 1.0);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::Matrix3f points = (turn * factors.asDiagonal()).cast<float>();
  const Eigen::Matrix3f normals =
      (turn * factors.cwiseInverse().asDiagonal()).cast<float>();
  for (auto& point : cloud) {
    point.getVector3fMap() = (points * point.getVector3fMap()).eval();
    point.getNormalVector3fMap() =
        (normals * point.getNormalVector3fMap()).normalized().eval();
  }
}

/** \brief Keep a random share of the points, in their order. */
void
thinOut(PointCloud<PointNormal>& cloud, double percent, std::mt19937& rng)
{
  const auto kept = static_cast<std::size_t>(
      std::lround(static_cast<double>(cloud.size()) * (1.0 - percent / 100.0)));
  Indices order(cloud.size());
  std::iota(order.begin(), order.end(), 0);
  drawToFront(order, kept, rng);
  order.resize(kept);
  std::sort(order.begin(), order.end());
  PointCloud<PointNormal> rest;
  copyPointCloud(cloud, order, rest);
  cloud = rest;
}

/** \brief A seed of its own for each draw of each object. */
std::uint32_t
seedOf(std::uint32_t seed, std::size_t number, int draw)
{
  std::seed_seq sequence{
      seed, static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(draw)};
  std::vector<std::uint32_t> mixed(1);
  sequence.generate(mixed.begin(), mixed.end());
  return mixed[0];
}

/** \brief Disturb a draw; where only points are looked at, normals are left alone. */
void
disturbDraw(PointCloud<PointNormal>& object,
            const DrawOptions& options,
            std::uint32_t seed)
{
  auto disturbance = options.disturbance;
  disturbance.keeps_normals = options.input.kind == ClassifierInputKind::Points;
  disturb(object, disturbance, options.neighbor_count, seed);
}

} // namespace

ObjectAugmentation
mildAugmentation()
{
  ObjectAugmentation augmentation;
  augmentation.thinned_share = 0.5;
  augmentation.thinned_percent = 75.0;
  augmentation.stretched_share = 1.0;
  augmentation.stretch_percent = 15.0;
  return augmentation;
}

ObjectAugmentation
scanAugmentation()
{
  auto augmentation = mildAugmentation();
  augmentation.noisy_share = 0.25;
  augmentation.noise_percent = 4.0;
  augmentation.hidden_share = 0.25;
  augmentation.hidden_percent = 60.0;
  return augmentation;
}

PointCloud<PointNormal>
augmentedObject(const PointCloud<PointNormal>& cloud,
                const ObjectAugmentation& augmentation,
                int neighbor_count,
                std::uint32_t seed)
{
  std::mt19937 rng(seed);
  auto object = cloud;
  const double stretch =
      amount(rng, augmentation.stretched_share, augmentation.stretch_percent / 100.0);
  turnAndStretch(object, stretch, rng);
  Disturbance disturbance;
  disturbance.hidden_percent =
      amount(rng, augmentation.hidden_share, augmentation.hidden_percent);
  disturbance.noise_percent =
      amount(rng, augmentation.noisy_share, augmentation.noise_percent);
  const double thinned =
      amount(rng, augmentation.thinned_share, augmentation.thinned_percent);
  if (thinned > 0.0)
    thinOut(object, thinned, rng);
  disturb(object, disturbance, neighbor_count, rng());
  return object;
}

PointCloud<PointNormal>
firstDrawnObject(const PointCloud<PointNormal>& cloud,
                 const DrawOptions& options,
                 std::size_t number)
{
  auto object = cloud;
  disturbDraw(object, options, seedOf(options.seed, number, 0));
  return object;
}

std::vector<std::vector<float>>
drawsOf(const PointCloud<PointNormal>& cloud,
        const ObjectPlace& place,
        const DrawOptions& options,
        std::size_t number)
{
  std::vector<std::vector<float>> draws;
  for (int draw = 0; draw < options.draw_count; ++draw) {
    const auto seed = seedOf(options.seed, number, draw);
    auto object = draw == 0
                      ? firstDrawnObject(cloud, options, number)
                      : augmentedObject(
                            cloud, options.augmentation, options.neighbor_count, seed);
    if (draw > 0)
      disturbDraw(object, options, seed);
    auto input = classifierInput(classifierPoints(object), place, options.input, seed);
    const bool is_good = std::all_of(
        input.begin(), input.end(), [](float value) { return std::isfinite(value); });
    if (draw == 0 && !is_good)
      return {};
    draws.push_back(is_good ? std::move(input) : draws.front());
  }
  return draws;
}

} // namespace pcl::indoor::tool
