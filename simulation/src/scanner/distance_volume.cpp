/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "scanner/distance_volume.h"

#include <pcl/indoor/parallel_for.h>

#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

namespace {

constexpr std::size_t most_blocks = 250000; // 2 GB of voxels

/** 21 bits for each number of a block: a million blocks to each side. */
std::uint64_t
keyOf(const Eigen::Vector3i& block)
{
  std::uint64_t key = 0;
  for (int k = 0; k < 3; ++k)
    key = key << 21 | (static_cast<std::uint64_t>(block[k] + (1 << 20)) & 0x1FFFFF);
  return key;
}

int
indexOf(const Eigen::Vector3i& voxel, int side)
{
  return (voxel.z() * side + voxel.y()) * side + voxel.x();
}

} // namespace

/** A view: where places of the building are in the image. */
class DistanceVolume::Projection {
public:
  Projection(const CameraFrame& frame, const DepthCameraOptions& camera)
  : position(frame.position)
  , axes(frame.axes)
  , options(camera)
  {}

  Eigen::Vector3d
  toCamera(const Eigen::Vector3d& place) const
  {
    return axes.transpose() * (place - position);
  }

  /** Number of the pixel that sees a place of the camera's frame, or -1. */
  int
  pixelOf(const Eigen::Vector3d& at) const
  {
    const double scale = options.focal_length / at.z();
    const double u = std::floor(at.x() * scale + 0.5 * options.width);
    const double v = std::floor(at.y() * scale + 0.5 * options.height);
    if (u < 0 || v < 0 || u >= options.width || v >= options.height)
      return -1;
    return static_cast<int>(v) * options.width + static_cast<int>(u);
  }

  /** False only if nothing within a radius of a place can be in the image. */
  bool
  maySee(const Eigen::Vector3d& place, double radius) const
  {
    const Eigen::Vector3d at = toCamera(place);
    if (at.z() < -radius || at.z() > options.max_range + radius)
      return false;
    const double z = std::max(at.z(), 0.0) + radius;
    const double wide = 0.5 * options.width / options.focal_length,
                 high = 0.5 * options.height / options.focal_length;
    return std::abs(at.x()) < wide * z + 2 * radius &&
           std::abs(at.y()) < high * z + 2 * radius;
  }

  Eigen::Vector3d position;
  Eigen::Matrix3d axes;
  const DepthCameraOptions& options;
};

DistanceVolume::DistanceVolume(double voxel_size, int threads)
: voxel_size_(voxel_size)
, truncation_(4 * voxel_size)
, threads_(threads)
{}

void
DistanceVolume::addBlock(const Eigen::Vector3i& place)
{
  const auto key = keyOf(place);
  if (number_of_block_.count(key) > 0)
    return;
  if (blocks_.size() >= most_blocks)
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "voxels of " << voxel_size_
                                     << " m are too small for what is seen: more than "
                                        "2 GB would be needed");
  number_of_block_.emplace(key, static_cast<std::uint32_t>(blocks_.size()));
  blocks_.push_back(std::make_unique<Block>());
  blocks_.back()->place = place;
}

void
DistanceVolume::addBlocksAlong(const std::vector<DepthPixel>& pixels,
                               const Projection& projection)
{
  const auto& camera = projection.options;
  const double block_size = side * voxel_size_, step = block_size / 2;
  Eigen::Vector3i last = Eigen::Vector3i::Constant(1 << 30);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const double depth = pixels[i].depth;
    if (depth == 0)
      continue;
    const Eigen::Vector3d ray =
        projection.axes * rayThrough(static_cast<double>(i % camera.width),
                                     static_cast<double>(i / camera.width),
                                     camera);
    for (double z = depth - truncation_; z < depth + truncation_ + step; z += step) {
      const double end = std::min(z, depth + truncation_);
      const Eigen::Vector3i place =
          ((projection.position + end * ray) / block_size).array().floor().cast<int>();
      if (place != last)
        addBlock(place);
      last = place;
    }
  }
}

