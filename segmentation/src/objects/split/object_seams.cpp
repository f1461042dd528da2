/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/split/object_seams.h"

#include "objects/split/seam_section.h"
#include "objects/split/segment_parts.h"
#include "objects/split/slice_counts.h"

#include <pcl/indoor/ground_frame.h>
#include <pcl/indoor/quantile.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace {

using pcl::indoor::chance_deviations;
using pcl::indoor::ObjectScene;
using pcl::indoor::SeamSection;
using pcl::indoor::SliceCounts;

using Members = pcl::indoor::SegmentMembers;

constexpr double longest = 4096;  // extent of a segment, voxels
constexpr double min_side = 0.35; // of a segment beside a seam, metres
constexpr double density = 1.8;   // points of a sheet over those of what is beside it
constexpr double min_cover = 0.5; // share of the inside that a seam fills
constexpr unsigned min_cells = 8; // of a voxel that a seam fills there
/** share of the points on either side whose normals point away from the inside */
constexpr double min_outward = 0.5;

/** The points of a segment along one level direction, counted in thin slices. */
class Profile {
public:
  /** \param places in the ground frame. REQUIRES: points. */
  Profile(const std::vector<Eigen::Vector3f>& places,
          const Eigen::Vector2f& direction,
          double voxel_size)
  : direction_(direction)
  , along_(placesAlong(places, direction))
  , counts_(along_, voxel_size / per_voxel)
  {}

  const Eigen::Vector2f&
  direction() const
  {
    return direction_;
  }

  float
  along(std::size_t point) const
  {
    return along_[point];
  }

  /** Where slice i begins. */
  float
  placeOf(std::ptrdiff_t i) const
  {
    return counts_.grid().placeOf(i);
  }

  /** Points that the sheet about the beginning of slice i, one voxel wide, has more
   * than the slices of its width beside it. */
  double
  excess(std::ptrdiff_t i) const
  {
    return sheet(i) - beside(i);
  }

  /** Beginnings of slices about which a sheet lies. */
  std::vector<std::ptrdiff_t>
  peaks() const
  {
    const auto margin = std::max(
        beside_end,
        static_cast<std::ptrdiff_t>(std::ceil(min_side / counts_.grid().width)));
    std::vector<std::ptrdiff_t> found;
    for (auto i = margin; i + margin < counts_.size(); ++i)
      if (isPeak(i))
        found.push_back(i);
    return found;
  }

private:
  static constexpr std::ptrdiff_t per_voxel = 8; // slices
  // What is beside a sheet, slices from its middle.
  static constexpr std::ptrdiff_t beside_begin = per_voxel, beside_end = 3 * per_voxel;

  static std::vector<float>
  placesAlong(const std::vector<Eigen::Vector3f>& places,
              const Eigen::Vector2f& direction)
  {
    std::vector<float> along;
    along.reserve(places.size());
    for (const auto& place : places)
      along.push_back(direction.dot(place.head<2>()));
    return along;
  }

  double
  sheet(std::ptrdiff_t i) const
  {
    return counts_.held(i - per_voxel / 2, i + per_voxel / 2);
  }

  /** Points per voxel beside a sheet, on the side with more. */
  double
  beside(std::ptrdiff_t i) const
  {
    constexpr double voxels = 2;
    return std::max(counts_.held(i - beside_end, i - beside_begin),
                    counts_.held(i + beside_begin, i + beside_end)) /
           voxels;
  }

  bool
  isPeak(std::ptrdiff_t i) const
  {
    const double here = sheet(i), more = beside(i);
    if (here < density * more + chance_deviations * std::sqrt(more))
      return false;
    for (auto other = i - per_voxel; other <= i + per_voxel; ++other)
      if (sheet(other) > here || (sheet(other) == here && other < i))
        return false; // the first of equal ones counts
    return true;
  }

  Eigen::Vector2f direction_;
  std::vector<float> along_;
  SliceCounts counts_;
};

/** A place to cut, across a level direction. */
struct Seam {
  double excess = 0; ///< points more than in the slices beside it; 0 = there is no seam
  Eigen::Vector2f direction = Eigen::Vector2f::UnitX();
  float place = 0; ///< along the direction
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
    for (unsigned d = 0; d < pcl::indoor::level_directions; ++d) {
      const Profile profile(places_, pcl::indoor::levelDirection(d), voxel_size_);
      for (const auto peak : profile.peaks()) {
        const auto seam = seamAt(profile, peak);
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

  Seam
  seamAt(const Profile& profile, std::ptrdiff_t peak) const
  {
    const auto voxel = static_cast<float>(voxel_size_);
    const float centre = profile.placeOf(peak);
    std::vector<std::uint32_t> sheet, sides;
    Eigen::AlignedBox2f box;
    for (std::uint32_t i = 0; i < places_.size(); ++i) {
      const float distance = std::abs(profile.along(i) - centre);
      if (distance >= 3 * voxel || (distance >= voxel / 2 && distance < voxel))
        continue;
      (distance < voxel ? sheet : sides).push_back(i);
      box.extend(inSection(profile, places_[i]));
    }
    if (sheet.size() < min_cells) // none, where rounding moves them out of the sheet
      return {};
    SeamSection section(box, voxel);
    for (const auto i : sheet)
      section.add(SeamSection::Sheet, inSection(profile, places_[i]));
    for (const auto i : sides)
      section.add(profile.along(i) < centre ? SeamSection::Before : SeamSection::Behind,
                  inSection(profile, places_[i]));
    section.close();
    if (section.filled() < min_cells || section.cover() < min_cover ||
        outwardShare(profile, section, sides, centre) < min_outward)
      return {};
    Seam seam;
    seam.excess = profile.excess(peak);
    seam.direction = profile.direction();
    seam.place = placeOf(profile, section, sheet);
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

  /** Where to cut: in the middle of the sheet. */
  float
  placeOf(const Profile& profile,
          const SeamSection& section,
          const std::vector<std::uint32_t>& sheet) const
  {
    std::vector<float> along;
    for (const auto i : sheet)
      if (section.isInside(inSection(profile, places_[i])))
        along.push_back(profile.along(i));
    return pcl::indoor::median(along);
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
  if (members.size() < min_cells || box.sizes().head<2>().norm() < 2 * min_side ||
      box.sizes().maxCoeff() > longest * scene.voxel_size)
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

namespace pcl::indoor {

void
partAtSeams(const ObjectScene& scene,
            const std::vector<std::uint8_t>& left_out,
            std::vector<std::uint32_t>& segment_of_point)
{
  const Eigen::Matrix3f frame = groundFrame(scene.up).cast<float>();
  partSegments(
      scene,
      left_out,
      [&](const Members& members) { return cutOnce(members, scene, frame); },
      segment_of_point);
}

} // namespace pcl::indoor
