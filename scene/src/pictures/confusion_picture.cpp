/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pictures/confusion_picture.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor::tool {

Picture
confusionPicture(const ConfusionMatrix& confusion,
                 const std::vector<std::string>& names)
{
  const Color black{0, 0, 0};
  constexpr int cell = 26;
  const int n = static_cast<int>(names.size());
  int margin = 20;
  for (const auto& name : names)
    margin = std::max(margin, Picture::textWidth(name) + 34);
  Picture picture(margin + n * cell + 10, 30 + n * cell + 10);
  for (int row = 0; row < n; ++row) {
    const auto truth = static_cast<std::size_t>(row);
    const double objects = static_cast<double>(confusion.objectCount(truth));
    const std::string number = std::to_string(row + 1);
    picture.drawText(6, 30 + row * cell + 9, number + " " + names[truth], black);
    picture.drawText(margin + row * cell + 8, 14, number, black);
    for (int column = 0; column < n; ++column) {
      const double count =
          static_cast<double>(confusion.at(truth, static_cast<std::size_t>(column)));
      const double share = objects > 0.0 ? count / objects : 0.0;
      const int x = margin + column * cell;
      const int y = 30 + row * cell;
      picture.fillRectangle(x, y, cell - 1, cell - 1, heatColor(share));
      if (count > 0.0)
        picture.drawText(x + 3,
                         y + 9,
                         std::to_string(std::lround(100 * share)),
                         share > 0.5 ? black : Color());
    }
  }
  return picture;
}

} // namespace pcl::indoor::tool
