/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief An entity of a STEP file, by its number. */
struct StepEntity {
  std::size_t number = 0; ///< 0 = none, $
};

/** \brief A text between quotes; what is not ASCII is encoded, bytes that are no UTF-8
 * become question marks. */
std::string
stepText(const std::string& utf8);

/** \brief A real number to a hundredth of a millimetre. */
std::string
stepReal(double value);

/** \brief "#12", or "$" of none. */
std::string
stepRef(StepEntity entity);

/** \brief "(#1,#2)" */
std::string
stepList(const std::vector<StepEntity>& entities);

/** \brief A GlobalId, between quotes: the same for the same name, 128 bits of it. */
std::string
stepGlobalId(const std::string& name);

/** \brief A file of ISO 10303-21 on its way. */
class StepFile {
public:
  /** \brief Add an entity.
   * \param[in] text for example "IFCDIRECTION((1.,0.))" */
  StepEntity
  add(const std::string& text);

  /** \brief The same, once for each text: entities without an identity of their own. */
  StepEntity
  share(const std::string& text);

  /** \brief The file.
   * \param[in] schema for example "IFC4"
   * \param[in] header the fields FILE_DESCRIPTION and FILE_NAME */
  std::string
  text(const std::string& schema, const std::string& header) const;

private:
  std::vector<std::string> entities_;
  std::map<std::string, StepEntity> shared_;
};

} // namespace pcl::indoor::tool
