/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/eppf_options.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace pcl::indoor::tool {
namespace {

// The names of an enumeration's values in turn; "default" is the descriptor's own.
const std::vector<std::string> rule_names = {
    "joint", "maximum", "minimum", "mean", "random", "both", "default"};
const std::vector<std::string> normal_angle_names = {
    "between", "around_line", "default"};
const std::vector<std::string> side_names = {
    "outward", "given", "ignored", "mostly_outward", "default"};
const std::vector<std::string> sampling_names = {"uniform", "stratified", "default"};
const std::vector<std::string> descriptor_names = {
    "pair_harmonics", "eppf", "eppf_short"};
const std::vector<std::string> feature_names = {
    "none", "distance", "surface_angle", "normal_angle", "occupancy", "harmonics"};

std::size_t
indexOf(const std::string& name, const std::vector<std::string>& names)
{
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) -
                                  names.begin());
}

/** \brief Change a value to the one that is named, if it is not "default". */
template <typename T>
void
choose(const std::string& name, const std::vector<std::string>& names, T& value)
{
  if (name != "default")
    value = static_cast<T>(indexOf(name, names));
}

EPPFBins
readBins(const std::string& text)
{
  std::istringstream stream(text);
  std::vector<int> counts;
  char comma = ',';
  for (int count = 0; comma == ',' && stream >> count;) {
    counts.push_back(count);
    comma = '\0';
    stream >> comma;
  }
  if (!stream.eof() || comma != '\0' || (counts.size() != 4 && counts.size() != 7))
    throw ToolError("-bins: '" + text +
                    "' is neither four numbers as in 20,4,5,3 nor seven as in "
                    "8,15,5,1,3,6,12");
  EPPFBins bins{counts[0], counts[1], counts[2], counts[3], {}};
  if (counts.size() == 7)
    bins.harmonics = {counts[4], counts[5], counts[6]};
  return bins;
}

} // namespace

const std::string&
descriptorName(EPPFDescriptor descriptor)
{
  return descriptor_names[static_cast<std::size_t>(descriptor)];
}

EPPFOptions
optionsOf(EPPFDescriptor descriptor)
{
  switch (descriptor) {
  case EPPFDescriptor::EPPF:
    return thesisEPPFOptions();
  case EPPFDescriptor::EPPFShort:
    return shortEPPFOptions();
  default:
    return pairHarmonicsOptions();
  }
}

void
EPPFCommandLine::addTo(OptionParser& parser)
{
  surface_angle_ = normal_angle_ = sampling_ = normals_ = bins_ = "default";
  without_ = feature_names.front();
  parser
      .number("-pairs",
              options_.pair_count,
              "point pairs drawn per object",
              "",
              Range::between(1, 4294967295.0))
      .number("-scale",
              options_.scale,
              "length the distance bins spread over; 0: each object's own extent",
              "m",
              Range::atLeast(0))
      .number("-seed", options_.seed, "the same seed draws the same pairs")
      .number("-threads", options_.number_of_threads, "threads; 0: all of the machine")
      .text(
          "-bins",
          bins_,
          "bins of distance, surface angle, normal angle, occupancy; shells and degree "
          "of harmonics, distances from the middle")
      .number("-grid_size",
              grid_size_,
              "edge of the occupancy grid, 2 to 64; 0: from the number of points; -1: "
              "the descriptor's own",
              "voxels",
              Range::between(-1, 64))
      .number("-weighting_constant",
              options_.weighting_constant,
              "larger gives near pairs more weight",
              "",
              {1.0, std::numeric_limits<double>::infinity(), true})
      .flag("-keep_noise", keeps_noise_, "do not measure and lower the noise of points")
      .text("-surface_angle", surface_angle_, "how two angles become one", rule_names)
      .text("-normal_angle",
            normal_angle_,
            "which angle two normals have",
            normal_angle_names)
      .text("-sampling", sampling_, "how pairs are chosen", sampling_names)
      .text("-without", without_, "a feature to leave out", feature_names)
      .text("-normals", normals_, "the side of a surface they point to", side_names)
      .expert({"-bins",
               "-grid_size",
               "-weighting_constant",
               "-keep_noise",
               "-surface_angle",
               "-normal_angle",
               "-sampling",
               "-without",
               "-normals"});
}

void
EPPFCommandLine::addDescriptorTo(OptionParser& parser, EPPFDescriptor standard)
{
  descriptor_ = descriptorName(standard);
  parser.text("-descriptor",
              descriptor_,
              "what tells most, or EPPF as in the thesis, or its short form",
              descriptor_names);
}

EPPFDescriptor
EPPFCommandLine::descriptor() const
{
  auto descriptor = EPPFDescriptor::PairHarmonics;
  if (!descriptor_.empty())
    choose(descriptor_, descriptor_names, descriptor);
  return descriptor;
}

EPPFOptions
EPPFCommandLine::options() const
{
  auto options = optionsOf(descriptor());
  options.pair_count = options_.pair_count;
  options.scale = options_.scale;
  options.seed = options_.seed;
  options.number_of_threads = options_.number_of_threads;
  options.weighting_constant = options_.weighting_constant;
  choose(surface_angle_, rule_names, options.surface_angle_rule);
  choose(normal_angle_, normal_angle_names, options.normal_angle_rule);
  choose(normals_, side_names, options.normal_sides);
  choose(sampling_, sampling_names, options.sampling);
  if (bins_ != "default")
    options.bins = readBins(bins_);
  if (grid_size_ >= 0)
    options.grid_size = grid_size_;
  if (keeps_noise_)
    options.denoising = false;
  const auto without = indexOf(without_, feature_names);
  options.features = {
      without != 1, without != 2, without != 3, without != 4, without != 5};
  const auto problem = findProblem(options);
  if (!problem.empty())
    throw ToolError(problem);
  return options;
}

void
requireFittingBins(const EPPFCommandLine& options)
{
  const auto bins = options.options().bins.size();
  const auto expected = optionsOf(options.descriptor()).bins.size();
  if (bins != expected)
    throw ToolError("-bins: there must be " + std::to_string(expected) + " for " +
                    descriptorName(options.descriptor()) + ", not " +
                    std::to_string(bins));
}

} // namespace pcl::indoor::tool
