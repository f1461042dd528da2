/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */

#include "rooms/space/grid_bricks.h"

namespace pcl::indoor {

GridBricks::GridBricks(const GridShape& shape)
: shape_{(shape.nx + 3) / 4, (shape.ny + 3) / 4, (shape.nz + 3) / 4}
{
  const Index x_step = static_cast<Index>(shape_.ny) * static_cast<Index>(shape_.nz);
  const Index y_step = static_cast<Index>(shape_.nz);
  brick_steps_ = {x_step, Index{0} - x_step, y_step, Index{0} - y_step, 1, ~Index{0}};
  for (int d = 0; d < 6; ++d)
    for (int v = 0; v < 64; ++v) {
      const bool leaves = (across(Bits{1} << v, d) != 0);
      const Index stride = static_cast<Index>(strides[d / 2]);
      const Index forward = leaves ? Index{0} - 3 * stride : stride;
      steps_[d][v] = (d % 2 == 0 ? forward : Index{0} - forward) +
                     (leaves ? 64 * brick_steps_[d] : Index{0});
    }
}

} // namespace pcl::indoor
