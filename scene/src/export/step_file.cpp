/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/step_file.h"

#include "files/digest.h"
#include "text/printable.h" // for fixedText

#include <cmath>
#include <cstdint>
#include <cstdio>

namespace pcl::indoor::tool {
namespace {

constexpr char32_t no_character = U'?';

/** The character that begins at a byte, and behind it the next one. */
char32_t
nextCharacter(const std::string& text, std::size_t& at)
{
  const auto byte = static_cast<unsigned char>(text[at++]);
  if (byte < 0x80)
    return byte;
  const std::size_t more = byte >= 0xf0 ? 3 : byte >= 0xe0 ? 2 : byte >= 0xc2 ? 1 : 0;
  if (more == 0 || byte > 0xf4 || at + more > text.size())
    return no_character;
  char32_t character = byte & (0x3f >> more);
  for (std::size_t i = 0; i < more; ++i) {
    const auto part = static_cast<unsigned char>(text[at + i]);
    if ((part & 0xc0) != 0x80)
      return no_character;
    character = character << 6 | (part & 0x3f);
  }
  at += more;
  return character <= 0x10ffff ? character : no_character;
}

std::string
encoded(char32_t character)
{
  if (character == U'\'')
    return "''";
  if (character == U'\\')
    return "\\\\";
  if (character < 0x20 || character == 0x7f)
    return "?";
  if (character < 0x7f)
    return std::string(1, static_cast<char>(character));
  char text[32];
  std::snprintf(text,
                sizeof(text),
                character > 0xffff ? "\\X4\\%08X\\X0\\" : "\\X2\\%04X\\X0\\",
                static_cast<unsigned>(character));
  return text;
}

} // namespace

std::string
stepText(const std::string& utf8)
{
  std::string text = "'";
  for (std::size_t at = 0; at < utf8.size();)
    text += encoded(nextCharacter(utf8, at));
  return text + "'";
}

std::string
stepReal(double value)
{
  const double steps = std::round(value * 1e5);
  auto number = fixedText(steps == 0.0 ? 0.0 : steps / 1e5, 5);
  number.erase(number.find_last_not_of('0') + 1);
  return number; // "1." is how STEP writes it
}

std::string
stepRef(StepEntity entity)
{
  return entity.number == 0 ? "$" : "#" + std::to_string(entity.number);
}

std::string
stepList(const std::vector<StepEntity>& entities)
{
  std::string list = "(";
  for (const auto& entity : entities)
    list += (list.size() > 1 ? "," : "") + stepRef(entity);
  return list + ")";
}

std::string
stepGlobalId(const std::string& name)
{
  constexpr char digits[] =
      "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$";
  std::uint64_t high = digestOf(name, 1), low = digestOf(name, 2);
  std::string id(22, '0'); // 2 bits, then 21 times 6
  for (std::size_t i = id.size(); i-- > 0;) {
    id[i] = digits[low & 63];
    low = low >> 6 | high << 58;
    high >>= 6;
  }
  return "'" + id + "'";
}

StepEntity
StepFile::add(const std::string& text)
{
  entities_.push_back(text);
  return {entities_.size()};
}

StepEntity
StepFile::share(const std::string& text)
{
  const auto known = shared_.find(text);
  if (known != shared_.end())
    return known->second;
  return shared_[text] = add(text);
}

std::string
StepFile::text(const std::string& schema, const std::string& header) const
{
  std::string text = "ISO-10303-21;\nHEADER;\n" + header + "FILE_SCHEMA(('" + schema +
                     "'));\nENDSEC;\nDATA;\n";
  for (std::size_t i = 0; i < entities_.size(); ++i)
    text += "#" + std::to_string(i + 1) + "=" + entities_[i] + ";\n";
  return text + "ENDSEC;\nEND-ISO-10303-21;\n";
}

} // namespace pcl::indoor::tool
