/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/tool_error.h"
#include "text/pcl_errors.h"

#include <pcl/features/eppf.h>

#include <cmath>
#include <string>

namespace pcl::indoor::tool {

/** \brief The descriptor of an object.
 * \param[in] name of the object, for the message
 * \throws ToolError if it cannot be described */
template <typename SignatureT>
SignatureT
describedObject(const PointCloud<PointNormal>::ConstPtr& object,
                const EPPFOptions& options,
                const std::string& name)
{
  EPPFEstimation<PointNormal, PointNormal, SignatureT> estimation;
  estimation.setOptions(options);
  estimation.setInputCloud(object);
  estimation.setInputNormals(object);
  PointCloud<SignatureT> descriptor;
  const auto problem = problemOf([&] { estimation.compute(descriptor); });
  if (descriptor.empty())
    throw ToolError(name + ": " + problem);
  if (!std::isfinite(descriptor[0].histogram[0]))
    throw ToolError(name + ": no two points with normals that differ in position");
  return descriptor[0];
}

} // namespace pcl::indoor::tool
