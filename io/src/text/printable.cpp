/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "text/printable.h"

#include <pcl/console/print.h>
#include <pcl/indoor/plain_message.h>

#include <charconv>
#include <cstdio>
#include <new>
#include <stdexcept>

namespace pcl::indoor::tool {
namespace {

/** Not a control character, nor one that changes the direction of writing. */
bool
isShown(const Character& character)
{
  const auto code = character.code;
  const bool controls = code < 0x20 || (code >= 0x7f && code < 0xa0) ||
                        (code >= 0x200b && code <= 0x200f) ||
                        (code >= 0x2028 && code <= 0x202e) ||
                        (code >= 0x2060 && code <= 0x206f) || code == 0xfeff;
  return character.is_valid && !controls;
}

/** Leaves out the middle. */
std::string
shortened(const std::string& text, std::size_t most)
{
  if (text.size() <= most)
    return text;
  return text.substr(0, most / 2) + " ... " + text.substr(text.size() - most / 2);
}

} // namespace

Character
characterAt(const std::string& text, std::size_t at)
{
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  if (first < 0x80)
    return {1, true, first};
  const std::size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() - at < size)
    return {};
  Character character{size, true, first & (0x7fu >> size)};
  for (std::size_t i = at + 1; i < at + size; ++i) {
    if ((byte(i) & 0xc0) != 0x80)
      return {};
    character.code = character.code << 6 | (byte(i) & 0x3f);
  }
  constexpr unsigned long least[] = {0, 0, 0x80, 0x800, 0x10000};
  if (character.code < least[size] || character.code > 0x10ffff ||
      (character.code >= 0xd800 && character.code < 0xe000))
    return {};
  return character;
}

std::string
printable(const std::string& text, std::size_t most)
{
  const std::string source = shortened(text, most);
  std::string line;
  for (std::size_t at = 0; at < source.size();) {
    const auto character = characterAt(source, at);
    if (isShown(character))
      line += source.substr(at, character.size);
    else if (character.code == '\n' || character.code == '\t')
      line += ' ';
    else
      for (std::size_t i = at; i < at + character.size; ++i) {
        char escaped[8];
        std::snprintf(escaped,
                      sizeof(escaped),
                      "\\x%02x",
                      static_cast<unsigned>(static_cast<unsigned char>(source[i])));
        line += escaped;
      }
    at += character.size;
  }
  return line;
}

std::string
fixedText(double value, int digits)
{
  char text[400]; // the largest double has 309 digits
  const auto end =
      std::to_chars(text, text + sizeof(text), value, std::chars_format::fixed, digits);
  return {text, end.ptr};
}

std::string
shortText(double value, int digits)
{
  char text[64];
  const auto end = std::to_chars(
      text, text + sizeof(text), value, std::chars_format::general, digits);
  return {text, end.ptr};
}

std::string
messageOf(const std::exception& error)
{
  if (const auto* of_pcl = dynamic_cast<const PCLException*>(&error))
    return plainMessage(*of_pcl);
  // a size that no memory has, either
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr ||
      dynamic_cast<const std::length_error*>(&error) != nullptr)
    return "There is not enough memory.";
  const std::string text = error.what();
  const auto end = text.find("] ");
  return text.rfind("[json.exception.", 0) == 0 && end != text.npos
             ? text.substr(end + 2)
             : text;
}

void
printComplaint(const std::string& program, const std::string& text)
{
  console::print_error("[%s] %s\n", program.c_str(), printable(text).c_str());
}

void
printWarning(const std::string& text)
{
  std::fprintf(stderr, "Warning: %s\n", printable(text).c_str());
}

} // namespace pcl::indoor::tool
