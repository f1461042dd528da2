/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "objects/loaded_objects.h"

namespace pcl::indoor::tool {

LabelledObjects
loadedObjects(const std::string& folder,
              int neighbor_count,
              unsigned int number_of_threads,
              Progress& progress)
{
  progress.start("Loading " + folder);
  auto objects = loadLabelledObjects(
      folder,
      neighbor_count,
      number_of_threads,
      [&](std::size_t done, std::size_t all) { progress.update(done, all); });
  progress.done(std::to_string(objects.paths.size()) + " objects of " +
                std::to_string(objects.class_names.size()) + " classes");
  return objects;
}

} // namespace pcl::indoor::tool
