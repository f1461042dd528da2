/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "retrieval/retrieval_descriptors.h"

#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief The lengths that f1 may spread over, from the objects of a set (Fig. 5.12).
 */
struct SetScale {
  double largest = 0, median = 0; ///< extent of an object
};

/** \brief Variants of pair harmonics as those of EPPF in Fig. 5.11 to 5.13, and of its
 * other choices.
 * \param[in] what features, surface_angle, normals, scale, grid or sampling
 */
std::vector<RetrievalDescriptor>
harmonicsVariants(const std::string& what, const EPPFOptions& options);

/** \brief Variants of the thesis's descriptor with its bins: Fig. 5.11 to 5.13.
 * \param[in] what thesis_features, thesis_surface_angle or thesis_scale
 */
std::vector<RetrievalDescriptor>
thesisVariants(const std::string& what,
               const EPPFOptions& options,
               const SetScale& scale);

} // namespace pcl::indoor::tool
