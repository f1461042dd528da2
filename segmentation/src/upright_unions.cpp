/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/segmentation/disjoint_sets.h>
#include <pcl/segmentation/upright_unions.h>

#include "interval.h"
#include "segment_boxes.h"
#include "segment_members.h"

#include <pcl/exceptions.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace {

using pcl::indoor::Interval;
using pcl::indoor::outlier_share;
using pcl::indoor::SurfaceVoxels;
using pcl::indoor::UprightUnionOptions;

using Numbers = std::vector<std::uint32_t>;

constexpr float level_cosine = 0.7f; // steeper is not level

/** The heights of a segment's voxels, and which of them are level. */
class HeightProfile {
public:
  explicit HeightProfile(std::vector<std::pair<double, bool>> voxels)
  {
    std::sort(voxels.begin(), voxels.end());
    for (const auto& [height, is_level] : voxels) {
      heights_.push_back(height);
      level_up_to_.push_back(level_up_to_.back() + is_level);
    }
  }

  /** \return NaN if there is none */
  double
  levelShare(double low, double high) const
  {
    return levelShare(
        std::lower_bound(heights_.begin(), heights_.end(), low) - heights_.begin(),
        std::upper_bound(heights_.begin(), heights_.end(), high) - heights_.begin());
  }

  double
  levelShare() const
  {
    return levelShare(0, static_cast<std::ptrdiff_t>(heights_.size()));
  }

  /** REQUIRES: voxels. */
  double
  bottom() const
  {
    return heightAt(outlier_share);
  }

  /** REQUIRES: voxels. */
  double
  top() const
  {
    return heightAt(1 - outlier_share);
  }

private:
  double
  heightAt(double share) const
  {
    return heights_[static_cast<std::size_t>(share *
                                             static_cast<double>(heights_.size() - 1))];
  }

  double
  levelShare(std::ptrdiff_t first, std::ptrdiff_t end) const
  {
    return static_cast<double>(level_up_to_[static_cast<std::size_t>(end)] -
                               level_up_to_[static_cast<std::size_t>(first)]) /
           static_cast<double>(end - first);
  }

  std::vector<double> heights_;
  std::vector<std::size_t> level_up_to_{0};
};

/** A thin piece that stands upright. */
struct Upright {
  Eigen::Vector3f along; // level
  Interval width;        // along it
  double top;
};

/** How much of an upright touches another segment, columns. */
struct Contact {
  std::size_t columns = 0, at_top = 0;
};

/** Finds what uprights carry or end. */
class UprightJoiner {
public:
  UprightJoiner(const SurfaceVoxels& voxels,
                const std::vector<std::uint8_t>& left_out,
                const Numbers& segment_of_voxel,
                const UprightUnionOptions& options)
  : voxels_(voxels)
  , left_out_(left_out)
  , segment_of_voxel_(segment_of_voxel)
  , options_(options)
  , voxels_of_segment_(pcl::indoor::membersOfSegments(left_out, segment_of_voxel))
  {
    for (const auto& members : voxels_of_segment_) {
      std::vector<std::pair<double, bool>> heights;
      for (const auto v : members)
        heights.emplace_back(
            heightOf(v), std::abs(voxels.normals[v].dot(options.up)) > level_cosine);
      profiles_.emplace_back(std::move(heights));
    }
  }

  /** \return for each segment the one whose number it gets */
  Numbers
  joinedSegments() const
  {
    pcl::indoor::DisjointSets joined(voxels_of_segment_.size());
    for (std::uint32_t s = 0; s < voxels_of_segment_.size(); ++s)
      if (const auto upright = uprightOf(s))
        for (const auto other : ownersOf(s, *upright))
          joined.merge(joined.find(s), joined.find(other));
    Numbers numbers;
    for (std::uint32_t s = 0; s < voxels_of_segment_.size(); ++s)
      numbers.push_back(joined.find(s));
    return numbers;
  }

private:
  double
  heightOf(std::uint32_t voxel) const
  {
    return options_.up.dot(voxels_.centroids[voxel]);
  }

  /** From one end to the other, without outliers and half voxels. */
  Interval
  rangeOf(const Numbers& members, const Eigen::Vector3f& direction) const
  {
    std::vector<double> places;
    for (const auto v : members)
      places.push_back(direction.dot(voxels_.centroids[v]));
    return pcl::indoor::trimmedRange(places);
  }

  /** The level direction in which the voxels reach farthest. */
  Eigen::Vector3f
  longestLevel(const Numbers& members) const
  {
    Eigen::Matrix<float, 3, 2> level;
    level.col(0) = options_.up.unitOrthogonal();
    level.col(1) = options_.up.cross(level.col(0));
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const auto v : members)
      sum += (level.transpose() * voxels_.centroids[v]).cast<double>();
    const Eigen::Vector2d mean = sum / static_cast<double>(members.size());
    Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
    for (const auto v : members) {
      const Eigen::Vector2d place =
          (level.transpose() * voxels_.centroids[v]).cast<double>() - mean;
      scatter += place * place.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(scatter);
    return level * solver.eigenvectors().col(1).cast<float>();
  }

