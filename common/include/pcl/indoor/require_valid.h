/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/exceptions.h>

#include <string>

namespace pcl::indoor {

/** \brief Refuse options or input that findProblem() finds fault with.
 * \param[in] wishes further arguments of its findProblem()
 * \return what was given
 * \throws pcl::BadArgumentException with the sentence of findProblem(), which is empty
 * where nothing is wrong
 */
template <typename Checked, typename... Wishes>
const Checked&
requireValid(const Checked& checked, Wishes... wishes)
{
  if (const std::string problem = findProblem(checked, wishes...); !problem.empty())
    PCL_THROW_EXCEPTION(BadArgumentException, problem);
  return checked;
}

} // namespace pcl::indoor
