/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "training/training_pool.h"

#include <pcl/indoor/parallel_for.h>

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
  parallelFor(static_cast<std::ptrdiff_t>(used.size()),
              static_cast<int>(number_of_threads),
              1,
              [&](std::ptrdiff_t i) {
                const auto k = static_cast<std::size_t>(i);
                set.inputs[k] = drawsOf(*objects.clouds[used[k]],
                                        objects.places[used[k]],
                                        options,
                                        used[k]);
#pragma omp critical(pcl_indoor_progress)
                progress.update(++done, used.size());
              });
  std::vector<std::string> problems(used.size());
  for (std::size_t k = 0; k < used.size(); ++k) {
    set.labels.push_back(objects.labels[used[k]]);
    if (set.inputs[k].empty())
      problems[k] = objects.paths[used[k]] +
                    ": no two points with normals that differ in position";
  }
  requireNoProblems(problems, "such objects");
  return set;
}

} // namespace pcl::indoor::tool
