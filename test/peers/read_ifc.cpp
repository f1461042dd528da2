/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// read_ifc FILE.ifc: what IfcPlusPlus reads: a line with each class of entities and
// their number, and one per complaint.
#include <ifcpp/model/BuildingModel.h>
#include <ifcpp/model/BuildingObject.h>
#include <ifcpp/reader/ReaderSTEP.h>

#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <string>

namespace {

void
complain(void*, shared_ptr<StatusCallback::Message> message)
{
  const auto type = message->m_message_type;
  if (type == StatusCallback::MESSAGE_TYPE_ERROR ||
      type == StatusCallback::MESSAGE_TYPE_WARNING)
    std::wcout << L"COMPLAINT " << message->m_message_text << L"\n";
}

} // namespace

int
main(int, char** argv)
{
  std::ifstream stream(argv[1], std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(stream), {});
  auto model = std::make_shared<BuildingModel>();
  ReaderSTEP reader;
  reader.setMessageCallBack(nullptr, complain);
  reader.loadModelFromString(text, model);
  std::map<std::string, int> counts;
  for (const auto& [number, entity] : model->getMapIfcEntities())
    ++counts[entity->className()];
  for (const auto& [name, count] : counts)
    std::cout << name << " " << count << "\n";
}
