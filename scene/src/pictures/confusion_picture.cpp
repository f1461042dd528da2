/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pictures/confusion_picture.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor::tool {
namespace {

constexpr double cell = 26.0, gap = 6.0, heading_height = 24.0;

constexpr const char* heading = "Predicted class, % of the true one's objects";

/** White for 0, dark blue for 1. */
Color
shareColor(double share)
{
  const auto mixed = [share](double dark) {
    return static_cast<std::uint8_t>(std::lround(255.0 + share * (dark - 255.0)));
  };
  return {mixed(8.0), mixed(64.0), mixed(129.0)};
}

} // namespace

SvgDrawing
confusionPicture(const ConfusionMatrix& confusion,
                 const std::vector<std::string>& names)
{
  double margin = 80.0;
  for (const auto& name : names)
    margin = std::max(margin, heading_height + SvgDrawing::textWidth(name) + gap);
  const double size = cell * static_cast<double>(names.size());
  SvgDrawing picture(margin + std::max(size, SvgDrawing::textWidth(heading)) + 10.0,
                     margin + size + 10.0);
  picture.text({margin, 0.5 * heading_height}, heading);
  picture.text({0.5 * heading_height, margin + 0.5 * size},
               "True class",
               {Anchor::Middle, 12.0, -90.0});
  picture.rectangle({margin - 1.0, margin - 1.0}, {size + 1.0, size + 1.0}, light_grey);
  for (std::size_t row = 0; row < names.size(); ++row) {
    const double y = margin + cell * static_cast<double>(row);
    const double across = y + 0.5 * (cell - 1.0);
    picture.text({margin - gap, across}, names[row], {Anchor::End});
    picture.text({across, margin - gap}, names[row], {Anchor::Start, 12.0, -90.0});
    const auto objects = static_cast<double>(confusion.objectCount(row));
    for (std::size_t column = 0; column < names.size(); ++column) {
      const double x = margin + cell * static_cast<double>(column);
      const auto count = static_cast<double>(confusion.at(row, column));
      const double share = objects > 0.0 ? count / objects : 0.0;
      picture.rectangle({x, y}, {cell - 1.0, cell - 1.0}, shareColor(share));
      if (count > 0.0)
        picture.text(
            {x + 0.5 * (cell - 1.0), across},
            std::to_string(std::lround(100.0 * share)),
            {Anchor::Middle, 11.0, 0.0, false, false, share > 0.5 ? paper : ink});
    }
  }
  return picture;
}

} // namespace pcl::indoor::tool
