/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/split/object_seams.h"

#include "objects/split/seam_profile.h"
#include "objects/split/seam_section.h"
#include "objects/split/segment_parts.h"
#include <pcl/indoor/ground_frame.h>

#include <pcl/exceptions.h>
#include <pcl/indoor/quantile.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>

namespace {

using pcl::indoor::ObjectScene;
using pcl::indoor::SeamSection;
using Profile = pcl::indoor::SeamProfile;

using Members = pcl::indoor::SegmentMembers;

constexpr double farthest = 4096; // extent of a segment, voxels
constexpr double min_cover = 0.5; // share of the inside that a seam fills
constexpr double min_depth = 2;   // of the inside, cells of a voxel
/** least share of inside cells among the cells of a sheet in which neither side has
 * points: the side of a drawer unit under a desk has fewer */
constexpr double enclosed = 0.15;
constexpr unsigned min_cells = 8; // of a voxel that a seam fills there
/** share of the points on either side whose normals point away from the inside */
constexpr double min_outward = 0.5;
constexpr unsigned directions = 60; // of upright planes that are tried, in 180 degrees
const float farthest_turn = std::cos(static_cast<float>(M_PI) / 15); // 12 degrees

/** A place to cut, across a level direction. */
struct Seam {
  double excess = 0; ///< points more than in the slices beside it; 0 = there is no seam
  Eigen::Vector2f direction = Eigen::Vector2f::UnitX();
  float place = 0;                                   ///< along the direction
  Eigen::Vector2f normal = Eigen::Vector2f::UnitX(); ///< of the plane of its points
  Eigen::Vector2f middle = Eigen::Vector2f::Zero();  ///< mean of its points
};

/** Looks for a seam through one segment. */
class SeamFinder {
public:
  /** \param places, normals in the ground frame */
  SeamFinder(const std::vector<Eigen::Vector3f>& places,
             const std::vector<Eigen::Vector3f>& normals,
             double voxel_size)
  : places_(places)
  , normals_(normals)
  , voxel_size_(voxel_size)
  {}

  Seam
  find() const
  {
    Seam best;
    for (unsigned d = 0; d < directions; ++d) {
      const Profile profile(
          places_, pcl::indoor::levelDirection(d, directions), voxel_size_);
      for (const auto peak : profile.peaks()) {
        auto seam = seamAt(profile, peak);
        if (!(seam.excess > 0))
          continue;
        seam = turned(seam);
        if (seam.excess > best.excess)
          best = seam;
      }
    }
    return best;
  }

private:
  Eigen::Vector2f
  inSection(const Profile& profile, const Eigen::Vector3f& vector) const
  {
    const Eigen::Vector2f across(-profile.direction().y(), profile.direction().x());
    return {across.dot(vector.head<2>()), vector.z()};
  }

  /** The seam along the plane through its own points, if it is clearer there. */
  Seam
  turned(const Seam& seam) const
  {
    const Profile profile(places_, seam.normal, voxel_size_);
    const auto middle = profile.grid().sliceAt(seam.normal.dot(seam.middle));
    Seam best = seam;
    for (const auto peak : profile.peaks())
      if (std::abs(peak - middle) <= Profile::per_voxel) {
        const auto other = seamAt(profile, peak);
        if (other.excess > best.excess)
          best = other;
      }
    return best;
  }

  Seam
  seamAt(const Profile& profile, std::ptrdiff_t peak) const
  {
    const auto voxel = static_cast<float>(voxel_size_);
    const float centre = profile.grid().placeOf(peak);
    std::vector<std::uint32_t> sheet, sides;
    Eigen::AlignedBox2f box;
    for (std::uint32_t i = 0; i < places_.size(); ++i) {
      const float distance = std::abs(profile.along(i) - centre);
      if (distance >= 3 * voxel || (distance >= voxel / 2 && distance < voxel))
        continue;
      (distance < voxel ? sheet : sides).push_back(i);
      box.extend(inSection(profile, places_[i]));
    }
    SeamSection section(box, voxel);
    for (const auto i : sheet)
      section.add(SeamSection::Sheet, inSection(profile, places_[i]));
    for (const auto i : sides)
      section.add(profile.along(i) < centre ? SeamSection::Before : SeamSection::Behind,
                  inSection(profile, places_[i]));
    section.close();
    const auto filled = static_cast<double>(section.filled());
    if (filled < min_cells || section.cover() < min_cover ||
        filled < enclosed * static_cast<double>(section.sheet()) ||
        section.depth() < min_depth ||
        outwardShare(profile, section, sides, centre) < min_outward)
      return {};
    Seam seam;
    seam.excess = profile.excess(peak);
    seam.direction = seam.normal = profile.direction();
    placeSeam(profile, section, sheet, seam);
    return seam;
  }

