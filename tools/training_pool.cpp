/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "training_pool.h"

#include "options.h" // for ToolError
#include "parallel_objects.h"

namespace pcl::indoor::tool {

TrainingSet
trainingPool(const LabelledObjects& objects,
             const std::vector<std::size_t>& used,
             const DrawOptions& options,
             unsigned int number_of_threads,
             Progress& progress)
{
  TrainingSet set;
  set.inputs.resize(used.size());
  std::size_t done = 0;
  forEachObject(used.size(), number_of_threads, [&](std::size_t k) {
    set.inputs[k] =
        drawsOf(*objects.clouds[used[k]], objects.places[used[k]], options, used[k]);
#pragma omp critical(pcl_indoor_progress)
    progress.update(++done, used.size());
  });
  std::string first;
  std::size_t problems = 0;
  for (std::size_t k = 0; k < used.size(); ++k) {
    set.labels.push_back(objects.labels[used[k]]);
    if (set.inputs[k].empty() && problems++ == 0)
      first = objects.paths[used[k]];
  }
  if (problems > 0)
    throw ToolError(first + ": no two points with normals that differ in position" +
                    (problems > 1
                         ? " (the first of " + std::to_string(problems) +
                               " such objects of " + std::to_string(used.size()) + ")"
                         : std::string()));
  return set;
}

} // namespace pcl::indoor::tool
