/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "export/step_file.h"

#include "files/digest.h"
#include "text/formatted.h"
#include "text/printable.h" // for characterAt and fixedText

#include <cmath>
#include <cstdint>

namespace pcl::indoor::tool {
namespace {

std::string
encoded(const Character& character)
{
  const auto code = character.code;
  if (code == '\'')
    return "''";
  if (code == '\\')
    return "\\\\";
  if (!character.is_valid || code < 0x20 || code == 0x7f)
    return "?";
  if (code < 0x7f)
    return std::string(1, static_cast<char>(code));
  return formatted(code > 0xffff ? "\\X4\\%08lX\\X0\\" : "\\X2\\%04lX\\X0\\", code);
}

} // namespace

std::string
stepText(const std::string& utf8)
{
  std::string text = "'";
  for (std::size_t at = 0; at < utf8.size();) {
    const auto character = characterAt(utf8, at);
    text += encoded(character);
    at += character.size;
  }
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
