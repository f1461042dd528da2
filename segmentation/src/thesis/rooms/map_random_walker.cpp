/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "thesis/rooms/map_random_walker.h"

#include "rooms/space/map_regions.h"

#include <pcl/indoor/parallel_for.h>
#include <pcl/indoor/threads.h>

#include <pcl/exceptions.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl::indoor {
namespace {

constexpr double smallest_weight = 1e-10; // keeps the Laplacian regular
constexpr double tie = 1e-9;              // of probabilities; far above rounding

/** The pixels of a region and where each stands in it. */
struct Region {
  std::vector<std::size_t> pixels;
  std::vector<int> labels; // those that it touches, ascending
};

class Walker {
public:
  Walker(const PixelMap<float>& values,
         const PixelMap<int>& labels,
         const PixelMap<std::uint8_t>& mask,
         double beta,
         int threads)
  : values_(values)
  , labels_(labels)
  , mask_(mask)
  , beta_(beta)
  , threads_(threads)
  {}

  PixelMap<int>
  run()
  {
    PixelMap<int> result{values_.nx, values_.ny, std::vector<int>(values_.size(), -1)};
    for (std::size_t i = 0; i < result.size(); ++i)
      if (mask_.values[i] && labels_.values[i] >= 0)
        result.values[i] = labels_.values[i];
    for (const Region& region : findRegions()) {
      if (region.labels.size() == 1)
        for (const std::size_t pixel : region.pixels)
          result.values[pixel] = region.labels.front();
      else if (region.labels.size() > 1)
        solve(region, result);
    }
    return result;
  }

private:
  template <typename Visit>
  void
  forEachNeighbour(std::size_t pixel, const Visit& visit) const
  {
    indoor::forEachNeighbour(mask_, pixel, Neighbours::Four, [&](std::size_t other) {
      if (mask_.values[other])
        visit(other);
    });
  }

  /** Connected unlabelled pixels; also numbers the pixels within each region. */
  std::vector<Region>
  findRegions()
  {
    std::vector<Region> regions;
    place_.assign(values_.size(), -1);
    for (std::size_t seed = 0; seed < values_.size(); ++seed) {
      if (place_[seed] >= 0 || !mask_.values[seed] || labels_.values[seed] >= 0)
        continue;
      Region region;
      const auto take = [&](std::size_t pixel) {
        place_[pixel] = static_cast<int>(region.pixels.size());
        region.pixels.push_back(pixel);
      };
      take(seed);
      for (std::size_t k = 0; k < region.pixels.size(); ++k)
        forEachNeighbour(region.pixels[k], [&](std::size_t other) {
          if (labels_.values[other] >= 0)
            region.labels.push_back(labels_.values[other]);
          else if (place_[other] < 0)
            take(other);
        });
      std::sort(region.labels.begin(), region.labels.end());
      region.labels.erase(std::unique(region.labels.begin(), region.labels.end()),
                          region.labels.end());
      regions.push_back(std::move(region));
    }
    return regions;
  }

  double
  weight(std::size_t i, std::size_t j) const // Eq. (2.11)
  {
    const double step = static_cast<double>(values_.values[i]) - values_.values[j];
    return std::max(std::exp(-beta_ * step * step), smallest_weight);
  }

  /** Minimises Eq. (2.12) for each label of a region, given the seeds around it. */
  void
  solve(const Region& region, PixelMap<int>& result) const
  {
    const auto size = static_cast<Eigen::Index>(region.pixels.size());
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<Eigen::Triplet<double>> towards_seeds; // pixel, label, weight
    for (Eigen::Index row = 0; row < size; ++row) {
      const std::size_t pixel = region.pixels[static_cast<std::size_t>(row)];
      double degree = 0.0;
      forEachNeighbour(pixel, [&](std::size_t other) {
        const double w = weight(pixel, other);
        degree += w;
        const int label = labels_.values[other];
        if (label >= 0)
          towards_seeds.emplace_back(
              row,
              std::lower_bound(region.labels.begin(), region.labels.end(), label) -
                  region.labels.begin(),
              w);
        else if (place_[other] < row) // the lower half is all that is read
          entries.emplace_back(row, place_[other], -w);
      });
      entries.emplace_back(row, row, degree);
    }
    Eigen::SparseMatrix<double> laplacian(size, size);
    laplacian.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(laplacian);
    takeMostProbable(region, solver, towards_seeds, result);
  }

  /** Solves for a few labels at a time, in parallel, and keeps the best of each pixel.
   */
  void
  takeMostProbable(const Region& region,
                   const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>& solver,
                   const std::vector<Eigen::Triplet<double>>& towards_seeds,
                   PixelMap<int>& result) const
  {
    constexpr Eigen::Index batch = 8;
    const auto size = static_cast<Eigen::Index>(region.pixels.size());
    const auto labels = static_cast<Eigen::Index>(region.labels.size());
    Eigen::VectorXd best = Eigen::VectorXd::Constant(size, -1.0);
    Eigen::MatrixXd probability(size, std::min(batch, labels));
    for (Eigen::Index first = 0; first < labels; first += batch) {
      const Eigen::Index count = std::min(batch, labels - first);
      probability.setZero();
      for (const auto& entry : towards_seeds)
        if (entry.col() >= first && entry.col() < first + count)
          probability(entry.row(), entry.col() - first) += entry.value();
      const int threads = usefulThreads(threads_, region.pixels.size(), 5000);
      parallelFor(count, threads, 1, [&](Eigen::Index l) {
        const Eigen::VectorXd side = probability.col(l);
        probability.col(l) = solver.solve(side);
      });
      for (Eigen::Index row = 0; row < size; ++row)
        for (Eigen::Index l = 0; l < count; ++l)
          if (probability(row, l) > best[row] + tie) {
            best[row] = probability(row, l);
            result.values[region.pixels[static_cast<std::size_t>(row)]] =
                region.labels[static_cast<std::size_t>(first + l)];
          }
    }
  }

  const PixelMap<float>& values_;
  const PixelMap<int>& labels_;
  const PixelMap<std::uint8_t>& mask_;
  double beta_;
  int threads_;
  std::vector<int> place_; // of each unlabelled pixel in its region
};

} // namespace

PixelMap<int>
mapRandomWalker(const PixelMap<float>& values,
                const PixelMap<int>& labels,
                const PixelMap<std::uint8_t>& mask,
                double beta,
                int threads)
{
  const auto matches = [&](const auto& map) {
    return map.nx == values.nx && map.ny == values.ny &&
           map.values.size() == values.size();
  };
  if (!matches(values) || !matches(labels) || !matches(mask))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "The values, labels and mask are not of one size.");
  if (!(beta >= 0.0))
    PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                        "Beta must not be negative, but is " << beta << ".");
  for (std::size_t i = 0; i < values.size(); ++i)
    if (mask.values[i] && !std::isfinite(values.values[i]))
      PCL_THROW_EXCEPTION(pcl::BadArgumentException,
                          "A value in the mask is not finite.");
  return Walker(values, labels, mask, beta, threads).run();
}

} // namespace pcl::indoor
