// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

// No include guard on purpose: included by named_parameters.h with CGAL_add_named_parameter defined, once for each use
// of the names; goes through the names of CGAL and then through those of the package, and cleans up behind itself.

// CGAL's list knows a few further kinds of names. The first is a name like any other; the rest (the objects that
// Mesh_3 assigns to) are no functions with one value, and no use here.
#define CGAL_add_named_parameter_with_compatibility(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_named_parameter_with_compatibility_cref_only(X, Y, Z)
#define CGAL_add_named_parameter_with_compatibility_ref_only(X, Y, Z)
#define CGAL_add_extra_named_parameter_with_compatibility(X, Y, Z)

#include <CGAL/STL_Extension/internal/parameters_interface.h>

#include <CGAL/Geodesic_remeshing/internal/parameters_interface.h>

#undef CGAL_add_named_parameter
#undef CGAL_add_named_parameter_with_compatibility
#undef CGAL_add_named_parameter_with_compatibility_cref_only
#undef CGAL_add_named_parameter_with_compatibility_ref_only
#undef CGAL_add_extra_named_parameter_with_compatibility
