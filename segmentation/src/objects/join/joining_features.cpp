/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/join/joining_features.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <vector>

namespace pcl::indoor {
namespace {

/** What the voxels of a piece were taken for, in the mean. */
struct VoteSummary {
  std::vector<double> shares; ///< of each class
  double building = 0;        ///< of floor, wall and ceiling together
  double most = 0;            ///< of a class of objects
  Eigen::Vector3d middle;     ///< of the objects
  double spread;              ///< of the middles, metres

  explicit VoteSummary(const Piece& piece)
  : shares(piece.votes.classes)
  , middle(piece.votes.middles.mean())
  , spread(std::sqrt(std::max(0.0, piece.votes.middles.covariance().trace())))
  {
    for (auto& share : shares)
      share /= std::max(1.0, piece.positions.count);
    const auto objects = shares.begin() + building_classes;
    building = std::accumulate(shares.begin(), objects, 0.0);
    if (objects != shares.end())
      most = *std::max_element(objects, shares.end());
  }
};

/** Bhattacharyya's coefficient: 1 if they are the same. */
double
likenessOf(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0;
  for (std::size_t c = 0; c < a.size(); ++c)
    sum += std::sqrt(std::max(0.0, a[c] * b[c]));
  return sum;
}

} // namespace

/** Features in their order. */
class PairDescription::FeatureList {
public:
  explicit FeatureList(float* first)
  : next_(first)
  {}

  void
  put(double value)
  {
    *next_++ = static_cast<float>(value);
  }

  void
  putLog(double value, double least)
  {
    put(std::log(std::max(value, least)));
  }

  void
  putNothing(std::size_t count)
  {
    next_ = std::fill_n(next_, count, 0.0f);
  }