void
DistanceVolume::update(Block& block,
                       const std::vector<DepthPixel>& pixels,
                       const Projection& projection) const
{
  const double voting = 1.5 * voxel_size_; // both ends of an edge with a vertex vote
  const Eigen::Vector3d corner =
      projection.toCamera(voxel_size_ * (side * block.place).cast<double>());
  const Eigen::Matrix3d steps = voxel_size_ * projection.axes.transpose();
  int i = 0;
  for (int z = 0; z < side; ++z)
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x, ++i) {
        const Eigen::Vector3d at = corner + steps * Eigen::Vector3d(x, y, z);
        const int pixel = at.z() > 0 ? projection.pixelOf(at) : -1;
        if (pixel < 0 || pixels[pixel].depth == 0)
          continue;
        const double depth = pixels[pixel].depth, distance = depth - at.z();
        if (distance < -truncation_)
          continue;
        auto& voxel = block.voxels[i];
        const auto weight = static_cast<float>(1 / (depth * depth));
        const auto cut = static_cast<float>(std::min(distance, truncation_));
        voxel.distance =
            (voxel.distance * voxel.weight + cut * weight) / (voxel.weight + weight);
        voxel.weight += weight;
        if (std::abs(distance) > voting)
          continue;
        if (voxel.votes <= 0 && voxel.label != pixels[pixel].triangle) {
          voxel.label = pixels[pixel].triangle;
          voxel.votes = 0;
        }
        voxel.votes += voxel.label == pixels[pixel].triangle ? weight : -weight;
      }
}

void
DistanceVolume::integrate(const std::vector<DepthPixel>& pixels,
                          const CameraFrame& frame,
                          const DepthCameraOptions& camera)
{
  const Projection projection(frame, camera);
  addBlocksAlong(pixels, projection);
  const double size = side * voxel_size_, radius = std::sqrt(0.75) * size;
  const auto blocks = static_cast<std::ptrdiff_t>(blocks_.size());
  parallelFor(blocks, threads_, 1, [&](std::ptrdiff_t b) {
    const Eigen::Vector3d middle =
        size * (blocks_[b]->place.cast<double>() + Eigen::Vector3d::Constant(0.5));
    if (projection.maySee(middle, radius))
      update(*blocks_[b], pixels, projection);
  });
}

const DistanceVolume::Voxel*
DistanceVolume::voxelAt(const Eigen::Vector3i& place) const
{
  Eigen::Vector3i block;
  for (int k = 0; k < 3; ++k)
    block[k] = place[k] >= 0 ? place[k] / side : -((side - 1 - place[k]) / side);
  const auto found = number_of_block_.find(keyOf(block));
  if (found == number_of_block_.end())
    return nullptr;
  return &blocks_[found->second]->voxels[indexOf(place - side * block, side)];
}

bool
DistanceVolume::isSeen(const Eigen::Vector3i& cell, float least_weight) const
{
  for (int corner = 0; corner < 8; ++corner) {
    const auto* voxel =
        voxelAt(cell + Eigen::Vector3i(corner & 1, corner >> 1 & 1, corner >> 2));
    if (!voxel || voxel->weight < least_weight)
      return false;
  }
  return true;
}

bool
DistanceVolume::isOnCell(const Eigen::Vector3i& place,
                         int axis,
                         float least_weight) const
{
  for (int side_of_edge = 0; side_of_edge < 4; ++side_of_edge) {
    Eigen::Vector3i cell = place;
    cell[(axis + 1) % 3] -= side_of_edge & 1;
    cell[(axis + 2) % 3] -= side_of_edge >> 1;
    if (isSeen(cell, least_weight))
      return true;
  }
  return false;
}

std::vector<LabelledVertex>
DistanceVolume::vertices(float least_weight) const
{
  std::vector<std::vector<LabelledVertex>> of_block(blocks_.size());
  const auto blocks = static_cast<std::ptrdiff_t>(blocks_.size());
  parallelFor(blocks, threads_, 1, [&](std::ptrdiff_t b) {
    const auto& block = *blocks_[b];
    for (int i = 0; i < side * side * side; ++i) {
      const auto& voxel = block.voxels[i];
      if (voxel.weight < least_weight)
        continue;
      const Eigen::Vector3i place =
          side * block.place +
          Eigen::Vector3i(i % side, i / side % side, i / (side * side));
      for (int axis = 0; axis < 3; ++axis) {
        const auto* next = voxelAt(place + Eigen::Vector3i::Unit(axis));
        if (!next || next->weight < least_weight ||
            (voxel.distance > 0) == (next->distance > 0) ||
            !isOnCell(place, axis, least_weight))
          continue;
        const auto& judge = voxel.votes >= next->votes ? voxel : *next;
        if (judge.label < 0)
          continue;
        Eigen::Vector3f at = place.cast<float>();
        at[axis] += voxel.distance / (voxel.distance - next->distance);
        of_block[b].push_back({static_cast<float>(voxel_size_) * at,
                               static_cast<std::uint32_t>(judge.label)});
      }
    }
  });
  std::vector<LabelledVertex> all;
  for (const auto& some : of_block)
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

} // namespace pcl::indoor
