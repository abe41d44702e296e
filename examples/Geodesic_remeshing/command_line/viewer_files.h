// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_VIEWER_FILES_H
#define CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_VIEWER_FILES_H

#include <string>

namespace command_line {

// The page of --html before and after its data, made of the files in viewer/ when the program is built
std::string viewer_before_data();
std::string viewer_after_data();

} // namespace command_line

#endif // CGAL_GEODESIC_REMESHING_EXAMPLES_COMMAND_LINE_VIEWER_FILES_H
