// Copyright (c) 2026 The authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Geodesic_remeshing authors

#ifndef CGAL_GEODESIC_REMESHING_VERSION_H
#define CGAL_GEODESIC_REMESHING_VERSION_H

/*!
 * \file CGAL/Geodesic_remeshing/version.h
 * The version of the package, for the preprocessor. CMake reads it from here.
 */

/*!
 * \ingroup PkgGeodesicRemeshingTypesRef
 * the version as a string, `"major.minor.patch"`.
 */
#define CGAL_GEODESIC_REMESHING_VERSION "0.1.0"

/*!
 * \ingroup PkgGeodesicRemeshingTypesRef
 * a version as a number that can be compared, in the manner of `CGAL_VERSION_NUMBER`.
 */
#define CGAL_GEODESIC_REMESHING_VERSION_NUMBER(major, minor, patch) (1000000 * (major) + 1000 * (minor) + (patch))

/*!
 * \ingroup PkgGeodesicRemeshingTypesRef
 * the version of the package as such a number.
 */
#define CGAL_GEODESIC_REMESHING_VERSION_NR CGAL_GEODESIC_REMESHING_VERSION_NUMBER(0, 1, 0)

#endif // CGAL_GEODESIC_REMESHING_VERSION_H