  const float*
  end() const
  {
    return next_;
  }

private:
  float* next_;
};

PairOutlines::PairOutlines(const KDop16& a, const KDop16& b)
: both(hullOfBoth(a, b))
, both_area(outlineArea(both))
, common_area(outlineArea(commonHull(a, b)))
{}

PairDescription::PairDescription(const PieceGraph& graph)
: voxel_size_(graph.voxel_size)
, floor_(graph.floor)
, columns_(graph.columns)
{}

PieceShape
PairDescription::shapeOf(const Piece& piece) const
{
  PieceShape shape;
  shape.volume = hulls_.volume(piece.hull);
  shape.box_volume = hulls_.boxVolume(piece.hull);
  shape.outline_area = outlineArea(piece.outline);
  shape.floor_area = columns_.areaOfFloor(piece.outline);
  shape.mean = piece.positions.mean();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(piece.positions.covariance());
  shape.deviations = solver.eigenvalues().cwiseMax(0).cwiseSqrt();
  shape.thin = solver.eigenvectors().col(0);
  solver.computeDirect(piece.normals.squares / std::max(1.0, piece.normals.count),
                       Eigen::EigenvaluesOnly);
  shape.normal_shares = solver.eigenvalues();
  shape.low = -piece.hull[2] - floor_; // directions 0 to 5 are -x -y -z +z +y +x
  shape.high = piece.hull[3] - floor_;
  return shape;
}

void
PairDescription::putPiece(const PairSide& side, FeatureList& list) const
{
  const auto& piece = side.piece;
  const auto& shape = side.shape;
  list.putLog(piece.positions.count * voxel_size_ * voxel_size_, 1e-6);
  list.put(shape.high - shape.low);
  list.put(shape.low);
  list.put(shape.high);
  for (int i = 0; i < 3; ++i)
    list.put(shape.deviations[i]);
  list.put(piece.normals.squares(2, 2) / piece.normals.count);
  list.put(piece.normals.mean().norm());
  list.put(shape.normal_shares[1]);
  list.put(shape.normal_shares[2]);
  list.putLog(shape.outline_area, voxel_size_ * voxel_size_);
  list.putLog(shape.volume, std::pow(voxel_size_, 3));
}

void
PairDescription::putContact(const PairSide& a,
                            const PairSide& b,
                            const PieceContact& contact,
                            FeatureList& list) const
{
  const Eigen::Vector3d place =
      contact.places.count > 0 ? contact.places.mean()
                               : Eigen::Vector3d(0.5 * (a.shape.mean + b.shape.mean));
  const double height = place.z() - floor_;
  const auto put_side = [&](const PairSide& side, double touching) {
    const double voxels = side.piece.positions.count;
    const auto& shape = side.shape;
    list.put(touching / voxels);
    list.put(touching / std::sqrt(voxels));
    list.put(touching / std::max(1.0, side.touching));
    list.put((height - shape.low) / std::max(voxel_size_, shape.high - shape.low));
  };
  put_side(a, contact.first_voxels);
  put_side(b, contact.second_voxels);
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(contact.places.covariance());
  const Eigen::Vector3d spread = solver.eigenvalues().cwiseMax(0).cwiseSqrt();
  list.put(spread[2]);
  list.put(spread[1]);
  list.put(contact.places.count > 0 ? std::abs(solver.eigenvectors()(2, 2)) : -1);
}

void
PairDescription::putBend(const PieceContact& contact, FeatureList& list)
{
  if (!(contact.bends > 0)) {
    list.put(-90); // below all bends
    list.put(-1);
    list.putLog(0, 0.5);
    list.put(-1);
    return;
  }
  const double bend = contact.bend_sum / contact.bends;
  list.put(bend);
  list.put(
      std::sqrt(std::max(0.0, contact.bend_squares / contact.bends - bend * bend)));
  list.putLog(contact.bends, 0.5);
  list.put(contact.concave_bends / contact.bends);
}

void
PairDescription::putPlanes(const PairSide& a,
                           const PairSide& b,
                           FeatureList& list) const
{
  const Eigen::Vector3d between = b.shape.mean - a.shape.mean;
  for (const auto* side : {&a, &b})
    list.put(std::abs(side->shape.thin.dot(between)) /
             (voxel_size_ + side->shape.deviations[0]));
  auto both = a.piece.positions;
  both += b.piece.positions;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(both.covariance(), Eigen::EigenvaluesOnly);
  const Eigen::Vector3d deviations = solver.eigenvalues().cwiseMax(0).cwiseSqrt();
  list.put(deviations[0]);
  list.put(deviations[1]);
  const Eigen::Vector3d normal_a = a.piece.normals.mean(),
                        normal_b = b.piece.normals.mean();
  list.put(normal_a.dot(normal_b) / std::max(0.05, normal_a.norm() * normal_b.norm()));
}

void
PairDescription::putHulls(const PairSide& a,
                          const PairSide& b,
                          const PairOutlines& outlines,
                          FeatureList& list) const
{
  constexpr double most = 20; // times the smaller
  const double least_volume = std::pow(voxel_size_, 3);
  const auto hull = hullOfBoth(a.piece.hull, b.piece.hull);
  const double volume = hulls_.volume(hull);
  const double air = volume - a.shape.volume - b.shape.volume;
  list.put(
      std::max(-2.0,
               std::min(most,
                        air / std::max(least_volume,
                                       std::min(a.shape.volume, b.shape.volume)))));
  list.put(air / std::max(least_volume, volume));
  const double common_box = hulls_.boxVolume(commonHull(a.piece.hull, b.piece.hull));
  const double box_air =
      hulls_.boxVolume(hull) - a.shape.box_volume - b.shape.box_volume + common_box;
  list.put(
      std::min(most,
               box_air / std::max(least_volume,
                                  std::min(a.shape.box_volume, b.shape.box_volume))));
  list.putLog(volume, least_volume);
  const double area =
      (a.piece.positions.count + b.piece.positions.count) * voxel_size_ * voxel_size_;
  list.put(area / std::pow(std::max(least_volume, volume), 2.0 / 3));
  list.put(common_box / std::max(least_volume, a.shape.box_volume));

  const double least_area = voxel_size_ * voxel_size_;
  list.put(outlines.common_area /
           std::max(least_area, std::min(a.shape.outline_area, b.shape.outline_area)));
  list.put(outlines.common_area / std::max(least_area, outlines.both_area));
  list.putLog(outlines.both_area, least_area);
}

void
PairDescription::putHeights(const PairSide& a,
                            const PairSide& b,
                            FeatureList& list) const
{
  const double overlap =
      std::min(a.shape.high, b.shape.high) - std::max(a.shape.low, b.shape.low);
  list.put(overlap /
           std::max(voxel_size_,
                    std::min(a.shape.high - a.shape.low, b.shape.high - b.shape.low)));
  list.put(b.shape.low - a.shape.low);
  list.put(b.shape.high - a.shape.high);
}

/** How the outlines lie to each other, and what is seen between them. */
void
PairDescription::putOutlines(const PairSide& a,
                             const PairSide& b,
                             const PairOutlines& outlines,
                             FeatureList& list) const
{
  const double least_area = voxel_size_ * voxel_size_;
  const double area = std::max(least_area, outlines.both_area);
  const auto rectangle = outlineRectangle(outlines.both);
  const auto off_middle = [&](std::size_t axis, double size) {
    const auto twice_middle = [axis](const KDop16& outline) {
      return static_cast<double>(outline[axis]) - outline[axis + 8];
    };
    return std::abs(twice_middle(a.piece.outline) - twice_middle(b.piece.outline)) /
           (2 * std::max(voxel_size_, size));
  };
  const double along = off_middle(rectangle.axis, rectangle.length),
               across = off_middle(rectangle.axis + 4, rectangle.width);
  list.put(std::min(along, across));
  list.put(std::max(along, across));
  list.put(area / std::max(least_area, rectangle.length * rectangle.width));

  list.put((area - a.shape.outline_area - b.shape.outline_area + outlines.common_area) /
           area);
  const auto gap =
      columns_.areaBetween(a.piece.outline,
                           b.piece.outline,
                           {std::max(a.shape.low, b.shape.low) + floor_,
                            std::min(a.shape.high, b.shape.high) + floor_});
  list.put(gap.open / area);
  list.put(gap.filled / area);
  for (const auto* side : {&a, &b})
    list.put(side->shape.floor_area / std::max(least_area, side->shape.outline_area));
}

void
PairDescription::putVotes(const PairSide& a, const PairSide& b, FeatureList& list) const
{
  if (a.piece.votes.classes.empty()) {
    list.putNothing(12);
    return;
  }
  const VoteSummary of_a(a.piece), of_b(b.piece);
  list.put(likenessOf(of_a.shares, of_b.shares));
  list.put(std::inner_product(
      of_a.shares.begin(), of_a.shares.end(), of_b.shares.begin(), 0.0));
  list.put(of_a.building);
  list.put(of_b.building);
  list.put(of_a.most);
  list.put(of_b.most);
  const double distance = (of_a.middle - of_b.middle).norm();
  list.put(distance);
  list.put(distance / (of_a.spread + of_b.spread + voxel_size_));
  list.put(of_a.spread);
  list.put(of_b.spread);
  list.put((of_a.middle - b.shape.mean).norm());
  list.put((of_b.middle - a.shape.mean).norm());
}

void
PairDescription::putVotes(const PairSide& object, FeatureList& list) const
{
  if (object.piece.votes.classes.empty()) {
    list.putNothing(6);
    return;
  }
  const VoteSummary votes(object.piece);
  list.put(votes.building);
  list.put(votes.most);
  list.put(std::inner_product(
      votes.shares.begin(), votes.shares.end(), votes.shares.begin(), 0.0));
  list.put(votes.spread);
  list.put(votes.spread / (object.shape.deviations.norm() + voxel_size_));
  list.put((votes.middle - object.shape.mean).norm());
}

JoiningFeatures
PairDescription::describe(const PairSide& side_a,
                          const PairSide& side_b,
                          const PieceContact& contact) const
{
  JoiningFeatures features;
  FeatureList list(features.data());
  const PairOutlines outlines(side_a.piece.outline, side_b.piece.outline);
  putPiece(side_a, list);
  putPiece(side_b, list);
  putContact(side_a, side_b, contact, list);
  putBend(contact, list);
  putPlanes(side_a, side_b, list);
  putHulls(side_a, side_b, outlines, list);
  putHeights(side_a, side_b, list);
  const double none = 1; // metres: no gap
  list.put(contact.near_cells > 0 ? contact.gap : none);
  list.putLog(contact.near_cells, 0.5);
  list.put(contact.near_cells > 0 ? contact.near_in_line / contact.near_cells : -1);
  list.putLog(side_a.piece.parts, 1);
  list.putLog(side_b.piece.parts, 1);
  list.put(side_a.contacts);
  list.put(side_b.contacts);
  list.put(voxel_size_);
  putOutlines(side_a, side_b, outlines, list);
  putVotes(side_a, side_b, list);
  assert(list.end() == features.data() + features.size());
  return features;
}

ObjectFeatures
PairDescription::describeObject(const PairSide& object,
                                float probability,
                                float level) const
{
  const auto& piece = object.piece;
  const auto& shape = object.shape;
  const double least_area = voxel_size_ * voxel_size_;
  const auto rectangle = outlineRectangle(piece.outline);
  ObjectFeatures features;
  FeatureList list(features.data());
  putPiece(object, list);
  list.put(piece.positions.count * least_area /
           std::pow(std::max(std::pow(voxel_size_, 3), shape.volume), 2.0 / 3));
  list.put(shape.outline_area /
           std::max(least_area, rectangle.length * rectangle.width));
  list.put(shape.floor_area / std::max(least_area, shape.outline_area));
  list.putLog(piece.parts, 1);
  list.put(object.contacts);
  list.put(object.touching / piece.positions.count);
  list.put(voxel_size_);
  list.put(probability);
  list.put(level);
  list.put(0); // nothing takes it up
  list.put(0);
  putVotes(object, list);
  assert(list.end() == features.data() + features.size());
  return features;
}

} // namespace pcl::indoor