  /** The share of normals that point away from the inside, on the side with less. */
  double
  outwardShare(const Profile& profile,
               const SeamSection& section,
               const std::vector<std::uint32_t>& sides,
               float centre) const
  {
    std::array<double, 2> outward{}, all{};
    for (const auto i : sides) {
      const Eigen::Vector2f normal = inSection(profile, normals_[i]);
      if (normal.norm() < 0.5f)
        continue; // of a surface along the section, or none
      const std::size_t side = profile.along(i) < centre ? 0 : 1;
      const Eigen::Vector2f from = inSection(profile, places_[i]) - section.middle();
      ++all[side];
      outward[side] += normal.dot(from) > 0 ? 1 : 0;
    }
    return std::min(outward[0] / std::max(all[0], 1.0),
                    outward[1] / std::max(all[1], 1.0));
  }

  void
  placeSeam(const Profile& profile,
            const SeamSection& section,
            const std::vector<std::uint32_t>& sheet,
            Seam& seam) const
  {
    std::vector<float> along;
    std::vector<Eigen::Vector2d> inside;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const auto i : sheet)
      if (section.isInside(inSection(profile, places_[i]))) {
        along.push_back(profile.along(i));
        inside.emplace_back(places_[i].head<2>().cast<double>());
        mean += inside.back();
      }
    mean /= static_cast<double>(inside.size());
    Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
    for (const auto& place : inside)
      scatter += (place - mean) * (place - mean).transpose();
    seam.middle = mean.cast<float>();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(scatter);
    const Eigen::Vector2f normal = solver.eigenvectors().col(0).cast<float>();
    if (std::abs(normal.dot(seam.direction)) > farthest_turn)
      seam.normal = normal.dot(seam.direction) > 0 ? normal : Eigen::Vector2f(-normal);
    seam.place = placeWithin(section, along);
  }

  /** Where to cut: in the middle of the sheet, or, if the sheet belongs to one body, on
   * the side of the other. */
  static float
  placeWithin(const SeamSection& section, std::vector<float>& along)
  {
    const auto before = section.exposed(SeamSection::Before);
    const auto behind = section.exposed(SeamSection::Behind);
    const bool is_of_one = 2 * std::max(before, behind) > section.filled() &&
                           std::max(before, behind) > 2 * std::min(before, behind);
    const double share = !is_of_one ? 0.5 : before > behind ? 0.02 : 0.98;
    return pcl::indoor::quantile(along, share);
  }

  const std::vector<Eigen::Vector3f>& places_;
  const std::vector<Eigen::Vector3f>& normals_;
  double voxel_size_;
};

std::vector<Members>
cutOnce(const Members& members, const ObjectScene& scene, const Eigen::Matrix3f& frame)
{
  const auto& voxels = scene.voxels;
  std::vector<Eigen::Vector3f> places, normals;
  Eigen::AlignedBox3f box;
  for (const auto i : members) {
    places.emplace_back(frame * scene.points[i]);
    box.extend(places.back());
  }
  if (members.size() < min_cells ||
      box.sizes().head<2>().norm() < 2 * pcl::indoor::min_seam_side ||
      box.sizes().maxCoeff() > farthest * scene.voxel_size)
    return {members};
  for (const auto i : members)
    normals.emplace_back(frame * voxels.normals[voxels.cells.cell_of_point[i]]);
  const auto seam = SeamFinder(places, normals, scene.voxel_size).find();
  if (!(seam.excess > 0))
    return {members};
  std::vector<Members> parts(2);
  for (std::size_t i = 0; i < members.size(); ++i)
    parts[seam.direction.dot(places[i].head<2>()) < seam.place ? 0 : 1].push_back(
        members[i]);
  return parts;
}

} // namespace

namespace pcl {
namespace indoor {

void
partAtSeams(const ObjectScene& scene,
            const std::vector<std::uint8_t>& left_out,
            std::vector<std::uint32_t>& segment_of_point)
{
  requireConsistent(scene, segment_of_point.size());
  requireConsistent(scene, left_out.size());
  if (scene.points.empty())
    return;
  const Eigen::Matrix3f frame = groundFrame(scene.up).cast<float>();
  partSegments(
      left_out,
      scene.threads,
      [&](const Members& segment) {
        return cutRepeatedly(segment, [&](const Members& whole) {
          return cutOnce(whole, scene, frame);
        });
      },
      segment_of_point);
}

} // namespace indoor
} // namespace pcl
