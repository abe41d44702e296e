// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_INTERNAL_NUMBERS_IN_MESSAGES_H
#define CGAL_GEODESIC_REMESHING_INTERNAL_NUMBERS_IN_MESSAGES_H

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace CGAL {
namespace Geodesic_remeshing {
namespace internal {

// Three digits, of any size
inline std::string short_number(double x)
{
  std::ostringstream out;
  out.precision(3);
  out << x;
  return out.str();
}

// Without a fraction
inline std::string whole_number(double x)
{
  return std::to_string(static_cast<long long>(std::llround((std::min)(x, 1e18))));
}

} // namespace internal
} // namespace Geodesic_remeshing
} // namespace CGAL

#endif // CGAL_GEODESIC_REMESHING_INTERNAL_NUMBERS_IN_MESSAGES_H
