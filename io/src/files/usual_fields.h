/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/PCLPointCloud2.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

struct CloudFile;

/** \brief Gives the fields of other programs' files PCL's names and types, so that all
 * tools find them: x, y, z as real numbers, normal_x, normal_y, normal_z, and rgb.
 *
 * Taken are, in letters of any size, x y z; nx ny nz and normalx normaly normalz; rgb;
 * red green blue, diffuse_red ... and r g b, each only if all three are there and none
 * has PCL's name. Whole numbers of coordinates become doubles. Colours of one byte
 * become rgb, with alpha rgba; of others, rgb is added and they stay. All other fields
 * stay as they are.
 */
class UsualFields {
public:
  /** \param[in] layout the fields; its points are not looked at
   * \param[in] points gives all points, or some from all over the file, see
   * sampleBlocks(): their values tell what range colours have; called at most once
   */
  UsualFields(const PCLPointCloud2& layout,
              const std::function<const PCLPointCloud2&()>& points);

  /** \brief What was odd and how it was taken, a line each. */
  const std::vector<std::string>&
  notes() const
  {
    return notes_;
  }

  /** \brief Points of the layout that was given with PCL's fields; only the layout of a
   * cloud without bytes. */
  PCLPointCloud2
  of(PCLPointCloud2 cloud) const;

private:
  /** A field of the result and where it comes from. */
  struct Part {
    PCLPointField field;
    std::vector<PCLPointField> from; ///< several for a colour: blue, green, red, alpha
    double scale = 0.0;              ///< of a colour, to bytes
  };

  void
  nameAxes();

  void
  nameNormals();

  void
  nameColors(const std::function<const PCLPointCloud2&()>& points);

  void
  packColors(const std::vector<std::size_t>& colors, const std::string& names);

  void
  addColors(const std::vector<std::size_t>& colors,
            const std::string& names,
            const PCLPointCloud2& points);

  /** Converts values. */
  void
  write(const Part& part, const PCLPointCloud2& from, PCLPointCloud2& to) const;

  std::vector<Part> parts_;
  std::vector<std::string> notes_;
  bool only_names_ = true; ///< the bytes stay
};

/** \brief The same of a whole file, with its notes.
 * \throws ToolError if it has fewer bytes than points */
void
nameFields(CloudFile& file);

} // namespace pcl::indoor::tool
