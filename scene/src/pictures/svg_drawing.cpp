/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pictures/svg_drawing.h"

#include "pictures/png_bytes.h"
#include "text/base64.h"
#include "text/printable.h"

#include <algorithm>
#include <cmath>

namespace pcl::indoor::tool {
namespace {

constexpr const char* font =
    "font-family=\"'Source Sans 3','Segoe UI',Helvetica,Arial,'DejaVu Sans',"
    "sans-serif\"";

std::string
css(Color color)
{
  return formatted("#%02x%02x%02x", color.red, color.green, color.blue);
}

} // namespace

std::string
xmlText(const std::string& text)
{
  std::string escaped;
  for (const char c : printable(text, text.size()))
    if (c == '&' || c == '<' || c == '>' || c == '"')
      escaped += "&#" + std::to_string(int(c)) + ";";
    else
      escaped += c;
  return escaped;
}

SvgDrawing::SvgDrawing(double width, double height, bool has_background)
: width_(std::ceil(width))
, height_(std::ceil(height))
, has_background_(has_background)
{}

void
SvgDrawing::rectangle(const Place& corner, const Place& size, Color fill)
{
  add(formatted("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" "
                "fill=\"%s\"/>\n",
                corner.x(),
                corner.y(),
                size.x(),
                size.y(),
                css(fill).c_str()));
}

void
SvgDrawing::line(const std::vector<Place>& places,
                 Color color,
                 double thickness,
                 bool is_dashed)
{
  std::string points;
  for (const auto& place : places)
    points += formatted(" %.1f,%.1f", place.x(), place.y());
  add(formatted("<polyline fill=\"none\" stroke=\"%s\" stroke-width=\"%.1f\" "
                "stroke-linejoin=\"round\"%s points=\"",
                css(color).c_str(),
                thickness,
                is_dashed ? " stroke-dasharray=\"6,3\"" : "") +
      points + "\"/>\n");
}

void
SvgDrawing::circle(const Place& middle, double radius, Color fill, Color border)
{
  add(formatted("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"%s\" "
                "stroke=\"%s\" stroke-width=\"1.5\"/>\n",
                middle.x(),
                middle.y(),
                radius,
                css(fill).c_str(),
                css(border).c_str()));
}

void
SvgDrawing::text(const Place& place, const std::string& text, const TextStyle& style)
{
  constexpr const char* anchors[] = {"start", "middle", "end"};
  const auto x = place.x(), y = place.y();
  add(formatted("<text x=\"%.1f\" y=\"%.1f\" dy=\".36em\" text-anchor=\"%s\" "
                "font-size=\"%g\" fill=\"%s\"",
                x,
                y,
                anchors[static_cast<int>(style.anchor)],
                style.size,
                css(style.color).c_str()) +
      (style.is_bold ? " font-weight=\"600\"" : "") +
      (style.has_halo ? " stroke=\"white\" stroke-width=\"4\" "
                        "stroke-linejoin=\"round\" paint-order=\"stroke\""
                      : "") +
      (style.turn != 0.0
           ? formatted(" transform=\"rotate(%g %.1f %.1f)\"", style.turn, x, y)
           : "") +
      ">" + xmlText(text) + "</text>\n");
}

void
SvgDrawing::image(const Place& corner, const PixelImage& image)
{
  const auto png =
      pngBytes(image.width(), image.height(), [&image](int y) { return image.row(y); });
  add(formatted("<image x=\"%.1f\" y=\"%.1f\" width=\"%d\" height=\"%d\" "
                "href=\"data:image/png;base64,",
                corner.x(),
                corner.y(),
                image.width(),
                image.height()) +
      base64(png) + "\"/>\n");
}

void
SvgDrawing::drawing(const Place& corner, const SvgDrawing& other)
{
  add(formatted("<g transform=\"translate(%.1f %.1f)\">\n", corner.x(), corner.y()) +
      other.content_ + "</g>\n");
}

void
SvgDrawing::scaleBar(const Place& left, double units_per_metre, double text_size)
{
  constexpr double least = 60.0; // units
  int metres = 1;
  for (int k = 0; metres * units_per_metre < least && metres < 1000; ++k)
    metres = metres * (k % 3 == 1 ? 5 : 4) / 2; // 1, 2, 5, 10, 20, ...
  const double end = left.x() + metres * units_per_metre, tick = 0.5 * text_size;
  add(formatted(
      "<path id=\"scale\" stroke=\"black\" stroke-width=\"%.1f\" fill=\"none\" "
      "d=\"M%.1f,%.1fv%.1fH%.1fv%.1fM%.1f,%.1fv%.1f\"/>\n",
      text_size / 12.0,
      left.x(),
      left.y() - 0.5 * tick,
      tick,
      end,
      -tick,
      0.5 * (left.x() + end),
      left.y() + 0.5 * tick,
      -0.7 * tick));
  text({end + 0.7 * text_size, left.y()},
       formatted("%d m", metres),
       {Anchor::Start, text_size});
}

std::string
SvgDrawing::str() const
{
  return formatted("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f "
                   "%.0f\" width=\"%.0f\" height=\"%.0f\" ",
                   width_,
                   height_,
                   width_,
                   height_) +
         font + " font-size=\"14\" text-anchor=\"middle\">\n" +
         (has_background_ ? "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
                          : "") +
         content_ + "</svg>\n";
}

double
SvgDrawing::textWidth(const std::string& text, const TextStyle& style)
{
  const auto is_letter = [](char c) { return (c & 0xc0) != 0x80; }; // of UTF-8
  return (style.is_bold ? 0.7 : 0.62) * style.size *
         static_cast<double>(std::count_if(text.begin(), text.end(), is_letter));
}

SvgDrawing
stacked(const std::vector<SvgDrawing>& drawings, double gap)
{
  double width = 1.0, height = 0.0;
  for (const auto& drawing : drawings) {
    width = std::max(width, drawing.width());
    height += (height > 0.0 ? gap : 0.0) + drawing.height();
  }
  SvgDrawing all(width, std::max(height, 1.0));
  double top = 0.0;
  for (const auto& drawing : drawings) {
    all.drawing({0.0, top}, drawing);
    top += drawing.height() + gap;
  }
  return all;
}

SvgDrawing
stackedStoreys(const std::vector<SvgDrawing>& storeys, double left, double gap)
{
  constexpr double caption = 36.0;
  std::vector<SvgDrawing> parts;
  for (std::size_t s = storeys.size(); s-- > 0;) {
    const double top = storeys.size() > 1 ? caption : 0.0;
    parts.emplace_back(storeys[s].width(), top + storeys[s].height());
    if (top > 0.0)
      parts.back().text(
          {left, 0.5 * top}, "Storey " + std::to_string(s), {Anchor::Start, 24.0});
    parts.back().drawing({0.0, top}, storeys[s]);
  }
  return stacked(parts, gap);
}

} // namespace pcl::indoor::tool
