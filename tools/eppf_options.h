/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "options.h"

#include <pcl/features/eppf_histogram.h>

#include <string>

namespace pcl::indoor::tool {

/** \brief The options of the EPPF descriptor on a command line. */
class EPPFCommandLine {
public:
  /** \brief Add the options to a parser; this object must outlive its run(). */
  void
  addTo(OptionParser& parser);

  /** \brief The options as given.
   * \throws ToolError if a text is none of its choices or the bins are unreadable
   */
  EPPFOptions
  options() const;

  /** \brief Whether the short form of 540 bins is wanted. */
  bool
  wantsShortForm() const
  {
    return short_form_;
  }

private:
  EPPFOptions options_;
  bool short_form_ = false;
  bool keeps_noise_ = false;
  bool thesis_ = false;
  std::string surface_angle_;
  std::string normals_;
  std::string sampling_;
  std::string without_;
  std::string bins_;
};

} // namespace pcl::indoor::tool