  std::optional<Upright>
  uprightOf(std::uint32_t segment) const
  {
    const auto& members = voxels_of_segment_[segment];
    if (members.empty())
      return {};
    const double top = profiles_[segment].top();
    const double height = top - profiles_[segment].bottom();
    if (height + options_.voxel_size < options_.min_height)
      return {};
    Upright upright;
    upright.along = longestLevel(members);
    const double thickness =
        rangeOf(members, options_.up.cross(upright.along)).length();
    if (thickness + options_.voxel_size > options_.max_thickness || thickness > height)
      return {};
    upright.width = rangeOf(members, upright.along);
    upright.top = top;
    return upright;
  }

  /** The column of the upright that a voxel is in, a voxel wide. */
  std::int64_t
  columnOf(std::uint32_t voxel, const Upright& upright) const
  {
    const double place = upright.along.dot(voxels_.centroids[voxel]);
    return static_cast<std::int64_t>(
        std::floor((place - upright.width.low) / options_.voxel_size + 0.5));
  }

  /** \return the segments that the upright carries or ends */
  Numbers
  ownersOf(std::uint32_t segment, const Upright& upright) const
  {
    std::map<std::int64_t, double> top_of_column;
    for (const auto v : voxels_of_segment_[segment]) {
      auto& top =
          top_of_column.emplace(columnOf(v, upright), heightOf(v)).first->second;
      top = std::max(top, heightOf(v));
    }
    const double enough =
        options_.min_cover * static_cast<double>(top_of_column.size());
    Numbers owners;
    for (const auto& [other, contact] : contactsOf(segment, upright, top_of_column))
      if ((static_cast<double>(contact.at_top) >= enough &&
           isCarried(other, upright.top)) ||
          (static_cast<double>(contact.columns) >= enough && isEnded(other, upright)))
        owners.push_back(other);
    return owners;
  }

  std::map<std::uint32_t, Contact>
  contactsOf(std::uint32_t segment,
             const Upright& upright,
             const std::map<std::int64_t, double>& top_of_column) const
  {
    std::map<std::pair<std::uint32_t, std::int64_t>, bool>
        is_at_top; // by segment and column
    for (const auto v : voxels_of_segment_[segment]) {
      const auto column = columnOf(v, upright);
      const bool at_top =
          heightOf(v) >= top_of_column.at(column) - 1.5 * options_.voxel_size;
      const auto& around = voxels_.neighbors;
      for (auto j = around.offsets[v]; j < around.offsets[v + 1]; ++j) {
        const auto other = around.targets[j];
        if (!left_out_[other] && segment_of_voxel_[other] != segment)
          is_at_top[{segment_of_voxel_[other], column}] |= at_top;
      }
    }
    std::map<std::uint32_t, Contact> contacts;
    for (const auto& [place, at_top] : is_at_top) {
      ++contacts[place.first].columns;
      contacts[place.first].at_top += at_top;
    }
    return contacts;
  }

  /** Level, and not much higher. */
  bool
  isCarried(std::uint32_t segment, double edge) const
  {
    const double reach = 3 * options_.voxel_size;
    const auto& profile = profiles_[segment];
    return profile.top() - edge < options_.max_above &&
           (profile.levelShare() >= options_.min_level ||
            profile.levelShare(edge - reach, edge + reach) >= options_.min_level);
  }

  /** Level, and as wide. */
  bool
  isEnded(std::uint32_t segment, const Upright& upright) const
  {
    if (profiles_[segment].levelShare() < options_.min_level)
      return false;
    const double half = options_.voxel_size / 2;
    const auto width = rangeOf(voxels_of_segment_[segment], upright.along);
    return commonShare(width.widened(half), upright.width.widened(half)) >=
           options_.min_overlap;
  }

  const SurfaceVoxels& voxels_;
  const std::vector<std::uint8_t>& left_out_;
  const Numbers& segment_of_voxel_;
  const UprightUnionOptions& options_;
  std::vector<Numbers> voxels_of_segment_;
  std::vector<HeightProfile> profiles_;
};

void
requireValid(const UprightUnionOptions& options)
{
  const auto is_share = [](double value) { return value > 0 && value <= 1; };
  if (!(options.voxel_size > 0) || !(options.max_thickness > 0) ||
      !(options.min_height >= 0) || !is_share(options.min_cover) ||
      !is_share(options.min_level) || !(options.max_above >= 0) ||
      !is_share(options.min_overlap) || !(std::abs(options.up.norm() - 1) < 1e-3f))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "Uprights need positive sizes, shares of at most 1 and a unit "
                        "vector up.");
}

} // namespace

namespace pcl {
namespace indoor {

void
joinUprights(const SurfaceVoxels& voxels,
             const std::vector<std::uint8_t>& left_out,
             const UprightUnionOptions& options,
             std::vector<std::uint32_t>& segment_of_voxel)
{
  requireOnePerVoxel(voxels, left_out, segment_of_voxel);
  if (voxels.normals.size() != voxels.size())
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        voxels.size()
                            << " voxels have " << voxels.normals.size() << " normals.");
  requireValid(options);
  if (voxels.size() == 0)
    return;
  const auto numbers =
      UprightJoiner(voxels, left_out, segment_of_voxel, options).joinedSegments();
  renumberSegments(
      left_out, [&](auto s) { return numbers[s]; }, segment_of_voxel);
}

} // namespace indoor
} // namespace pcl
