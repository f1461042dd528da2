/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "retrieval/descriptor_variants.h"

#include <sstream>
#include <utility>

namespace pcl::indoor::tool {
namespace {

/** Collects descriptors that each differ from some options in a few. */
class Variants {
public:
  explicit Variants(const EPPFOptions& options)
  : options_(options)
  {}

  template <typename Change>
  void
  add(const std::string& name, const Change& change)
  {
    auto changed = options_;
    change(changed);
    descriptors_.push_back(eppfDescriptor(name, changed));
  }

  void
  addUnchanged(const std::string& name)
  {
    add(name, [](auto&) {});
  }

  void
  addWithoutAngles()
  {
    add("without f1", [](auto& o) { o.features.distance = false; });
    add("without f2", [](auto& o) { o.features.surface_angle = false; });
    add("without f3", [](auto& o) { o.features.normal_angle = false; });
  }

  std::vector<RetrievalDescriptor>
  take()
  {
    return std::move(descriptors_);
  }

private:
  EPPFOptions options_;
  std::vector<RetrievalDescriptor> descriptors_;
};

void
addFeatures(Variants& variants)
{
  variants.addWithoutAngles();
  variants.add("with f4", [](auto& o) { o.bins = {4, 15, 5, 2, o.bins.harmonics}; });
  variants.add("without harmonics", [](auto& o) { o.features.harmonics = false; });
  variants.add("pairs in all bins", [](auto& o) { o.bins = {16, 15, 5, 1, {}}; });
}

void
addSurfaceAngles(Variants& variants)
{
  for (const auto& [name, rule] :
       {std::make_pair("maximum", SurfaceAngleRule::Maximum),
        std::make_pair("minimum", SurfaceAngleRule::Minimum),
        std::make_pair("mean", SurfaceAngleRule::Mean),
        std::make_pair("random", SurfaceAngleRule::RandomOne),
        std::make_pair("both, not f4", SurfaceAngleRule::BothInsteadOfOccupancy)})
    variants.add(name, [rule = rule](auto& o) {
      o.surface_angle_rule = rule; // 8 x 5 x 5 x 3 bins, f4 among them
      o.bins = {8, 5, 5, 3, o.bins.harmonics};
    });
}

void
addNormals(Variants& variants)
{
  variants.add("outward", [](auto& o) { o.normal_sides = NormalSides::Outward; });
  variants.add("given", [](auto& o) { o.normal_sides = NormalSides::Given; });
  variants.add("angle between",
               [](auto& o) { o.normal_angle_rule = NormalAngleRule::Between; });
  variants.add("ignored", [](auto& o) { o.normal_sides = NormalSides::Ignored; });
}

void
addScales(Variants& variants)
{
  for (const double scale : {0.5, 0.7, 1.0, 1.2, 1.4, 1.7, 2.0}) {
    std::ostringstream name;
    name << "scale " << scale << " m";
    variants.add(name.str(), [scale](auto& o) { o.scale = scale; });
  }
}

void
addGrids(Variants& variants)
{
  for (const int size : {8, 16, 24, 32, 48, 64})
    variants.add("f4, grid " + std::to_string(size), [size](auto& o) {
      o.bins = {4, 15, 5, 2, o.bins.harmonics};
      o.grid_size = size;
    });
}

void
addSamplings(Variants& variants)
{
  for (const std::size_t count : {2000u, 5000u, 10000u, 20000u, 50000u})
    for (const auto& [name, sampling] :
         {std::make_pair("uniform ", PairSampling::Uniform),
          std::make_pair("stratified ", PairSampling::Stratified)})
      variants.add(name + std::to_string(count), [count, sampling = sampling](auto& o) {
        o.sampling = sampling;
        o.pair_count = count;
      });
}

} // namespace

std::vector<RetrievalDescriptor>
harmonicsVariants(const std::string& what, const EPPFOptions& options)
{
  Variants variants(options);
  variants.addUnchanged("pair_harmonics");
  for (const auto& [name, add] : {std::make_pair("features", addFeatures),
                                  std::make_pair("surface_angle", addSurfaceAngles),
                                  std::make_pair("normals", addNormals),
                                  std::make_pair("scale", addScales),
                                  std::make_pair("grid", addGrids),
                                  std::make_pair("sampling", addSamplings)})
    if (what == name)
      add(variants);
  return variants.take();
}

std::vector<RetrievalDescriptor>
thesisVariants(const std::string& what,
               const EPPFOptions& options,
               const SetScale& scale)
{
  Variants variants(options);
  if (what == "thesis_scale") {
    variants.add("maximum", [&](auto& o) { o.scale = scale.largest; });
    variants.add("median", [&](auto& o) { o.scale = scale.median; });
    variants.add("unit cube", [](auto& o) { o.scale = 0; });
  }
  else if (what == "thesis_features") {
    variants.addUnchanged("eppf");
    variants.addWithoutAngles();
    variants.add("without f4", [](auto& o) { o.features.occupancy = false; });
  }
  else
    for (const auto& [name, rule] :
         {std::make_pair("maximum", SurfaceAngleRule::Maximum),
          std::make_pair("minimum", SurfaceAngleRule::Minimum),
          std::make_pair("mean", SurfaceAngleRule::Mean),
          std::make_pair("one only", SurfaceAngleRule::RandomOne),
          std::make_pair("both instead of f4",
                         SurfaceAngleRule::BothInsteadOfOccupancy)})
      variants.add(name, [rule = rule](auto& o) { o.surface_angle_rule = rule; });
  return variants.take();
}

} // namespace pcl::indoor::tool
