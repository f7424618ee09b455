// SPDX-License-Identifier: BSD-3-Clause
#ifndef PropertyModels_h
#define PropertyModels_h

#include "DepthStatistics.h"

namespace hashedoctree
{
// The models that classes have as properties, with plain numbers for Python and XML, are cast to
// those of the core. Private to the module.

template <typename A, typename B>
constexpr bool AreSame(A a, B b)
{
  return static_cast<int>(a) == static_cast<int>(b);
}

/** Whether the models of a class have the numbers of the core's. */
template <typename Class>
constexpr bool HasModelsOfCore()
{
  return AreSame(Class::Leaves, FrequencyModel::Leaves) &&
    AreSame(Class::Points, FrequencyModel::Points) && AreSame(Class::Grid, FrequencyModel::Grid) &&
    AreSame(Class::Median, StartDepthModel::Median) &&
    AreSame(Class::Mean, StartDepthModel::Mean) && AreSame(Class::Root, StartDepthModel::Root) &&
    AreSame(Class::Fixed, StartDepthModel::Fixed);
}
}

#endif
