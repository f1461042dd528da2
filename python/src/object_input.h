/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/scan_content.h"
#include "objects/object_files.h"

#include <pcl/io/scan_file.h>

#include <string>
#include <variant>

namespace pcl::indoor::python {

/** \brief What an object is given as: its points, or a file, which may be a mesh. */
using ObjectInput = std::variant<std::string, Scan>;

/** \brief The object with normals. */
inline tool::PlacedObject
objectOf(const ObjectInput& input, int neighbor_count)
{
  if (const auto* const path = std::get_if<std::string>(&input))
    return tool::loadPlacedObject(*path, neighbor_count);
  return tool::placedObject(std::get<Scan>(input).content().file, neighbor_count);
}

/** \brief What it is called in messages. */
inline std::string
nameOf(const ObjectInput& input)
{
  if (const auto* const path = std::get_if<std::string>(&input))
    return *path;
  return std::get<Scan>(input).name();
}

} // namespace pcl::indoor::python
