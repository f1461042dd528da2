/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "furniture/part_maker.h"

#include <algorithm>

namespace pcl::indoor {

namespace {

using Size = Eigen::Vector3d;

// Bowls and plates: their walls rise ever steeper.
void
bowl(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  const double foot = draw.uniform(0.35, 0.7), belly = draw.uniform(0.8, 0.95);
  make.hollow("bowl",
              {-x, -y, x, y},
              {{foot, 0}, {belly, 0.45 * z}, {1, z}},
              draw.uniform(0.002, 0.006));
}

// Mugs, pots and buckets: upright walls, most of them with handles.
void
mug(PartMaker& make, const Size& size, RandomDraw& draw)
{
  const double z = size.z(), thick = draw.uniform(0.002, 0.005);
  const int handles = draw.pick(3);
  const double grip = handles > 0 ? 0.15 * size.x() : 0.0; // how far it stands out
  const double right = size.x() / 2 - grip,
               left = handles == 2 ? -right : -size.x() / 2;
  const double y = std::min(size.y() / 2, (right - left) / 2);
  make.hollow(
      "mug", {left, -y, right, y}, {{draw.uniform(0.75, 1.0), 0}, {1, z}}, thick);
  const double low = draw.uniform(0.2, 0.5) * z, high = draw.uniform(0.7, 0.9) * z;
  for (int i = 0; i < handles; ++i) {
    const double side = i == 0 ? 1 : -1, radius = draw.uniform(0.004, 0.008);
    const double near = side * (right - 0.01), far = side * (right + grip - radius);
    make.rod("handle", {near, 0, high}, {far, 0, high}, radius);
    make.rod("handle", {far, 0, high}, {far, 0, low}, radius);
    make.rod("handle", {far, 0, low}, {near, 0, low}, radius);
    make.join(3, "handle");
  }
}

} // namespace

std::vector<FurnitureClass>
vesselClasses()
{
  return {{"bowl", {0.1, 0.1, 0.03}, {0.3, 0.3, 0.14}, bowl},
          {"mug", {0.08, 0.08, 0.08}, {0.26, 0.2, 0.2}, mug}};
}

} // namespace pcl::indoor
