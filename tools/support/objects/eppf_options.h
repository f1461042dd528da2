/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "command_line/options.h"

#include <pcl/features/eppf_histogram.h>

#include <string>

namespace pcl::indoor::tool {

/** \brief The descriptors that EPPFEstimation computes, the default one first. */
enum class EPPFDescriptor { PairHarmonics, EPPF, EPPFShort };

/** \brief For example "pair_harmonics", as its PCD field. */
const std::string&
descriptorName(EPPFDescriptor descriptor);

/** \brief The options that a descriptor stands for. */
EPPFOptions
optionsOf(EPPFDescriptor descriptor);

/** \brief The options of EPPFEstimation on a command line. */
class EPPFCommandLine {
public:
  /** \brief Add the options to a parser; this object must outlive its run(). */
  void
  addTo(OptionParser& parser);

  /** \brief Add the option that chooses the descriptor.
   * \param[in] standard the one that is taken where it is not given */
  void
  addDescriptorTo(OptionParser& parser,
                  EPPFDescriptor standard = EPPFDescriptor::PairHarmonics);

  /** \brief The descriptor chosen. */
  EPPFDescriptor
  descriptor() const;

  /** \brief The options of the descriptor, but for those that were given.
   * \throws ToolError if the bins are unreadable or an option is out of its range
   */
  EPPFOptions
  options() const;

private:
  EPPFOptions options_; ///< those that all descriptors have in common
  int grid_size_ = -1;
  bool keeps_noise_ = false;
  std::string descriptor_;
  std::string surface_angle_;
  std::string normal_angle_;
  std::string normals_;
  std::string sampling_;
  std::string without_;
  std::string bins_;
};

/** \brief Find out that the bins are not as many as the descriptor has.
 * \throws ToolError if they are not */
void
requireFittingBins(const EPPFCommandLine& options);

} // namespace pcl::indoor::tool
