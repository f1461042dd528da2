/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "pictures/pixel_image.h"
#include "text/formatted.h"

#include <pcl/indoor/exports.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Any text as it may stand in XML and HTML, in attributes too. */
std::string
xmlText(const std::string& text);

enum class Anchor { Start, Middle, End };

struct TextStyle {
  Anchor anchor = Anchor::Start; ///< what of the text lies at its place
  double size = 12.0;
  double turn = 0.0; ///< degrees, clockwise
  bool is_bold = false;
  bool has_halo = false; ///< white, for texts upon maps
  Color color = ink;
};

/** \brief A drawing in SVG. y points down; what is added later lies above. */
class PCL_INDOOR_EXPORTS SvgDrawing {
public:
  using Place = Eigen::Vector2d;

  /** \brief Rounds the size up, so that a unit is as many pixels in the middle as at
   * the border: images stay exact.
   * \param[in] has_background without it the drawing is transparent
   */
  SvgDrawing(double width, double height, bool has_background = true);

  double
  width() const
  {
    return width_;
  }

  double
  height() const
  {
    return height_;
  }

  void
  rectangle(const Place& corner, const Place& size, Color fill);

  void
  line(const std::vector<Place>& places,
       Color color,
       double thickness = 1.0,
       bool is_dashed = false);

  void
  circle(const Place& middle, double radius, Color fill, Color border);

  /** \brief A line of text whose height has its middle at the place. */
  void
  text(const Place& place, const std::string& text, const TextStyle& style = {});

  /** \brief Pixels as squares of one unit: exact where a unit is drawn as a pixel, and
   * the place is whole. */
  void
  image(const Place& corner, const PixelImage& image);

  /** \brief Another drawing, without its background. */
  void
  drawing(const Place& corner, const SvgDrawing& other);

  /** \brief A bar of 1, 2, 5, 10, ... metres with its length beside it, as high as its
   * text. */
  void
  scaleBar(const Place& left, double units_per_metre, double text_size = 12.0);

  /** \brief Elements of SVG. */
  void
  add(const std::string& elements)
  {
    content_ += elements;
  }

  /** \brief The document. */
  std::string
  str() const;

  /** \brief About the width of a text, rather more. */
  static double
  textWidth(const std::string& text, const TextStyle& style = {});

private:
  double width_;
  double height_;
  bool has_background_;
  std::string content_;
};

/** \brief Drawings below each other. */
PCL_INDOOR_EXPORTS SvgDrawing
stacked(const std::vector<SvgDrawing>& drawings, double gap = 0.0);

/** \brief Drawings of storeys below each other, the highest on top; several have their
 * numbers above them.
 * \param[in] storeys from below
 * \param[in] left where the words begin
 */
SvgDrawing
stackedStoreys(const std::vector<SvgDrawing>& storeys, double left, double gap = 0.0);

} // namespace pcl::indoor::tool
