/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "eppf_options.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace pcl::indoor::tool {
namespace {

const std::vector<std::string> rule_names = {
    "joint", "maximum", "minimum", "mean", "random", "both"};
const std::vector<std::string> side_names = {"outward", "given", "ignored"};
const std::vector<std::string> sampling_names = {"uniform", "stratified"};
const std::vector<std::string> feature_names = {
    "none", "distance", "surface_angle", "normal_angle", "occupancy", "harmonics"};

std::size_t
indexOf(const std::string& name, const std::vector<std::string>& names)
{
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) -
                                  names.begin());
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
                    "4,15,5,2,3,6,12");
  EPPFBins bins{counts[0], counts[1], counts[2], counts[3], {}};
  if (counts.size() == 7)
    bins.harmonics = {counts[4], counts[5], counts[6]};
  return bins;
}

std::string
binsText(const EPPFBins& bins)
{
  std::ostringstream text;
  text << bins.distance << ',' << bins.surface_angle << ',' << bins.normal_angle << ','
       << bins.occupancy << ',' << bins.harmonics.shells << ',' << bins.harmonics.degree
       << ',' << bins.harmonics.distances;
  return text.str();
}

} // namespace

void
EPPFCommandLine::addTo(OptionParser& parser)
{
  surface_angle_ = rule_names[static_cast<std::size_t>(options_.surface_angle_rule)];
  sampling_ = sampling_names[static_cast<std::size_t>(options_.sampling)];
  normals_ = side_names[static_cast<std::size_t>(options_.normal_sides)];
  without_ = feature_names.front();
  bins_ = binsText(options_.bins);
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
      .flag("-short", short_form_, "the short form of 540 bins")
      .number("-grid_size",
              options_.grid_size,
              "edge of the occupancy grid, 2 to 64; 0: from the number of points",
              "voxels",
              Range::between(0, 64))
      .number("-weighting_constant",
              options_.weighting_constant,
              "larger gives near pairs more weight",
              "",
              {1.0, std::numeric_limits<double>::infinity(), true})
      .flag("-keep_noise", keeps_noise_, "do not measure and lower the noise of points")
      .text("-surface_angle", surface_angle_, "how two angles become one", rule_names)
      .text("-sampling", sampling_, "how pairs are chosen", sampling_names)
      .text("-without", without_, "a feature to leave out", feature_names)
      .text("-normals", normals_, "the side of a surface they point to", side_names)
      .flag("-thesis",
            thesis_,
            "the setting of the thesis for all but pairs, scale, seed");
}

EPPFOptions
EPPFCommandLine::options() const
{
  auto options = options_;
  options.surface_angle_rule =
      static_cast<SurfaceAngleRule>(indexOf(surface_angle_, rule_names));
  options.normal_sides = static_cast<NormalSides>(indexOf(normals_, side_names));
  options.sampling = static_cast<PairSampling>(indexOf(sampling_, sampling_names));
  options.bins = readBins(bins_);
  options.denoising = !keeps_noise_;
  if (thesis_) {
    const auto thesis = thesisEPPFOptions();
    options.surface_angle_rule = thesis.surface_angle_rule;
    options.normal_sides = thesis.normal_sides;
    options.sampling = thesis.sampling;
    options.bins = thesis.bins;
    options.grid_size = thesis.grid_size;
    options.denoising = thesis.denoising;
    options.weighting_constant = thesis.weighting_constant;
  }
  if (short_form_)
    options.bins = shortEPPFBins(options.surface_angle_rule);
  const auto without = indexOf(without_, feature_names);
  options.features = {
      without != 1, without != 2, without != 3, without != 4, without != 5};
  const auto problem = whatIsWrong(options);
  if (!problem.empty())
    throw ToolError(problem);
  return options;
}

} // namespace pcl::indoor::tool
