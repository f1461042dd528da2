/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/features/eppf_histogram.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief An object of the experiment: its points and normals, together and apart. */
struct RetrievalObject {
  PointCloud<PointNormal>::Ptr surface;
  PointCloud<PointXYZ>::Ptr points; ///< finite ones
  PointCloud<Normal>::Ptr normals;  ///< one per point, with curvature
};

/** \brief Split an object for the descriptors; curvatures are estimated where all are
 * 0. */
RetrievalObject
makeRetrievalObject(const PointCloud<PointNormal>& surface, int neighbor_count);

/** \brief A descriptor to compare. */
struct RetrievalDescriptor {
  std::string name;
  bool is_random = true;  ///< whether another seed gives another result
  bool may_abort = false; ///< whether describing may end the process
  /** \brief The histogram of an object; NaN or empty if there is none. */
  std::function<std::vector<float>(const RetrievalObject&, std::uint32_t seed)>
      describe;
};

/** \brief EPPF with given options. */
RetrievalDescriptor
eppfDescriptor(const std::string& name, const EPPFOptions& options);

/** \brief Wahl's surflet pairs with 5 or 6 bins per feature. */
RetrievalDescriptor
surfletPairDescriptor(int bin_count);

/** \brief PCL's ESF, VFH, OUR-CVFH (first signature), GASD, GRSD, and SHOT of the whole
 * object. */
std::vector<RetrievalDescriptor>
peerDescriptors();

} // namespace pcl::indoor::tool
